# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Where walks ended."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from .. import capi
from .._core.choices import choice
from .._core.dtypes import WALK_EXIT
from .ledger import Ledger

STATUSES = {
    "escaped": capi.TYN_WALK_ESCAPED,
    "absorbed": capi.TYN_WALK_ABSORBED,
    "capped": capi.TYN_WALK_CAPPED,
    "leaked": capi.TYN_WALK_LEAKED,
    "lost": capi.TYN_WALK_LOST,
    "reflected": capi.TYN_WALK_REFLECTED,
}


class Exits(np.ndarray[Any, np.dtype[Any]]):
    """Where and how walks ended: an array of the type WALK_EXIT, one record a walk, in the order of the entries.

    position (3, scene units), direction (3, unit, outside) and weight (3, RGB that leaves; at most 3 times what entered) are
    those with which it left, if it escaped; otherwise the last known ones. status: see `ended`. triangle: of the mesh, that was
    crossed; NONE if none. u, v: barycentric there. scatterings: number of events. path_length: total, inside, scene units.
    geometric_normal and shading_normal: 3, unit, outside. uv: 2, texture coordinates; 0 0 if the mesh has none.
    """

    ledger: Ledger | None
    """Where the energy went, of what a call returned as a whole; None for slices and copies of it."""

    def __array_finalize__(self, source: Any) -> None:
        self.ledger = None

    def __getitem__(self, key: Any) -> Any:
        part = super().__getitem__(key)
        return part.view(np.ndarray) if isinstance(part, Exits) and part.dtype != WALK_EXIT else part

    @property
    def escaped(self) -> NDArray[np.bool_]:
        """Which walks left through the boundary: their position, direction and weight are those of light that comes out."""
        return self.ended("escaped")

    def ended(self, status: str) -> NDArray[np.bool_]:
        """Which walks ended in this way. "escaped": left through the boundary. "absorbed": by roulette, or the weight reached
        exactly 0. "capped": reached max_scatterings, or is trapped by total reflection. "leaked": left the bounds of the mesh
        without crossing a triangle, through a hole; or, rarely, in a closed mesh with ior > 1, after a reflection at the very
        edge of two triangles, where rounding decides what is inside. "lost": a number became NaN or infinite. "reflected": of
        kind "refract", and nothing was transmitted."""
        mask: NDArray[np.bool_] = self["status"] == choice(status, "status", STATUSES)
        return mask


def room_for(count: int) -> Exits:
    """Exits that a call will fill."""
    return np.empty(count, WALK_EXIT).view(Exits)
