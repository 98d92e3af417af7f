# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Numpy at the edges of the C API: what callers give becomes C-contiguous arrays of the right type and shape, without a copy
where it is one already."""

from __future__ import annotations

import ctypes
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import InvalidArgumentError, OutOfMemoryError

_POINTERS: dict[np.dtype[Any], Any] = {
    np.dtype(np.float32): ctypes.POINTER(ctypes.c_float),
    np.dtype(np.float64): ctypes.POINTER(ctypes.c_double),
    np.dtype(np.uint32): ctypes.POINTER(ctypes.c_uint32),
}


def array(value: ArrayLike, name: str, dtype: Any = np.float32, shape: Sequence[int | None] | None = None) -> NDArray[Any]:
    """`value` as a C-contiguous array of `dtype`: itself if it is one, else a copy. `shape`: what is allowed, None for a
    length of any size. Errors name the argument."""
    refuse_masked(value, name)
    try:
        given = np.asarray(value)
        if given.dtype.kind not in "biuf" and given.size > 0:
            raise TypeError
    except (TypeError, ValueError, OverflowError):
        raise _no_numbers(value, name, dtype) from None
    _check_shape(given, name, shape)  # before a view of few numbers in a huge shape is copied
    try:
        with np.errstate(over="ignore", invalid="ignore"):  # what a float32 cannot hold is inf, which the library refuses
            result = np.ascontiguousarray(given, dtype=dtype)
        if result.dtype.kind in "iu" and given.dtype != result.dtype and np.any(result != given):
            raise ValueError  # numpy would wrap and truncate
    except (TypeError, ValueError, OverflowError):
        raise _no_numbers(value, name, dtype) from None
    except MemoryError:
        raise OutOfMemoryError(f"there is no memory for {name}, {shown(given)}") from None
    return result.reshape(()) if given.ndim == 0 else result


def refuse_masked(value: Any, name: str) -> None:
    """An element that is masked would count as if it were not."""
    mask = np.ma.getmask(value)
    if mask is not np.ma.nomask and b"\1" in mask.tobytes():  # of records, too
        raise InvalidArgumentError(f"{name} is a masked array with masked elements; give one without, such as filled() makes")


def unmasked(value: Any, name: str) -> NDArray[Any]:
    """`value` as an array of numpy's."""
    refuse_masked(value, name)
    return np.asarray(value)


def room(shape: tuple[int, ...], name: str, dtype: Any = np.float32) -> NDArray[Any]:
    """An array for the library to fill. name: of the argument that says how many."""
    try:
        return np.empty(shape, dtype)
    except (MemoryError, ValueError):  # ValueError: more than numpy can count
        raise OutOfMemoryError(f"{name} is {shape[-1]}; there is no memory for so many") from None


def _no_numbers(value: Any, name: str, dtype: Any) -> InvalidArgumentError:
    return InvalidArgumentError(f"{name} must be numbers that fit {np.dtype(dtype).name}; it is {shown(value)}")


def _check_shape(given: NDArray[Any], name: str, shape: Sequence[int | None] | None) -> None:
    if shape is not None and (given.ndim != len(shape) or any(n is not None and n != m for n, m in zip(shape, given.shape))):
        wanted = " x ".join("n" if n is None else str(n) for n in shape) or "a single number"
        raise InvalidArgumentError(f"{name} has the shape {given.shape}; it must be {wanted}")


def records(value: Any, name: str, dtype: np.dtype[Any]) -> NDArray[Any]:
    """`value` as a one-dimensional, C-contiguous structured array of `dtype`, without a copy if it is one."""
    given = unmasked(value, name)
    if given.dtype != dtype or given.ndim != 1:
        raise InvalidArgumentError(
            f"{name} must be a one-dimensional structured array of the dtype with the fields {', '.join(dtype.names or ())};"
            f" it is {shown(value)}"
        )
    return np.ascontiguousarray(given)


def data(values: NDArray[Any] | None) -> Any:
    """The pointer to an array's data that ctypes wants; None for None. The caller keeps the array alive."""
    if values is None:
        return None
    return ctypes.cast(values.ctypes.data, _POINTERS[values.dtype])


def record_data(values: NDArray[Any], record: type[ctypes.Structure]) -> Any:
    """The pointer to the first of the records of a structured array."""
    return ctypes.cast(values.ctypes.data, ctypes.POINTER(record))


def shown(value: Any) -> str:
    """A value for a message, which arrays would fill."""
    if isinstance(value, np.ndarray):
        return f"an array of shape {value.shape} and type {value.dtype}"
    text = repr(value)
    return text if len(text) <= 60 else text[:57] + "..."
