# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Monte Carlo estimates: values with their standard errors."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Callable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import InvalidArgumentError


class Estimate(np.ndarray[Any, np.dtype[np.float64]]):
    """An array of values, with an array of their standard errors, of the same shape, in `stderr`.

    Indexing, slicing, transposing, reshaping, copying and pickling keep the two together; a single value is an Estimate
    without dimensions, which is a number wherever one is wanted. Whatever is calculated from an Estimate is a plain array,
    as its error depends on how the values are correlated, which those of one run are. Values cannot be written to;
    `np.array(estimate)` is a copy that can.
    """

    _stderr: NDArray[np.float64] | None = None

    def __new__(cls, values: ArrayLike, stderr: ArrayLike) -> Estimate:
        """values, stderr: of one shape, copied."""
        value, error = np.asarray(values, np.float64), np.asarray(stderr, np.float64)
        if value.shape != error.shape:
            raise InvalidArgumentError(f"values has the shape {value.shape} and stderr {error.shape}; they must be the same")
        own = super().__new__(cls, value.shape, np.float64)
        np.copyto(own.view(np.ndarray), value)
        return _marked(own, np.array(error, order="C"))

    @property
    def stderr(self) -> NDArray[np.float64]:
        """The standard errors; nan where there was but one batch of photons. AttributeError if this is not an estimate any
        more but was made from one, such as by `view()`."""
        if self._stderr is None or self._stderr.shape != self.shape:
            raise AttributeError("these values were made from an Estimate by something that does not keep standard errors")
        return self._stderr

    def __getitem__(self, key: Any) -> Any:
        return _both(self, lambda one: one[key])

    @property
    def T(self) -> Any:
        return _both(self, np.transpose)

    def __copy__(self) -> Any:
        return self.copy()

    def __deepcopy__(self, memo: Any) -> Any:
        return self.copy()

    def __reduce__(self) -> Any:
        if self._stderr is None:
            return _values(self).__reduce__()
        return Estimate, (_values(self), self._stderr)

    def __reduce_ex__(self, protocol: Any) -> Any:
        return self.__reduce__()

    def __array_ufunc__(self, ufunc: Any, method: Any, *inputs: Any, **kwargs: Any) -> Any:
        return getattr(ufunc, method)(*_plain(inputs), **_plain(kwargs))

    def __array_function__(self, function: Any, types: Any, args: Any, kwargs: Any) -> Any:
        if function in _KEEPING_FUNCTIONS:
            return super().__array_function__(function, types, args, kwargs)
        return function(*_plain(args), **_plain(kwargs))

    def __repr__(self) -> str:
        if self._stderr is None:
            return repr(_values(self))
        value = np.array2string(_values(self), separator=", ", prefix="Estimate(")
        error = np.array2string(self._stderr, separator=", ", prefix="         stderr=")
        gap = "\n         " if "\n" in value + error or len(value + error) > 80 else " "
        return f"Estimate({value},{gap}stderr={error})"


def _values(one: Estimate) -> NDArray[np.float64]:
    return one.view(np.ndarray)


def _marked(values: Estimate, stderr: NDArray[np.float64]) -> Estimate:
    values._stderr = stderr
    values.flags.writeable = False
    stderr.flags.writeable = False
    return values


def _both(one: Estimate, change: Callable[[Any], Any]) -> Any:
    """An Estimate of what `change` makes of values and errors; of the values alone if there are no errors any more."""
    values = change(_values(one))
    if one._stderr is None:
        return values
    return _marked(np.asarray(values).view(Estimate), np.asarray(change(one._stderr)))


def _plain(value: Any) -> Any:
    """`value` with plain arrays for the Estimates in it."""
    if isinstance(value, Estimate):
        return _values(value)
    if type(value) in (list, tuple):
        return type(value)(_plain(one) for one in value)
    if type(value) is dict:
        return {key: _plain(one) for key, one in value.items()}
    return value


def _out(name: str, args: Any, kwargs: Any) -> Any:
    return args[2] if name in ("take", "compress") and len(args) > 2 else kwargs.get("out")


def _keeping(name: str) -> Any:
    def method(self: Estimate, *args: Any, **kwargs: Any) -> Any:
        if _out(name, args, kwargs) is not None:  # the caller's array, which is for the values alone
            return getattr(_values(self), name)(*_plain(args), **_plain(kwargs))
        return _both(self, lambda one: getattr(one, name)(*args, **kwargs))

    method.__name__ = name
    return method


def _losing(name: str) -> Any:
    def method(self: Estimate, *args: Any, **kwargs: Any) -> Any:
        return getattr(_values(self), name)(*_plain(args), **_plain(kwargs))

    method.__name__ = name
    return method


# What moves values without changing them, and what numpy would return as an Estimate though it calculates.
_KEEPING_METHODS = (
    "compress", "copy", "diagonal", "flatten", "ravel", "repeat", "reshape", "squeeze", "swapaxes", "take", "transpose",
)  # fmt: skip
_LOSING_METHODS = (
    "argmax", "argmin", "argpartition", "argsort", "astype", "byteswap", "choose", "conj", "conjugate", "cumprod", "cumsum",
    "dot", "getfield", "round", "searchsorted", "trace",
)  # fmt: skip
_KEEPING_FUNCTIONS: Sequence[Any] = (
    np.expand_dims, np.moveaxis, np.ravel, np.reshape, np.squeeze, np.swapaxes, np.transpose,
)  # fmt: skip

for _name in _KEEPING_METHODS:
    setattr(Estimate, _name, _keeping(_name))
for _name in _LOSING_METHODS:
    setattr(Estimate, _name, _losing(_name))
