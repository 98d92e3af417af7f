# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""The records of the batch calls as numpy types: arrays of them go to the library and come back without a copy."""

from __future__ import annotations

from typing import Any

import numpy as np

from .. import capi

NONE: int = capi.TYN_NONE
"""No such index: `mesh` and `triangle` of a ray that hit nothing, `medium` of an entry that takes the mesh's."""

RAY: np.dtype[Any] = np.dtype(capi.TynRay)
"""A ray, origin + t direction with t in [t_min, t_max]: origin (3, length), t_min (>= 0), direction (3, unit), t_max
(> t_min; inf is allowed)."""

HIT: np.dtype[Any] = np.dtype(capi.TynHit)
"""Where a ray meets a mesh first: t (distance in units of the direction's length; inf at a miss), u and v (barycentric: the
point is (1-u-v) p0 + u p1 + v p2), mesh and triangle (NONE at a miss), normal (3, unit, geometric, outside)."""

WALK_ENTRY: np.dtype[Any] = np.dtype(capi.TynWalkEntry)
"""What a walk starts from; `walk_entries` makes them and says what the fields mean."""

WALK_EXIT: np.dtype[Any] = np.dtype(capi.TynWalkExit)
"""Where and how a walk ended; see `Exits`."""
