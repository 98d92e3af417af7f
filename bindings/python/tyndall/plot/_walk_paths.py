# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""The points where walks scatter."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from .. import capi
from .._core.dtypes import WALK_ENTRY
from .._core.numbers import UINT32, integer
from .._scene.scene import Scene
from ..context import Context
from ..errors import InvalidArgumentError, InvalidOperationError


def walk_paths(
    scene: Scene, entries: Any, *, seed: int = 0, first_path: int = 0, max_scatterings: int = 100
) -> list[NDArray[np.float32]]:
    """The points that walks go through: the entry, every point where it scatters, and the point where it leaves the mesh. What
    a boundary reflects inside turns between two of them. A list of arrays, points x 3, scene units, one a walk.

    The library does not record paths: walks are done again and again with one scattering event more, which costs the square of
    their number. Roulette is off.

    scene: committed.
    entries: array of the type WALK_ENTRY, as `walk_entries` makes it.
    seed, first_path: as for `Context.walk`.
    max_scatterings: walks that are longer end there, >= 1.
    """
    if not isinstance(scene, Scene):
        raise InvalidArgumentError(f"scene is {scene!r}; it must be a tyndall.Scene")
    longest = integer(max_scatterings, "max_scatterings", 1, UINT32)
    given = np.atleast_1d(np.asarray(entries))
    if given.dtype != WALK_ENTRY:
        raise InvalidArgumentError("entries must be an array of the type WALK_ENTRY, as walk_entries makes it")
    given = given.reshape(-1)
    context = scene.context
    if not isinstance(context, Context):
        raise InvalidOperationError("the scene's context cannot walk")
    points = [[position.copy()] for position in given["position"]]
    alive = np.arange(len(given))
    for cap in range(1, longest + 1):
        exits = context.walk(
            scene, _numbered(given, alive), seed=seed, first_path=first_path, max_scatterings=cap, roulette=False
        )  # fmt: skip
        for walk, end in zip(alive, exits):
            if end["status"] in (capi.TYN_WALK_ESCAPED, capi.TYN_WALK_CAPPED, capi.TYN_WALK_ABSORBED):
                points[walk].append(end["position"].copy())
        alive = alive[exits["status"] == capi.TYN_WALK_CAPPED]
        if alive.size == 0:
            break
    return [np.array(one, np.float32) for one in points]


def _numbered(entries: NDArray[Any], chosen: NDArray[Any]) -> NDArray[Any]:
    """Some of the entries, which keep the random numbers that they have among all: those of
    its path + its place."""
    part: NDArray[Any] = entries[chosen]
    place = (chosen - np.arange(len(chosen))).astype(np.uint64)
    path: NDArray[np.uint64] = part["path"][:, 0] + (part["path"][:, 1].astype(np.uint64) << np.uint64(32)) + place
    part["path"][:, 0], part["path"][:, 1] = path & np.uint64(0xFFFFFFFF), path >> np.uint64(32)
    return part
