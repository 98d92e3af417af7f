# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Fields of records from what callers give: numbers and arrays that broadcast against one another."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .. import capi
from ..errors import InvalidArgumentError
from .arrays import array, refuse_masked, shown, unmasked
from .numbers import UINT64, integer


def indices(value: Any, name: str) -> NDArray[np.uint32]:
    """`value` as uint32, without a copy if it is that already. None stands for no index, TYN_NONE."""
    given = unmasked(capi.TYN_NONE if value is None else value, name)
    if given.dtype == np.uint32:
        return given
    if given.size == 0:
        return given.astype(np.uint32)
    if given.dtype.kind not in "iu":
        raise InvalidArgumentError(f"{name} must be integers; it is of type {given.dtype}")
    low, high = int(given.min()), int(given.max())
    if low < 0 or high > capi.TYN_NONE:
        raise InvalidArgumentError(f"{name} holds {low if low < 0 else high}; an index is in [0, {capi.TYN_NONE}]")
    return given.astype(np.uint32)


def words(value: ArrayLike, name: str) -> NDArray[np.uint32]:
    """Integers in [0, 2^64) as their low and high words, on a new last axis."""
    refuse_masked(value, name)
    try:
        given = np.asarray(value)
        if given.size > 0 and given.dtype.kind not in "iu":  # numpy makes float64 of [1, 2**63 + 1]
            given = np.asarray(value, object)
    except ValueError:
        raise InvalidArgumentError(f"{name} must be integers in [0, 2^64); it is {shown(value)}") from None
    if given.dtype.kind == "O":
        numbers = [integer(one, name, 0, UINT64) for one in given.ravel()]
        given = np.array(numbers, np.uint64).reshape(given.shape)
    if given.size > 0:
        integer(given.min(), name, 0, UINT64)
    number = given.astype(np.uint64)
    return np.stack([number & np.uint64(0xFFFFFFFF), number >> np.uint64(32)], axis=-1).astype(np.uint32)


def vectors(value: ArrayLike, name: str) -> NDArray[np.float32]:
    """`value` as float32 with three numbers on the last axis."""
    found = array(value, name)
    if found.ndim == 0 or found.shape[-1] != 3:
        raise InvalidArgumentError(f"{name} has the shape {found.shape}; its last axis must be x, y, z")
    return found


def colors(value: ArrayLike, name: str) -> NDArray[np.float32]:
    """`value` as float32: a number for all channels of all records, or with RGB or one number on the last axis."""
    found = array(value, name)
    if found.ndim > 0 and found.shape[-1] not in (1, 3):
        raise InvalidArgumentError(
            f"{name} has the shape {found.shape}; it must be a number, or its last axis the channels, 3 or 1 of them"
        )
    return found


def filled(dtype: np.dtype[Any], fields: Mapping[str, NDArray[Any]]) -> NDArray[Any]:
    """Records of `dtype` with `fields`, broadcast against one another; the rest is 0. At least one-dimensional."""
    leading = {}
    for name, value in fields.items():
        inner = dtype[name].ndim
        leading[name] = value.shape[: max(0, value.ndim - inner)]
    try:
        shape = np.broadcast_shapes((1,), *leading.values())
    except ValueError:
        shown = ", ".join(f"{name} {each}" for name, each in leading.items() if each)
        raise InvalidArgumentError(f"these do not broadcast against one another: {shown}") from None
    result = np.zeros(shape, dtype)
    for name, value in fields.items():
        result[name] = value
    return result
