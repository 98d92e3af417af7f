# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Single numbers, and ranges of numbers, that callers give. Errors name the argument, its value and what is allowed."""

from __future__ import annotations

import operator
from typing import Any, Callable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .. import capi
from ..errors import InvalidArgumentError
from .arrays import array, shown

UINT32 = (1 << 32) - 1
UINT64 = (1 << 64) - 1


def number(value: Any, name: str) -> float:
    """`value` as a float."""
    return float(array(value, name, np.float64, ()))


def integer(value: Any, name: str, low: int, high: int) -> int:
    """`value` as an integer in [low, high]; floats such as 1e7 are integers too."""
    text = f"an integer in [{low}, {high}]"
    if isinstance(value, (float, np.floating)) and float(value).is_integer():
        value = int(value)
    try:
        result = int(value.__index__())
    except (AttributeError, TypeError):
        raise InvalidArgumentError(f"{name} is {shown(value)}; it must be {text}") from None
    if not low <= result <= high:
        raise InvalidArgumentError(f"{name} is {result}; it must be {text}")
    return result


def index(value: Any, name: str) -> int:
    """`value` as an index; InvalidArgumentError with `name` otherwise."""
    try:
        found = operator.index(value)
    except TypeError:
        raise InvalidArgumentError(f"{name} is {shown(value)}; it must be an index") from None
    if isinstance(value, bool) or not 0 <= found < capi.TYN_NONE:
        raise InvalidArgumentError(f"{name} is {value!r}; it must be an index, in [0, {capi.TYN_NONE - 1}]")
    return found


def decimal(value: float) -> float:
    """The shortest decimal number that is a float of the C API's: 0.69, not 0.68999999."""
    return float(str(np.float32(value)))


def require(good: Any, name: str, values: Any, allowed: str) -> None:
    """InvalidArgumentError for the first of `values` that is not `good` (a bool or an array of them, like `values`)."""
    if not np.all(good):
        first = np.asarray(values, np.float64)[~np.asarray(good)].flat[0]
        raise InvalidArgumentError(f"{name} is {first:g}; it must be {allowed}")


def broadcast(arguments: dict[str, ArrayLike]) -> list[NDArray[np.float64]]:
    """The arguments as float64 arrays of one shape."""
    given = {name: array(value, name, np.float64) for name, value in arguments.items()}
    try:
        return list(np.broadcast_arrays(*given.values()))
    except ValueError:
        shapes = ", ".join(f"{name} {one.shape}" for name, one in given.items() if one.ndim)
        raise InvalidArgumentError(f"these shapes do not broadcast against one another: {shapes}") from None


def elementwise(function: Callable[..., float], arguments: list[NDArray[np.float64]]) -> Any:
    """`function` of every element of arrays of one shape: a float if they have no dimensions, else an array."""
    results = [function(*numbers) for numbers in zip(*(one.ravel().tolist() for one in arguments))]
    return shaped(np.array(results, np.float64).reshape(arguments[0].shape))


def shaped(values: NDArray[np.float64]) -> Any:
    """`values`, as a float if they are a single number."""
    return float(values) if values.ndim == 0 else values
