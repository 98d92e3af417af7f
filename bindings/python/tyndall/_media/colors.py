# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Between the colour of a medium, the diffuse albedo of an index-matched half-space of it, and its single-scattering albedo."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from .. import capi
from .._core.numbers import broadcast, elementwise, require


def albedo_from_color(color: ArrayLike, g: ArrayLike = 0.0) -> Any:
    """Single-scattering albedo of the multiple-scattering colour C: (1 - s^2) / (1 - g s^2) with
    s = 4.09712 + 4.20863 C - sqrt(9.59217 + 41.6808 C + 17.7126 C^2) (Kulla & Conty 2017, after van de Hulst 1980). A fit: with
    a dielectric boundary, or g far from 0, the colour that comes out is darker. In single precision.

    color: [0, 1]; what is outside is clamped to it. g: mean cosine of the phase function, in (-1, 1). They are broadcast
    against each other: the result is an array of that shape, or a float. InvalidArgumentError for NaN and for g out of range.
    """
    return _converted(capi.lib.tyn_albedo_from_color, "color", color, g)


def color_from_albedo(albedo: ArrayLike, g: ArrayLike = 0.0) -> Any:
    """The inverse of `albedo_from_color`: C = (1 - s) (1 - 0.139 s) / (1 + 1.17 s) with s = sqrt((1 - W) / (1 - W g)) (van de
    Hulst 1980). albedo: W, [0, 1], clamped; the rest as there."""
    return _converted(capi.lib.tyn_color_from_albedo, "albedo", albedo, g)


def _converted(function: Any, name: str, value: ArrayLike, g: ArrayLike) -> Any:
    given, cosine = broadcast({name: value, "g": g})
    require(~np.isnan(given), name, given, "a number")
    require(np.abs(cosine.astype(np.float32)) < 1, "g", cosine, "in (-1, 1)")
    return elementwise(function, [given, cosine])
