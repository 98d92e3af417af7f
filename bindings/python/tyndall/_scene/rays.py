# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Ray queries: what a ray meets first, and whether it meets anything."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .. import capi
from .._core.arrays import array, data, record_data, records, unmasked
from .._core.broadcast import filled, vectors
from .._core.context import ContextHandle
from .._core.dtypes import HIT, RAY
from ..errors import InvalidArgumentError
from .scene import Scene, mesh_choice, scene_of


def rays(origin: ArrayLike, direction: ArrayLike, *, t_min: ArrayLike = 0.0, t_max: ArrayLike = np.inf) -> NDArray[Any]:
    """Rays, an array of the type RAY. Arguments broadcast against one another over all axes but the last of origin and
    direction, and become float32.

    origin: x, y, z on the last axis, scene units.
    direction: x, y, z on the last axis, of unit length within 1e-3.
    t_min, t_max: the part of the ray that counts, origin + t direction; 0 <= t_min < t_max; t_max may be inf.
    """
    return filled(
        RAY,
        {
            "origin": vectors(origin, "origin"),
            "direction": vectors(direction, "direction"),
            "t_min": array(t_min, "t_min"),
            "t_max": array(t_max, "t_max"),
        },
    )


class RayCalls(ContextHandle):
    """The ray queries of a context."""

    def intersect(
        self,
        scene: Scene,
        rays: ArrayLike,
        direction: ArrayLike | None = None,
        *,
        t_min: ArrayLike = 0.0,
        t_max: ArrayLike = np.inf,
        mesh: int | None = None,
    ) -> NDArray[Any]:
        """The nearest hit of each ray, an array of the type HIT and of the rays' shape.

        Both sides of triangles are hit, the bounds t_min and t_max included. The test is watertight: no ray passes between two
        triangles that share an edge (Woop, Benthin, Wald 2013).

        scene: committed.
        rays: an array of the type RAY; or the rays' origins, and then direction, t_min and t_max as for `rays()`.
        mesh: index of the only mesh to look at; None: the whole scene.

        Errors: InvalidArgumentError (which ray, which field, its value), InvalidOperationError, OutOfMemoryError, DeviceError.
        """
        given = _rays(rays, direction, t_min, t_max)
        flat = records(given.reshape(-1), "rays", RAY)
        hits = np.empty(flat.shape, HIT)
        scene_of(self, scene)._call(
            capi.lib.tyn_intersect,
            scene.handle,
            mesh_choice(mesh),
            record_data(flat, capi.TynRay),
            len(flat),
            record_data(hits, capi.TynHit),
        )
        return hits.reshape(given.shape)

    def occluded(
        self,
        scene: Scene,
        rays: ArrayLike,
        direction: ArrayLike | None = None,
        *,
        t_min: ArrayLike = 0.0,
        t_max: ArrayLike = np.inf,
        mesh: int | None = None,
    ) -> NDArray[np.bool_]:
        """Whether each ray meets anything, bool, of the rays' shape. Arguments and errors as for `intersect`."""
        given = _rays(rays, direction, t_min, t_max)
        flat = records(given.reshape(-1), "rays", RAY)
        met = np.empty(flat.shape, np.uint32)
        scene_of(self, scene)._call(
            capi.lib.tyn_occluded,
            scene.handle,
            mesh_choice(mesh),
            record_data(flat, capi.TynRay),
            len(flat),
            data(met),
        )
        result: NDArray[np.bool_] = (met != 0).reshape(given.shape)
        return result


def _rays(given: ArrayLike, direction: ArrayLike | None, t_min: ArrayLike, t_max: ArrayLike) -> NDArray[Any]:
    found = unmasked(given, "rays")
    if found.dtype.names is None:
        if direction is None:
            raise InvalidArgumentError("rays must be an array of the type tyndall.RAY, or origins with a direction")
        return rays(given, direction, t_min=t_min, t_max=t_max)
    if direction is not None or np.ndim(t_min) > 0 or t_min != 0.0 or np.ndim(t_max) > 0 or t_max != np.inf:
        raise InvalidArgumentError("rays are records, which have their own direction, t_min and t_max: do not give these, too")
    return np.atleast_1d(found)
