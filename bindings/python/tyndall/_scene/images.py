# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""The TynImage of an array."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .. import capi
from .._core.arrays import array, unmasked
from .._core.text import optional_name
from ..errors import InvalidArgumentError

_LARGEST_SIDE = 32768


def image_record(pixels: ArrayLike, srgb: bool | None, name: str | None) -> Any:
    """A TynImage. It keeps alive what it points to."""
    given = unmasked(pixels, "pixels")
    if given.ndim != 3 or given.shape[2] not in (3, 4):
        raise InvalidArgumentError(f"pixels has the shape {given.shape}; it must be height x width x 3 or 4")
    if max(given.shape[:2]) > _LARGEST_SIDE:
        raise InvalidArgumentError(f"pixels has the shape {given.shape}; its sides must be 1 to {_LARGEST_SIDE} pixels")
    if given.dtype != np.uint8 and given.dtype.kind != "f":
        raise InvalidArgumentError(f"pixels is of type {given.dtype}; it must be uint8 or float32")
    if given.dtype != np.uint8 and srgb:
        raise InvalidArgumentError("srgb is for uint8 pixels; those of floating-point type are linear")
    rows = _rgba(given)
    if rows.dtype != np.uint8:
        kind = capi.TYN_IMAGE_RGBA32F
    else:
        kind = capi.TYN_IMAGE_RGBA8_SRGB if srgb is None or srgb else capi.TYN_IMAGE_RGBA8_LINEAR
    height, width = rows.shape[:2]
    record = capi.TynImage(name=optional_name(name), width=width, height=height, format=kind)
    record.pixels = rows.ctypes.data
    record.row_stride = rows.strides[0] if height > 1 else 0
    record.keep = rows
    return record


def _rgba(given: NDArray[Any]) -> NDArray[Any]:
    """Four channels of uint8 or float32 without gaps in the rows, which may be apart; the pixels themselves if they are so."""
    kind = np.dtype(np.uint8 if given.dtype == np.uint8 else np.float32)
    if given.shape[2] == 3:
        colors = array(given, "pixels", kind)
        opaque = np.full((*given.shape[:2], 4), 255 if kind == np.uint8 else 1, kind)
        opaque[..., :3] = colors
        return opaque
    tight = given.strides[1:] == (4 * kind.itemsize, kind.itemsize) and given.strides[0] >= given.shape[1] * 4 * kind.itemsize
    return given if given.dtype == kind and tight else array(given, "pixels", kind)
