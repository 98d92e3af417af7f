# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Phase functions p(cos): the density per solid angle, 1/sr, of the direction after a scattering event, with cos the cosine
between the directions of travel before and after (1 is straight on). Their integral over the sphere is 1."""

from __future__ import annotations

import ctypes
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import capi
from ._arrays import array, data
from .errors import InvalidArgumentError, error_of


class Phase:
    """A phase function, made by one of the class methods. It never changes."""

    def __init__(
        self,
        kind: int,
        *,
        g: float = 0.0,
        g2: float = 0.0,
        weight: float = 1.0,
        alpha: float = 0.0,
        cosines: ArrayLike | None = None,
        values: ArrayLike | None = None,
    ) -> None:
        """A phase function by the number of its kind, capi.TYN_PHASE_*; the class methods are the usual way."""
        self._record = capi.TynPhase(kind=kind, g=float(g), g2=float(g2), weight=float(weight), alpha=float(alpha))
        self._table: tuple[NDArray[np.float64], ...] = ()
        if kind == capi.TYN_PHASE_TABULATED:
            table = array([] if cosines is None else cosines, "cosines", np.float64, (None,)).copy()
            heights = array([] if values is None else values, "values", np.float64, (len(table),)).copy()
            self._table = (table, heights)
            self._record.cosines, self._record.values, self._record.count = data(table), data(heights), len(table)
        self._mean_cosine = self._ask_mean_cosine()

    @classmethod
    def isotropic(cls) -> Phase:
        """1 / (4 pi)."""
        return cls(capi.TYN_PHASE_ISOTROPIC)

    @classmethod
    def rayleigh(cls) -> Phase:
        """3 / (16 pi) (1 + cos^2) (Rayleigh 1871)."""
        return cls(capi.TYN_PHASE_RAYLEIGH)

    @classmethod
    def henyey_greenstein(cls, g: float) -> Phase:
        """(1 - g^2) / (4 pi (1 + g^2 - 2 g cos)^(3/2)) (Henyey & Greenstein 1941). g: mean cosine, in (-1, 1)."""
        return cls(capi.TYN_PHASE_HENYEY_GREENSTEIN, g=g)

    @classmethod
    def two_lobe(cls, g: float, g2: float, weight: float) -> Phase:
        """weight HG(g) + (1 - weight) HG(g2). g, g2: in (-1, 1); weight: in [0, 1]."""
        return cls(capi.TYN_PHASE_TWO_LOBE, g=g, g2=g2, weight=weight)

    @classmethod
    def draine(cls, g: float, alpha: float) -> Phase:
        """HG(g) (1 + alpha cos^2) / (1 + alpha (1 + 2 g^2) / 3) (Draine 2003, eq. 4). g: in (-1, 1); alpha: in [0, 1e6], 0 is
        Henyey-Greenstein, 1 with g = 0 Rayleigh, 1 Cornette & Shanks 1992."""
        return cls(capi.TYN_PHASE_DRAINE, g=g, alpha=alpha)

    @classmethod
    def tabulated(cls, cosines: ArrayLike, values: ArrayLike) -> Phase:
        """Linear in cos between the entries of a table, which is normalized. cosines: 2 to 65536, strictly increasing from -1
        to 1; values: as many, >= 0, in any scale."""
        return cls(capi.TYN_PHASE_TABULATED, cosines=cosines, values=values)

    @property
    def name(self) -> str:
        """ "isotropic", "rayleigh", "henyey-greenstein", "two-lobe", "draine" or "tabulated"."""
        text: bytes = capi.lib.tyn_phase_name(self._record.kind)
        return text.decode()

    @property
    def mean_cosine(self) -> float:
        """The mean of cos, in [-1, 1]."""
        return self._mean_cosine

    @property
    def record(self) -> Any:
        """The TynPhase for calls of `tyndall.capi`; valid as long as this object."""
        return self._record

    def _ask_mean_cosine(self) -> float:
        result = ctypes.c_double()
        status = capi.lib.tyn_phase_mean_cosine(ctypes.byref(self._record), ctypes.byref(result))
        if status == capi.TYN_ERROR_INVALID_ARGUMENT:
            raise InvalidArgumentError(f"not a phase function: {self._described()}")
        if status != capi.TYN_OK:
            raise error_of(status, "")
        return result.value

    def _described(self) -> str:
        one = self._record
        if self._table:
            return f"a table of {len(self._table[0])} cosines, which must increase from -1 to 1, and values >= 0"
        return (
            f"kind {one.kind} of 0 to {capi.TYN_PHASE_KIND_COUNT - 1}, g {one.g:g} and g2 {one.g2:g} in (-1, 1),"
            f" weight {one.weight:g} in [0, 1], alpha {one.alpha:g} in [0, 1e6]"
        )

    def __repr__(self) -> str:
        return f"<tyndall.Phase {self.name}, mean cosine {self.mean_cosine:.4g}>"
