# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Exact results of plane-parallel transport, on the host in double precision: adding-doubling for layered slabs, the
half-space of Chandrasekhar, and the closed forms of Hanrahan's lecture on participating media (CS348B, 2005).

mu is the cosine of the angle from the normal, in (0, 1]; tau an optical depth; albedo the single-scattering albedo
sigma_s / sigma_t, in [0, 1]. Arguments are numbers or arrays, which are broadcast against one another: the result is an array
of their common shape, or a float. InvalidArgumentError for values out of range.
"""

from __future__ import annotations

import ctypes
import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, Callable, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import capi
from ._core.arrays import array, data
from ._core.choices import choice
from ._core.numbers import broadcast, elementwise, integer, number, require, shaped
from ._core.status import error_of
from ._media.phase import Phase
from ._slab.layers import INCIDENCES, Layers, slab_record
from .errors import InvalidArgumentError

_MESSAGE_BYTES = 1024


class SingleScattering(NamedTuple):
    """Single scattering of a layer."""

    brdf: Any
    """1/sr, back to where the light comes from; an array or a float."""
    btdf: Any
    """1/sr, through the layer; an array or a float."""


@dataclass(frozen=True, eq=False)
class AddingDoubling:
    """Fractions of the light that arrives, one a channel, by adding-doubling."""

    reflectance: NDArray[np.float64]
    """All that comes back, unscattered light included."""
    transmittance: NDArray[np.float64]
    """All that goes through."""
    absorbed: NDArray[np.float64]
    """The rest."""
    specular_reflectance: NDArray[np.float64]
    """Comes back unscattered."""
    direct_transmittance: NDArray[np.float64]
    """Goes through unscattered."""
    accuracy: NDArray[np.float64]
    """Reached: the larger change of reflectance and transmittance from the last refinement of the quadrature. Above the
    tolerance if max_nodes did not suffice."""
    nodes: NDArray[np.uint32]
    """Of the quadrature that was used."""
    cosines: NDArray[np.float64] | None = None
    """What was asked for; else None."""
    reflected: NDArray[np.float64] | None = None
    """Scattered light per solid angle in the medium above, 1/sr: BRDF times cosine, mean over azimuth; cosines x channels."""
    transmitted: NDArray[np.float64] | None = None
    """The same in the medium below; 0 below an infinite layer. The sharpest part of a forward peak, which delta-M takes for
    unscattered, is missing."""


def reduced_intensity(tau: ArrayLike, mu: ArrayLike) -> Any:
    """The fraction of light that reaches optical depth tau >= 0 along a direction of cosine mu without an event,
    exp(-tau / mu)."""
    return _closed_form(capi.lib.tyn_reduced_intensity, {"tau": tau, "mu": mu}, "tau must be >= 0, mu in (0, 1]")


def effective_source(albedo: ArrayLike, phase: ArrayLike, tau: ArrayLike, mu_i: ArrayLike) -> Any:
    """Radiance scattered once per optical depth into a direction at optical depth tau, for a collimated beam of unit irradiance
    across itself that entered along mu_i: albedo phase exp(-tau / mu_i), 1/sr. phase: p(cos) between the two, 1/sr, >= 0."""
    arguments = {"albedo": albedo, "phase": phase, "tau": tau, "mu_i": mu_i}
    allowed = "albedo must be in [0, 1], phase >= 0 and finite, tau >= 0, mu_i in (0, 1]"
    return _closed_form(capi.lib.tyn_effective_source, arguments, allowed)


def seeliger_brdf(albedo: ArrayLike, phase: ArrayLike, mu_i: ArrayLike, mu_o: ArrayLike) -> Any:
    """BRDF of single scattering in an index-matched half-space, albedo phase / (mu_i + mu_o), 1/sr (Seeliger 1887). phase:
    p(cos), 1/sr, >= 0."""
    arguments = {"albedo": albedo, "phase": phase, "mu_i": mu_i, "mu_o": mu_o}
    allowed = "albedo must be in [0, 1], phase >= 0 and finite, mu_i and mu_o in (0, 1]"
    return _closed_form(capi.lib.tyn_seeliger_brdf, arguments, allowed)


def hanrahan_krueger(
    albedo: ArrayLike,
    mu_i: ArrayLike,
    mu_o: ArrayLike,
    azimuth: ArrayLike = 0.0,
    *,
    optical_thickness: ArrayLike = math.inf,
    ior: ArrayLike = 1.0,
    phase: Phase | None = None,
) -> SingleScattering:
    """BRDF and BTDF of single scattering in a layer with Fresnel boundaries and the same medium on both sides, without light
    that boundaries reflect back inside (Hanrahan & Krueger 1993, the first-order terms).

    mu_i, mu_o: cosines outside, of the directions to the light and to the viewer, who is above for the BRDF, below for the
        BTDF; in (0, 1].
    azimuth: between the two, radians; 0: light and viewer are on the same side of the normal.
    optical_thickness: sigma_t times thickness, > 0; inf: a half-space.
    ior: index of refraction of the layer relative to outside, [1, 4].
    phase: None: isotropic.
    """
    arguments = broadcast(
        {
            "albedo": albedo, "mu_i": mu_i, "mu_o": mu_o, "azimuth": azimuth, "optical_thickness": optical_thickness,
            "ior": ior,
        }
    )  # fmt: skip
    w, light, viewer, angle, thickness, index = arguments
    _require_albedo(w)
    _require_cosine("mu_i", light)
    _require_cosine("mu_o", viewer)
    require(np.isfinite(angle), "azimuth", angle, "finite")
    require(thickness > 0, "optical_thickness", thickness, "> 0")
    require((index >= 1) & (index <= 4), "ior", index, "in [1, 4]")
    layer = capi.TynSingleScattering()
    if phase is not None:
        layer.phase = ctypes.pointer(phase.record)
    brdf, btdf = np.empty(w.shape), np.empty(w.shape)
    back, through = ctypes.c_double(), ctypes.c_double()
    for place, numbers in enumerate(zip(*(one.ravel().tolist() for one in arguments))):
        layer.albedo, *directions, layer.optical_thickness, layer.ior = numbers
        _check(capi.lib.tyn_hanrahan_krueger(ctypes.byref(layer), *directions, ctypes.byref(back), ctypes.byref(through)))
        brdf.flat[place], btdf.flat[place] = back.value, through.value
    return SingleScattering(shaped(brdf), shaped(btdf))


def chandrasekhar_h(albedo: ArrayLike, mu: ArrayLike) -> Any:
    """H(mu) for isotropic scattering, mu in [0, 1]: H = 1 + mu H(mu) albedo/2 int_0^1 H(x) / (mu + x) dx (Chandrasekhar 1950,
    chapter V), to 1e-12."""
    w, cosine = broadcast({"albedo": albedo, "mu": mu})
    _require_albedo(w)
    require((cosine >= 0) & (cosine <= 1), "mu", cosine, "in [0, 1]")
    result = np.empty(w.shape)
    for (one,), places in _alike(w):
        result.flat[places] = _batch(capi.lib.tyn_chandrasekhar_h, one, values=cosine.ravel()[places])
    return shaped(result)


def half_space_brdf(albedo: ArrayLike, mu_i: ArrayLike, mu_o: ArrayLike) -> Any:
    """BRDF of the index-matched, isotropically scattering half-space, all orders: albedo / (4 pi) H(mu_i) H(mu_o) /
    (mu_i + mu_o), 1/sr (Chandrasekhar 1950, chapter III)."""
    w, light, viewer = broadcast({"albedo": albedo, "mu_i": mu_i, "mu_o": mu_o})
    _require_albedo(w)
    _require_cosine("mu_i", light)
    _require_cosine("mu_o", viewer)
    result = np.empty(w.shape)
    for pair, places in _alike(w, light):
        result.flat[places] = _batch(capi.lib.tyn_half_space_brdf, *pair, values=viewer.ravel()[places])
    return shaped(result)


def half_space_albedo(albedo: ArrayLike, mu: ArrayLike) -> Any:
    """Directional albedo of the index-matched, isotropically scattering half-space, 1 - H(mu) sqrt(1 - albedo)."""
    w, cosine = broadcast({"albedo": albedo, "mu": mu})
    _require_albedo(w)
    _require_cosine("mu", cosine)
    result = ctypes.c_double()

    def one(*numbers: float) -> float:
        _check(capi.lib.tyn_half_space_albedo(*numbers, ctypes.byref(result)))
        return result.value

    return elementwise(one, [w, cosine])


def adding_doubling(
    layers: Layers,
    *,
    ior_above: float = 1.0,
    ior_below: float = 1.0,
    incidence: str = "collimated",
    angle: float = 0.0,
    tolerance: float = 1e-6,
    max_nodes: int = 192,
    cosines: ArrayLike | None = None,
) -> AddingDoubling:
    """Reflectance and transmittance of a slab by adding and doubling (van de Hulst 1980; Prahl 1995), with delta-M scaling of
    the phase function (Wiscombe 1977) where its Legendre series is longer than the quadrature resolves. All channels, one
    after the other.

    layers: a stack from the top; a medium alone is a half-space.
    ior_above, ior_below: index of refraction around the slab, [1, 4]; below an infinite layer without effect.
    incidence: "collimated", or "diffuse": radiance equal from everywhere above.
    angle: of collimated light, from the normal, in the medium above, radians, [0, pi/2).
    tolerance: wanted accuracy of the totals, [1e-10, 0.1]; angular output changes by less than 10 times that.
    max_nodes: most nodes of the quadrature, 8 to 512. More are tried until the tolerance is met.
    cosines: where the angular output is wanted, one-dimensional, in (0, 1]; None: nowhere.

    Errors: InvalidArgumentError, OutOfMemoryError.
    """
    slab = slab_record(layers, number(ior_above, "ior_above"), number(ior_below, "ior_below"))
    options = capi.TynAddingDoublingOptions(
        incidence=choice(incidence, "incidence", INCIDENCES),
        angle=number(angle, "angle"),
        tolerance=number(tolerance, "tolerance"),
        max_nodes=integer(max_nodes, "max_nodes", 8, 512),
    )
    if cosines is None:
        return AddingDoubling(**_totals([_solved(slab, options, channel) for channel in range(slab.channel_count)]))
    directions = np.array(array(cosines, "cosines", np.float64, (None,)))
    options.cosines, options.cosine_count = data(directions), directions.size
    reflected = np.empty((slab.channel_count, directions.size))
    transmitted = np.empty_like(reflected)
    solved = [_solved(slab, options, *row) for row in zip(range(slab.channel_count), reflected, transmitted)]
    return AddingDoubling(
        **_totals(solved), cosines=directions, reflected=np.array(reflected.T, order="C"),
        transmitted=np.array(transmitted.T, order="C"),
    )  # fmt: skip


def _solved(slab: Any, options: Any, channel: int, reflected: Any = None, transmitted: Any = None) -> Any:
    """The TynAddingDoublingResult of one channel."""
    options.channel = channel
    result = capi.TynAddingDoublingResult()
    message = ctypes.create_string_buffer(_MESSAGE_BYTES)
    status = capi.lib.tyn_adding_doubling(
        ctypes.byref(slab), ctypes.byref(options), ctypes.byref(result), data(reflected), data(transmitted), message,
        _MESSAGE_BYTES,
    )  # fmt: skip
    if status != capi.TYN_OK:
        raise error_of(status, message.value.decode(errors="replace"))
    return result


def _totals(solved: list[Any]) -> dict[str, Any]:
    names = (
        "reflectance", "transmittance", "absorbed", "specular_reflectance", "direct_transmittance", "accuracy",
    )  # fmt: skip
    totals: dict[str, Any] = {name: np.array([getattr(one, name) for one in solved]) for name in names}
    return {**totals, "nodes": np.array([one.nodes for one in solved], np.uint32)}


def _closed_form(function: Callable[..., float], arguments: dict[str, ArrayLike], allowed: str) -> Any:
    """`function` of every element; it is NaN where they are out of range."""

    def one(*numbers: float) -> float:
        value = function(*numbers)
        if math.isnan(value):
            shown = ", ".join(f"{name} is {given:g}" for name, given in zip(arguments, numbers))
            raise InvalidArgumentError(f"{shown}: {allowed}")
        return value

    return elementwise(one, broadcast(arguments))


def _alike(*keys: NDArray[np.float64]) -> Iterator[tuple[list[float], Any]]:
    """Each different row of numbers at the same place of the keys, with the places, as a flat index, that have it."""
    if keys[0].size == 0:
        return
    first = [float(key.flat[0]) for key in keys]
    if all(np.all(key == number) for key, number in zip(keys, first)):
        yield first, slice(None)
        return
    table = np.stack([key.ravel() for key in keys], axis=1)
    rows, inverse, counts = np.unique(table, axis=0, return_inverse=True, return_counts=True)
    order = np.argsort(inverse.ravel(), kind="stable")
    yield from zip(rows.tolist(), np.split(order, np.cumsum(counts)[:-1]))


def _batch(function: Any, *numbers: float, values: NDArray[np.float64]) -> NDArray[np.float64]:
    result = np.empty(values.shape)
    _check(function(*numbers, data(values), values.size, data(result)))
    return result


def _require_albedo(values: NDArray[np.float64]) -> None:
    require((values >= 0) & (values <= 1), "albedo", values, "in [0, 1]")


def _require_cosine(name: str, values: NDArray[np.float64]) -> None:
    require((values > 0) & (values <= 1), name, values, "in (0, 1]")


def _check(status: int) -> None:
    if status != capi.TYN_OK:
        raise error_of(status, "")
