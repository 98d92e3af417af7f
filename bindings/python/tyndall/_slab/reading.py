# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""From a TynSlabResult to a SlabResult: everything is copied."""

from __future__ import annotations

import ctypes
import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .. import capi
from .._core.arrays import data
from .._core.status import error_of
from .estimate import Estimate
from .results import (
    SlabAngular,
    SlabDepth,
    SlabOrders,
    SlabPath,
    SlabRadial,
    SlabRadialAngular,
    SlabReflectance,
    SlabResult,
    SlabRun,
    SlabSweep,
    SlabTransmittance,
)


def read_slab_result(pointer: Any, options: Any, sweep: tuple[NDArray[np.float64], NDArray[np.float64]] | None) -> SlabResult:
    """pointer: the TynSlabResult. options: the TynSlabOptions of the run. sweep: its media."""
    reader = _Reader(pointer)
    record = reader.record
    return SlabResult(
        reflectance=SlabReflectance(
            reader.total("reflectance"), reader.total("specular_reflectance"), reader.total("diffuse_reflectance")
        ),
        transmittance=SlabTransmittance(
            reader.total("transmittance"), reader.total("direct_transmittance"), reader.total("diffuse_transmittance")
        ),
        absorbed=reader.total("absorbed"),
        layer_absorbed=reader.quantity(capi.TYN_SLAB_LAYER_ABSORBED),
        cut=reader.total("cut"),
        run=SlabRun(record.photons, record.events, record.seconds, record.build_seconds, record.seed),
        **_parts(reader, options, sweep),
    )


def _parts(reader: _Reader, options: Any, sweep: Any) -> dict[str, Any]:
    """What was asked for."""
    parts: dict[str, Any] = {}
    if options.radial_bins:
        axis = _axis(options.radial_max, options.radial_bins)
        parts["radial"] = SlabRadial(*axis, *reader.both(capi.TYN_SLAB_RADIAL_REFLECTANCE))
    if options.angular_bins:
        axis = _axis(math.pi / 2, options.angular_bins)
        parts["angular"] = SlabAngular(*axis, *reader.both(capi.TYN_SLAB_ANGULAR_REFLECTANCE))
    if options.radial_angular:
        bins = options.radial_bins, options.angular_bins
        parts["radial_angular"] = SlabRadialAngular(*reader.both(capi.TYN_SLAB_RADIAL_ANGULAR_REFLECTANCE, bins))
    if options.depth_bins:
        axis = _axis(options.depth_max, options.depth_bins)
        parts["depth"] = SlabDepth(*axis, *reader.both(capi.TYN_SLAB_DEPTH_ABSORBED))
    if options.order_bins:
        parts["orders"] = SlabOrders(np.arange(options.order_bins), *reader.both(capi.TYN_SLAB_ORDER_REFLECTANCE))
    if options.path_bins:
        axis = _axis(options.path_max, options.path_bins)
        parts["path"] = SlabPath(*axis, *reader.both(capi.TYN_SLAB_PATH_REFLECTANCE))
    if sweep is not None:
        quantities = (capi.TYN_SLAB_SWEEP_REFLECTANCE, capi.TYN_SLAB_SWEEP_TRANSMITTANCE, capi.TYN_SLAB_SWEEP_ABSORBED)
        parts["sweep"] = SlabSweep(sweep[0], sweep[1], *(reader.quantity(one) for one in quantities))
    return parts


def _axis(end: float, bins: int) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    edges = np.linspace(0.0, end, bins + 1)
    return edges, (edges[:-1] + edges[1:]) / 2


class _Reader:
    """Reads a TynSlabResult; channels become the last axis."""

    def __init__(self, pointer: Any) -> None:
        self.pointer = pointer
        self.record = capi.TynSlabRun()
        _check(capi.lib.tyn_slab_result_run(pointer, ctypes.byref(self.record)))
        self.channels: int = self.record.channel_count
        self.totals = [self._totals(channel) for channel in range(self.channels)]

    def _totals(self, channel: int) -> Any:
        totals = capi.TynSlabTotals()
        _check(capi.lib.tyn_slab_result_totals(self.pointer, channel, ctypes.byref(totals)))
        return totals

    def total(self, name: str) -> Estimate:
        found = [getattr(one, name) for one in self.totals]
        return Estimate([one.value for one in found], [one.standard_error for one in found])

    def quantity(self, quantity: int, bins: tuple[int, ...] = (-1,)) -> Estimate:
        """TYN_SLAB_*, of the shape bins x channels."""
        count = capi.lib.tyn_slab_result_count(self.pointer, quantity)
        values, errors = np.empty((self.channels, count)), np.empty((self.channels, count))
        for channel in range(self.channels):
            status = capi.lib.tyn_slab_result_read(
                self.pointer, quantity, channel, data(values[channel]), data(errors[channel]), count
            )
            _check(status)
        return Estimate(values.T.reshape(*bins, self.channels), errors.T.reshape(*bins, self.channels))

    def both(self, quantity: int, bins: tuple[int, ...] = (-1,)) -> tuple[Estimate, Estimate]:
        """A quantity and the one that follows it."""
        return self.quantity(quantity, bins), self.quantity(quantity + 1, bins)


def _check(status: int) -> None:
    if status != capi.TYN_OK:
        raise error_of(status, "")
