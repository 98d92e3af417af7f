# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Where the energy of walks went."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .. import capi


@dataclass(frozen=True, eq=False)
class Ledger:
    """Sums of a batch's weights, three numbers (RGB) each, and numbers of walks. In every channel
    entered = reflected + escaped + absorbed + balance + capped + leaked + lost."""

    entered: NDArray[np.float64]
    reflected: NDArray[np.float64]
    """By the boundary, before entering (kind "refract")."""
    escaped: NDArray[np.float64]
    absorbed: NDArray[np.float64]
    """By sigma_a, in expectation at every scattering."""
    balance: NDArray[np.float64]
    """What roulette and the balance heuristic over channels removed (> 0) or added (< 0): zero on average."""
    capped: NDArray[np.float64]
    """Cut by max_scatterings, or trapped."""
    leaked: NDArray[np.float64]
    """Left through a hole; in a closed mesh with ior > 1 also, rarely, after a reflection at the very edge of two triangles,
    where rounding decides what is inside."""
    lost: NDArray[np.float64]
    """Numerically."""
    walks: int
    escaped_walks: int
    absorbed_walks: int
    capped_walks: int
    leaked_walks: int
    lost_walks: int
    reflected_walks: int
    scatterings: int
    """Scattering events of all walks."""

    @classmethod
    def of(cls, record: Any) -> Ledger:
        """The sums of a TynLedger."""
        sums = np.frombuffer(record, np.float64, 3 * len(_SUMS)).reshape(-1, 3).copy()
        counts = (getattr(record, name) for name in _COUNTS)
        return cls(*sums, *counts)


# The fields in the record's order, sums before numbers.
_SUMS = [field.name for field in fields(Ledger) if "walks" not in field.name and field.name != "scatterings"]
_COUNTS = [field.name for field in fields(Ledger)][len(_SUMS) :]
assert [*_SUMS, *_COUNTS] == [name for name, *_ in capi.TynLedger._fields_]
