# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Exact transport in half-spaces and layered slabs, by Monte Carlo."""

from __future__ import annotations

import ctypes
from typing import Any

from .. import capi
from .._core.arrays import data
from .._core.choices import choice
from .._core.context import ContextHandle
from .._core.numbers import UINT32, UINT64, integer, number
from .._core.progress import LongCall, Progress
from ..errors import CancelledError, InvalidArgumentError
from .layers import INCIDENCES, Layers, slab_record, stack
from .reading import read_slab_result
from .results import SlabResult
from .sweep import Sweep, sweep_coefficients

_BEAMS = {"pencil": capi.TYN_BEAM_PENCIL, "disc": capi.TYN_BEAM_DISC, "gaussian": capi.TYN_BEAM_GAUSSIAN}
_MOST_BINS = 1000000
_MOST_PHOTONS = 10**15
_DEFAULT_PHOTONS = 1000000


class SlabCalls(ContextHandle):
    """The calls of a context on slabs."""

    def slab(
        self,
        layers: Layers,
        *,
        photons: float | None = None,
        ior_above: float = 1.0,
        ior_below: float = 1.0,
        incidence: str = "collimated",
        angle: float = 0.0,
        beam: str = "pencil",
        beam_radius: float | None = None,
        seconds: float | None = None,
        target_error: float | None = None,
        seed: int = 0,
        max_order: int | None = None,
        roulette_threshold: float = 0.1,
        radial: tuple[float, int] | None = None,
        angular: int | None = None,
        radial_angular: bool = False,
        depth: tuple[float, int] | None = None,
        orders: int | None = None,
        path: tuple[float, int] | None = None,
        sweep: Sweep | None = None,
        progress: Progress = None,
    ) -> SlabResult:
        """Walks photons through a stack of plane layers between two half-spaces. Light comes from above at the origin. Each
        channel has photons of its own, with the same random numbers. The same arguments and number of photons on the same
        device give the same bits; a longer run begins with the photons of a shorter one.

        layers: from the top, in the unit of their media's coefficients; a medium alone is a half-space.
        photons: a channel, at most 1e15. None: 1e6, or no limit if there is another one; 0: no limit.
        ior_above, ior_below: index of refraction around the slab, [1, 4]; below an infinite layer without effect.
        incidence: "collimated", or "diffuse": radiance equal from everywhere above.
        angle: of collimated light, from the normal, in the medium above, radians, [0, pi/2).
        beam: "pencil", at the origin; "disc", uniform over the radius beam_radius; "gaussian", with the density
            exp(-2 r^2 / beam_radius^2).
        beam_radius: of a disc or Gaussian, length, > 0.
        seconds: wall-clock limit, > 0; None: none.
        target_error: ends the run when the standard errors of the total reflectance and transmittance of every channel are
            below it, > 0; None: none. It is looked at at fixed photon counts.
        seed: chooses the random numbers, [0, 2^64).
        max_order: walks end when they would scatter once more, >= 1; None: no limit.
        roulette_threshold: walks whose weight falls below it play Russian roulette, (0, 1].
        radial: (largest radius, number of bins): R(r) and T(r) in equal steps from 0. Bins of each kind: at most 1e6.
        angular: number of bins: by angle from the normal in equal steps from 0 to pi/2.
        radial_angular: by radius and angle too, over the bins of both.
        depth: (largest depth, number of bins): absorption and fluence.
        orders: number of scattering orders, from 0.
        path: (largest length, number of bins): by the length of the path inside.
        sweep: other media that the same photons answer for, at most 4096: stacks that differ from `layers` in sigma_a and
            sigma_s alone (media stand for layers of the slab's thickness), or a pair of arrays of these, rows x layers, for
            all channels. Each needs sigma_s at most the slab's and sigma_a + sigma_s at least the slab's. Not with max_order.
        progress: True for a bar, or a function of the fraction done, which cancels by returning something true. Walks that
            are started are finished first, which takes long where they have millions of events (a thick white slab).

        Depths are resolved to 2^-24 of their value and 1 - albedo to 2^-32, as the device works in single precision.
        Errors: InvalidArgumentError (also for a half-space with 1 - albedo below 1e-7 without max_order, whose walks would go
        on for ever, and more than 2^22 bins a channel or 2^23 in all: those of reflectance and transmittance each, those of
        depth in every layer), OutOfMemoryError, DeviceError, KernelBuildError, CancelledError, whose `result` is the
        SlabResult of what was done.
        """
        found = stack(layers)
        slab = slab_record(found, ior_above, ior_below)
        options = capi.TynSlabOptions(
            incidence=choice(incidence, "incidence", INCIDENCES),
            angle=number(angle, "angle"),
            beam=choice(beam, "beam", _BEAMS),
            beam_radius=_limit(beam_radius, "beam_radius"),
            photons=_photons(photons, seconds, target_error),
            seconds=_limit(seconds, "seconds"),
            target_error=_limit(target_error, "target_error"),
            seed=integer(seed, "seed", 0, UINT64),
            max_order=0 if max_order is None else integer(max_order, "max_order", 1, UINT32),
            roulette_threshold=number(roulette_threshold, "roulette_threshold"),
            angular_bins=_bins(angular, "angular"),
            radial_angular=int(bool(radial_angular)),
            order_bins=_bins(orders, "orders"),
        )
        options.radial_max, options.radial_bins = _axis(radial, "radial")
        options.depth_max, options.depth_bins = _axis(depth, "depth")
        options.path_max, options.path_bins = _axis(path, "path")
        media = None if sweep is None else sweep_coefficients(sweep, found)
        if media is not None:
            options.sweep_count = len(media[0])
            options.sweep_sigma_a, options.sweep_sigma_s = data(media[0]), data(media[1])
        return self._slab_run(slab, options, media, progress)

    def _slab_run(self, slab: Any, options: Any, media: Any, progress: Progress) -> SlabResult:
        result = ctypes.POINTER(capi.TynSlabResult)()
        arguments = self.handle, ctypes.byref(slab), ctypes.byref(options), ctypes.byref(result)
        try:
            with LongCall(progress, "slab") as call:
                options.progress = call.callback
                try:
                    self._call(capi.lib.tyn_slab_simulate, *arguments)
                except CancelledError as error:
                    error.result = read_slab_result(result, options, media)
                    raise
            return read_slab_result(result, options, media)
        finally:
            capi.lib.tyn_slab_result_release(result)


def _photons(photons: float | None, seconds: float | None, target_error: float | None) -> int:
    if photons is not None:
        return integer(photons, "photons", 0, _MOST_PHOTONS)
    return 0 if seconds or target_error else _DEFAULT_PHOTONS


def _limit(value: float | None, name: str) -> float:
    return 0.0 if value is None else number(value, name)


def _bins(value: int | None, name: str) -> int:
    return 0 if value is None else integer(value, name, 1, _MOST_BINS)


def _axis(value: tuple[float, int] | None, name: str) -> tuple[float, int]:
    if value is None:
        return 0.0, 0
    try:
        end, bins = value
    except (TypeError, ValueError):
        raise InvalidArgumentError(
            f"{name} is {value!r}; it must be a pair, where the bins end and how many there are"
        ) from None
    return number(end, f"the end of {name}"), _bins(bins, f"the number of bins of {name}")
