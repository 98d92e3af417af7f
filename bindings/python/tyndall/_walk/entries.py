# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""What walks start from."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .._core.arrays import array, records
from .._core.broadcast import colors, filled, indices, vectors, words
from .._core.dtypes import HIT, NONE, RAY, WALK_ENTRY
from ..errors import InvalidArgumentError

_MEDIUMS_OWN = np.array([-1, 0, 0], np.float32)  # as albedo or sigma_t

KINDS = ("inside", "refract", "cosine")


def walk_entries(
    position: ArrayLike,
    direction: ArrayLike | None = None,
    *,
    kind: ArrayLike | None = None,
    mesh: ArrayLike = 0,
    triangle: ArrayLike | None = None,
    weight: ArrayLike = 1.0,
    albedo: ArrayLike | None = None,
    sigma_t: ArrayLike | None = None,
    medium: ArrayLike | None = None,
    roughness: ArrayLike = 0.0,
    path: ArrayLike = 0,
) -> NDArray[Any]:
    """Entries of walks, an array of the type WALK_ENTRY. Arguments broadcast against one another, over all axes but the last of
    those that hold vectors or channels, and become float32. A colour is a number, or has RGB or one number on its last axis.

    position: x, y, z on the last axis, scene units; on the triangle, or anywhere inside ("inside" without a triangle).
    direction: x, y, z on the last axis, of unit length within 1e-3; may be None for kind "cosine", where it is ignored.
    kind: a name or an array of them. "inside": the direction points into the medium, and the walk starts along it. "refract":
        it travels towards the surface from outside; Fresnel reflection is taken off the weight (the ledger's reflected), the
        rest is refracted. "cosine": a cosine-distributed direction about the inward normal is drawn. None: "cosine" without a
        direction, "refract" with a triangle, else "inside".
    mesh: index of the mesh whose inside is walked; it must have a medium, here or through `medium`.
    triangle: index, within the mesh, of the triangle on which the position lies; None: in the interior (only "inside").
    weight: colour that enters, >= 0.
    albedo: single-scattering albedo of this walk, a colour in [0, 1]; None: the medium's.
    sigma_t: extinction of this walk, a colour, 1/scene unit, >= 0; None: the medium's.
    medium: index of the medium; None: the mesh's.
    roughness: GGX alpha of the boundary seen from inside, [0, 1]; 0: smooth; ignored when index-matched.
    path: integers in [0, 2^64), added to first_path + the entry's place in the batch: chooses the random numbers.
    """
    if kind is None and direction is None and triangle is None:
        raise InvalidArgumentError('there is no direction: give one, or a triangle, for the kind "cosine"')
    if kind is None:
        kind = "cosine" if direction is None else "inside" if triangle is None else "refract"
    if direction is None and not np.all(np.asarray(kind) == "cosine"):
        raise InvalidArgumentError('direction is needed by walks of a kind other than "cosine"')
    return filled(
        WALK_ENTRY,
        {
            "position": vectors(position, "position"),
            "kind": _kinds(kind),
            "direction": np.zeros(3, np.float32) if direction is None else vectors(direction, "direction"),
            "mesh": indices(mesh, "mesh"),
            "weight": colors(weight, "weight"),
            "triangle": indices(triangle, "triangle"),
            "albedo": _MEDIUMS_OWN if albedo is None else _not_negative(colors(albedo, "albedo"), "albedo"),
            "medium": indices(medium, "medium"),
            "sigma_t": _MEDIUMS_OWN if sigma_t is None else _not_negative(colors(sigma_t, "sigma_t"), "sigma_t"),
            "roughness": array(roughness, "roughness"),
            "path": words(path, "path"),
        },
    )


def walk_entries_at(
    rays: ArrayLike, hits: ArrayLike, *, mesh: ArrayLike | None = None, **fields: Any
) -> tuple[NDArray[Any], NDArray[np.bool_]]:
    """Entries of the kind "refract" where rays meet meshes from outside: from camera rays to walks. Returns them and
    `entering`, bool, of the rays' shape: which rays they are of; `picture[entering] = exits["weight"]` puts results back.

    rays: an array of the type RAY. hits: what `Context.intersect` found, of the same shape.
    mesh: index of the only mesh to enter, or several; None: all, which must all have media then.
    fields: weight, albedo, sigma_t, medium, roughness and path as for `walk_entries`, for all entries alike or one each.
    """
    given, found = np.atleast_1d(np.asarray(rays)), np.atleast_1d(np.asarray(hits))
    if given.shape != found.shape:
        raise InvalidArgumentError(f"rays has the shape {given.shape} and hits {found.shape}; they must be the same")
    ray, hit = records(given.reshape(-1), "rays", RAY), records(found.reshape(-1), "hits", HIT)
    with np.errstate(invalid="ignore"):
        entering = (hit["mesh"] != NONE) & (np.einsum("ij,ij->i", ray["direction"], hit["normal"]) < 0)
    if mesh is not None:
        entering &= np.isin(hit["mesh"], indices(mesh, "mesh"))
    ray, hit = ray[entering], hit[entering]
    position = ray["origin"] + hit["t"][:, None].astype(np.float64) * ray["direction"]
    entries = walk_entries(
        position, ray["direction"], kind="refract", mesh=hit["mesh"], triangle=hit["triangle"], **fields
    )  # fmt: skip
    return entries, entering.reshape(given.shape)


def _kinds(kind: ArrayLike) -> NDArray[np.uint32]:
    names = np.asarray(kind)
    numbers = np.full(names.shape, NONE, np.uint32)
    for number, name in enumerate(KINDS):
        numbers[names == name] = number
    if np.any(numbers == NONE):
        wrong = names[numbers == NONE].reshape(-1)[0]
        allowed = ", ".join(f'"{name}"' for name in KINDS)
        raise InvalidArgumentError(f"kind is {wrong!r}; it must be one of {allowed}")
    return numbers


def _not_negative(values: NDArray[np.float32], name: str) -> NDArray[np.float32]:
    """A negative number would mean the medium's own."""
    if np.any(values < 0):
        raise InvalidArgumentError(f"{name} is {values.min():g}; it must be >= 0, or None for the medium's")
    return values
