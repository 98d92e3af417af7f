# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Phase functions p(cos): the density per solid angle, 1/sr, of the direction after a scattering event, with cos the cosine
between the directions of travel before and after (1 is straight on). Their integral over the sphere is 1."""

from __future__ import annotations

import ctypes
import math
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .. import capi
from .._core.arrays import array, data, room
from .._core.numbers import UINT32, UINT64, integer, number, require, shaped
from .._core.status import error_of
from ..errors import InvalidArgumentError
from .mie import MIE_LARGEST, check_lognormal, mie, mie_cosines, mie_lognormal


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
        numbers = {"g": g, "g2": g2, "weight": weight, "alpha": alpha}
        self._record = capi.TynPhase(
            kind=integer(kind, "kind", 0, UINT32), **{name: number(value, name) for name, value in numbers.items()}
        )
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

    @classmethod
    def mie(cls, size_parameter: float, relative_index: complex, count: int = 2001) -> Phase:
        """Spheres of one size in unpolarized light (Lorenz-Mie): a table at `mie_cosines(size_parameter, count)`. count: its
        entries, 2 to 65536; the mean cosine of the default is right to 1e-4 up to a size parameter of 1000. The rest as for
        `mie()`."""
        cosines = mie_cosines(size_parameter, count)
        values = mie(size_parameter, relative_index, cosines).values
        assert values is not None
        return cls.tabulated(cosines, values)

    @classmethod
    def mie_lognormal(
        cls,
        median_radius: float,
        geometric_deviation: float,
        wavelength: float,
        relative_index: complex,
        count: int = 2001,
    ) -> Phase:
        """Spheres with log-normal radii in unpolarized light, each weighted by what it scatters: a table of `count` entries, 2
        to 65536, as dense as the larger spheres need. The rest as for `mie_lognormal()`."""
        check_lognormal(median_radius, geometric_deviation, wavelength)
        deviation = math.log(geometric_deviation)
        largest = 2 * math.pi * median_radius / wavelength * math.exp(2 * deviation**2 + 2 * deviation)
        cosines = mie_cosines(min(largest, MIE_LARGEST), count)
        values = mie_lognormal(median_radius, geometric_deviation, wavelength, relative_index, cosines).values
        assert values is not None
        return cls.tabulated(cosines, values)

    @property
    def name(self) -> str:
        """ "isotropic", "rayleigh", "henyey-greenstein", "two-lobe", "draine" or "tabulated"."""
        text: bytes = capi.lib.tyn_phase_name(self._record.kind)
        return text.decode()

    @property
    def mean_cosine(self) -> float:
        """The mean of cos, in [-1, 1]."""
        return self._mean_cosine

    def value(self, cosines: ArrayLike) -> Any:
        """p(cos), 1/sr, for cosines in [-1, 1]: an array of their shape, or a float for one."""
        return self._evaluated(capi.lib.tyn_phase_value, cosines)

    def pdf(self, cosines: ArrayLike) -> Any:
        """The density of `sample` with respect to cos, 2 pi p(cos), for cosines in [-1, 1]: an array of their shape, or a
        float for one."""
        return self._evaluated(capi.lib.tyn_phase_pdf, cosines)

    def sample(self, count: int, seed: int = 0, first: int = 0) -> NDArray[np.float64]:
        """`count` cosines drawn with the density `pdf`, by the code that the device runs, in single precision. Cosine i
        depends on seed and first + i alone, each in [0, 2^64)."""
        result = room((integer(count, "count", 0, UINT64),), "count", np.float64)
        numbers = integer(seed, "seed", 0, UINT64), integer(first, "first", 0, UINT64)
        _check(capi.lib.tyn_phase_sample(ctypes.byref(self._record), *numbers, len(result), data(result)))
        return result

    def moments(self, count: int) -> NDArray[np.float64]:
        """The Legendre moments 2 pi int p(cos) P_l(cos) d cos for l = 0 to count - 1: the first is 1, the second the mean
        cosine."""
        result = room((integer(count, "count", 0, UINT64),), "count", np.float64)
        _check(capi.lib.tyn_phase_moments(ctypes.byref(self._record), len(result), data(result)))
        return result

    @property
    def record(self) -> Any:
        """The TynPhase for calls of `tyndall.capi`; valid as long as this object."""
        return self._record

    def _ask_mean_cosine(self) -> float:
        result = ctypes.c_double()
        status = capi.lib.tyn_phase_mean_cosine(ctypes.byref(self._record), ctypes.byref(result))
        if status == capi.TYN_ERROR_INVALID_ARGUMENT:
            raise InvalidArgumentError(f"not a phase function: {self._described()}")
        _check(status)
        return result.value

    def _evaluated(self, function: Any, cosines: ArrayLike) -> Any:
        given = array(cosines, "cosines", np.float64)
        require(np.abs(given) <= 1, "cosines", given, "in [-1, 1]")
        result = np.empty(given.shape)
        _check(function(ctypes.byref(self._record), data(given), given.size, data(result)))
        return shaped(result)

    def _arguments(self) -> dict[str, Any]:
        """What makes the same phase function again."""
        one = self._record
        numbers = {"kind": one.kind, "g": one.g, "g2": one.g2, "weight": one.weight, "alpha": one.alpha}
        return {**numbers, **dict(zip(("cosines", "values"), (table.tolist() for table in self._table)))}

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Phase) and self._arguments() == other._arguments()

    def __hash__(self) -> int:
        return hash((self._record.kind, self._mean_cosine))

    def __reduce__(self) -> Any:
        return _phase_of, (self._arguments(),)

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


def _phase_of(arguments: dict[str, Any]) -> Phase:
    return Phase(**arguments)


def _check(status: int) -> None:
    if status != capi.TYN_OK:
        raise error_of(status, "")
