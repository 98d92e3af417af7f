# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Stacks of layers: what light meets in a slab or a half-space."""

from __future__ import annotations

import ctypes
import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any, Union

import numpy as np

from .. import capi
from .._core.arrays import data, shown
from .._core.numbers import number
from .._media.medium import Medium
from ..errors import InvalidArgumentError


@dataclass(frozen=True)
class Layer:
    """One plane layer of a slab, infinite sideways."""

    medium: Medium
    thickness: float = math.inf
    """In the unit of the medium's coefficients, > 0, at most 1e20; inf (a half-space) in the last layer only."""


INCIDENCES = {"collimated": capi.TYN_INCIDENCE_COLLIMATED, "diffuse": capi.TYN_INCIDENCE_DIFFUSE}
"""Light along one direction, or radiance equal from everywhere above (cosine-distributed flux)."""

Layers = Union[Medium, Layer, Sequence[Layer]]
"""A stack from the top: 1 to 64 layers, or one layer, or a medium, which is a half-space."""


def stack(layers: Layers) -> list[Layer]:
    """The layers of a stack, in one unit of length and with as many channels."""
    if isinstance(layers, Medium):
        layers = Layer(layers)
    if isinstance(layers, Layer):
        layers = [layers]
    found = [Layer(one) if isinstance(one, Medium) else one for one in layers] if isinstance(layers, Iterable) else []
    if not found or not all(isinstance(one, Layer) for one in found):
        raise InvalidArgumentError("layers must be a Medium, a Layer, or one or more of Layer")
    for place, one in enumerate(found):
        if not isinstance(one.medium, Medium):
            raise InvalidArgumentError(f"the medium of layer {place} is {shown(one.medium)}; it must be a tyndall.Medium")
    units = {one.medium.metres_per_unit for one in found}
    if len(units) > 1:
        raise InvalidArgumentError(
            f"the layers' media must have the same metres_per_unit; theirs are {sorted(map(str, units))}"
        )
    channels = {one.medium.channels for one in found}
    if len(channels - {1}) > 1:
        raise InvalidArgumentError(f"the layers' media must have 1 channel or the same number; theirs are {sorted(channels)}")
    return found


def slab_record(layers: Layers, ior_above: float, ior_below: float) -> Any:
    """The TynSlab of a stack. It keeps alive what it points to."""
    found = stack(layers)
    channels = max(one.medium.channels for one in found)
    records = (capi.TynSlabLayer * len(found))()
    keep: list[Any] = [records, found]
    for index, layer in enumerate(found):
        medium = layer.medium
        sigma_a = np.ascontiguousarray(np.broadcast_to(medium.sigma_a, channels))
        sigma_s = np.ascontiguousarray(np.broadcast_to(medium.sigma_s, channels))
        keep += [sigma_a, sigma_s]
        records[index] = capi.TynSlabLayer(
            sigma_a=data(sigma_a),
            sigma_s=data(sigma_s),
            g=medium.g,
            ior=medium.ior,
            thickness=number(layer.thickness, "thickness"),
        )
        if medium.phase is not None:
            records[index].phase = ctypes.pointer(medium.phase.record)
    slab = capi.TynSlab(
        channel_count=channels,
        layer_count=len(found),
        layers=records,
        ior_above=number(ior_above, "ior_above"),
        ior_below=number(ior_below, "ior_below"),
    )
    slab.keep = keep
    return slab
