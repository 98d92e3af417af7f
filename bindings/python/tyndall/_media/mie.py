# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Scattering by spheres: Lorenz-Mie theory (Bohren & Huffman 1983, chapter 4 and appendix A) and Rayleigh's limit of it.

Wavelengths are those in the surrounding medium. The relative index of refraction, of the sphere to that medium, is the complex
number n + ik: k > 0 absorbs. n > 0, k >= 0, and its magnitude is in [1e-3, 1e3].
"""

from __future__ import annotations

import ctypes
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .. import capi
from .._core.arrays import array, data
from .._core.numbers import broadcast, elementwise, integer, number, require
from .._core.status import error_of
from ..errors import InvalidArgumentError

MIE_LARGEST = 1e5
"""The largest size parameter."""


@dataclass(frozen=True, eq=False)
class Mie:
    """Scattering by one sphere. Efficiencies are cross-sections divided by the geometric one, pi radius^2."""

    q_ext: float
    """Extinction."""
    q_sca: float
    """Scattering."""
    q_abs: float
    """Absorption."""
    q_back: float
    """4 pi times the differential scattering cross-section at 180 degrees, divided by pi radius^2."""
    mean_cosine: float
    """Of the scattered light."""
    cosines: NDArray[np.float64] | None = None
    """What was asked for; else None."""
    values: NDArray[np.float64] | None = None
    """The phase function p at these cosines, of their shape, 1/sr, for unpolarized light."""


@dataclass(frozen=True, eq=False)
class MieCrossSections:
    """Means over spheres of many sizes, a particle, in the square of the unit of the radius: multiplied by the number of
    particles per volume they are coefficients."""

    extinction: float
    scattering: float
    absorption: float
    mean_cosine: float
    """Of the scattered light."""
    cosines: NDArray[np.float64] | None = None
    """What was asked for; else None."""
    values: NDArray[np.float64] | None = None
    """The phase function at these cosines, of their shape, 1/sr, weighted by scattering cross-section."""


def mie(size_parameter: float, relative_index: complex, cosines: ArrayLike | None = None) -> Mie:
    """Lorenz-Mie scattering by one sphere.

    size_parameter: 2 pi radius / wavelength, in (0, 1e5].
    relative_index: n + ik, see above. An index of 1 scatters nothing; its phase function is isotropic.
    cosines: where the phase function is wanted, in [-1, 1], of any shape; None: nowhere.

    Errors: InvalidArgumentError.
    """
    x = _size_parameter(size_parameter)
    index = _index(relative_index)
    directions, values = _directions(cosines)
    record = capi.TynMie()
    _check(capi.lib.tyn_mie(x, index, ctypes.byref(record), data(directions), _size(directions), data(values)))
    return Mie(record.q_ext, record.q_sca, record.q_abs, record.q_back, record.mean_cosine, directions, values)


def mie_lognormal(
    median_radius: float,
    geometric_deviation: float,
    wavelength: float,
    relative_index: complex,
    cosines: ArrayLike | None = None,
) -> MieCrossSections:
    """Scattering by spheres with log-normal radii: log(radius) is normal with mean log(median_radius) and standard deviation
    log(geometric_deviation). Right to 1e-6 where spheres are small; where they are large, to 1e-4 in the phase function. A
    wide distribution of large spheres takes many seconds.

    median_radius: length, > 0.
    geometric_deviation: in [1, 5]; 1: all alike. Size parameters that it reaches are at most 1e5.
    wavelength: in the surrounding medium, in the unit of the radius, > 0.
    relative_index: n + ik, see above.
    cosines: where the phase function is wanted, in [-1, 1], of any shape; None: nowhere.

    Errors: InvalidArgumentError.
    """
    check_lognormal(median_radius, geometric_deviation, wavelength)
    given = capi.TynMieDistribution(
        median_radius=median_radius,
        geometric_deviation=geometric_deviation,
        wavelength=wavelength,
        relative_index=_index(relative_index),
    )
    directions, values = _directions(cosines)
    record = capi.TynMieCrossSections()
    status = capi.lib.tyn_mie_lognormal(
        ctypes.byref(given), ctypes.byref(record), data(directions), _size(directions), data(values)
    )
    if status == capi.TYN_ERROR_INVALID_ARGUMENT:
        raise InvalidArgumentError(
            f"spheres of median radius {median_radius:g} and geometric deviation {geometric_deviation:g} reach size parameters"
            f" above {MIE_LARGEST:g} at the wavelength {wavelength:g}"
        )
    _check(status)
    return MieCrossSections(
        record.extinction, record.scattering, record.absorption, record.mean_cosine, directions, values
    )  # fmt: skip


def mie_cosines(size_parameter: float, count: int) -> NDArray[np.float64]:
    """Cosines for a table of the phase function of spheres up to `size_parameter`, in (0, 1e5]: `count`, 2 to 65536, increasing
    from -1 to 1, denser towards 1, where the diffraction peak is about 1 / size_parameter wide."""
    result = np.empty(integer(count, "count", 2, 65536))
    _check(capi.lib.tyn_mie_cosines(_size_parameter(size_parameter), len(result), data(result)))
    return result


def rayleigh_cross_section(radius: ArrayLike, wavelength: ArrayLike, relative_index: complex) -> Any:
    """Scattering cross-section of spheres much smaller than the wavelength, 8 pi / 3 (2 pi / wavelength)^4 radius^6
    |(m^2 - 1) / (m^2 + 2)|^2 (Bohren & Huffman 1983, eq. 5.8), in the square of the unit of `radius`.

    radius: length, >= 0. wavelength: in the surrounding medium, in the same unit, > 0. Both are broadcast against each other:
        the result is an array of that shape, or a float.
    relative_index: m = n + ik, see above.

    Errors: InvalidArgumentError, also where the cross-section is not finite.
    """
    index = _index(relative_index)
    arguments = broadcast({"radius": radius, "wavelength": wavelength})
    require((arguments[0] >= 0) & (arguments[0] < np.inf), "radius", arguments[0], ">= 0 and finite")
    _require_positive("wavelength", arguments[1])
    result = ctypes.c_double()

    def one(a: float, wave: float) -> float:
        if capi.lib.tyn_rayleigh_cross_section(a, wave, index, ctypes.byref(result)) != capi.TYN_OK:
            raise InvalidArgumentError(f"the cross-section at radius {a:g} and wavelength {wave:g} is not finite")
        return result.value

    return elementwise(one, arguments)


def check_lognormal(median_radius: float, geometric_deviation: float, wavelength: float) -> None:
    """InvalidArgumentError if there are no such spheres."""
    _require_positive("median_radius", number(median_radius, "median_radius"))
    deviation = number(geometric_deviation, "geometric_deviation")
    require(1 <= deviation <= 5, "geometric_deviation", deviation, "in [1, 5]")
    _require_positive("wavelength", number(wavelength, "wavelength"))


def _require_positive(name: str, values: Any) -> None:
    require((np.asarray(values) > 0) & (np.asarray(values) < np.inf), name, values, "> 0 and finite")


def _size_parameter(value: float) -> float:
    x = number(value, "size_parameter")
    require(0 < x <= MIE_LARGEST, "size_parameter", x, f"in (0, {MIE_LARGEST:g}]")
    return x


def _index(value: complex) -> Any:
    try:
        m = complex(value)
    except (TypeError, ValueError):
        raise InvalidArgumentError(f"relative_index is {value!r}; it must be a complex number n + ik") from None
    if not (m.real > 0 and m.imag >= 0 and 1e-3 <= abs(m) <= 1e3):
        raise InvalidArgumentError(
            f"relative_index is {m}; it must be n + ik with n > 0, k >= 0 (k > 0 absorbs) and a magnitude in [1e-3, 1e3]"
        )
    return (ctypes.c_double * 2)(m.real, m.imag)


def _directions(cosines: ArrayLike | None) -> tuple[NDArray[np.float64] | None, NDArray[np.float64] | None]:
    """A copy of the cosines, and room for as many values."""
    if cosines is None:
        return None, None
    given = np.array(array(cosines, "cosines", np.float64))
    require(np.abs(given) <= 1, "cosines", given, "in [-1, 1]")
    return given, np.empty(given.shape)


def _size(values: NDArray[np.float64] | None) -> int:
    return 0 if values is None else values.size


def _check(status: int) -> None:
    if status != capi.TYN_OK:
        raise error_of(status, "")
