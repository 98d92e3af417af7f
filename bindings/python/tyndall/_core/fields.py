# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Frozen dataclasses whose fields are those of a C record."""

from __future__ import annotations

import ctypes
from collections.abc import Mapping
from dataclasses import fields
from types import SimpleNamespace
from typing import Any, ClassVar, TypeVar

import numpy as np

from .. import capi
from ..capi.record import Record
from ..errors import InvalidArgumentError
from .choices import choice
from .numbers import decimal, index
from .text import optional_name

Numbers = Any
"""As many numbers as the field's comment says, or one for all of them; kept as a tuple of float."""

_Self = TypeVar("_Self", bound="Fields")


class Fields:
    """What a dataclass of a record derives from: values are converted when it is made, `record()` gives the C record, `of()`
    reads one. Ranges are the library's to check, when the record is used."""

    _RECORD: ClassVar[type[Record]]
    _NAMES: ClassVar[Mapping[str, tuple[str, ...]]] = {}  # of enumerations, in the order of their numbers
    _INDICES: ClassVar[tuple[str, ...]] = ()  # fields that are an index or None
    _SHAPES: ClassVar[Mapping[str, tuple[int, ...]]] = {}  # of matrices

    def __post_init__(self) -> None:
        kinds = self._RECORD._kinds()
        for field in fields(self):  # type: ignore[arg-type]
            value = self._from_caller(field.name, kinds[field.name], getattr(self, field.name))
            object.__setattr__(self, field.name, value)

    def _from_caller(self, name: str, kind: Any, value: Any) -> Any:
        if name in self._NAMES:
            choice(value, name, _numbered(self._NAMES[name]))
            return value
        if name in self._INDICES:
            return None if value is None else index(value, name)
        if kind is ctypes.c_char_p:
            return optional_name(value, f"{type(self).__name__}.{name}")
        if kind is ctypes.c_uint32:
            return bool(value)
        return self._floats(name, kind, value)

    def _floats(self, name: str, kind: Any, value: Any) -> Any:
        count = 1 if kind is ctypes.c_float else kind._length_
        shape = () if kind is ctypes.c_float else self._SHAPES.get(name, (count,))
        try:
            given = np.asarray(value)
            if given.dtype.kind not in "biuf":
                raise TypeError
        except (TypeError, ValueError):
            raise InvalidArgumentError(f"{type(self).__name__}.{name} is {value!r}; it must be numbers") from None
        if given.ndim == 0 and len(shape) == 1:
            given = np.broadcast_to(given, shape)
        if given.shape not in (shape, (count,) if shape else ()):
            wanted = " x ".join(map(str, shape)) or "a single number"
            raise InvalidArgumentError(f"{type(self).__name__}.{name} has the shape {given.shape}; it must be {wanted}")
        return _nested(given.reshape(shape).tolist())

    def record(self) -> Any:
        """The C record for calls of `tyndall.capi`."""
        return self._RECORD(**{field.name: self._to_record(field.name) for field in fields(self)})  # type: ignore[arg-type]

    def _to_record(self, name: str) -> Any:
        value = getattr(self, name)
        if name in self._NAMES:
            return self._NAMES[name].index(value)
        if name in self._INDICES:
            return capi.TYN_NONE if value is None else value
        if isinstance(value, Fields):
            return value.record()
        return np.ravel(value) if name in self._SHAPES else value

    @classmethod
    def of(cls: type[_Self], record: Any) -> _Self:
        """What a C record says."""
        return cls(**{field.name: cls._from_record(field.name, record) for field in fields(cls)})  # type: ignore[arg-type]

    @classmethod
    def _from_record(cls, name: str, record: Any) -> Any:
        value = getattr(record, name)
        if name in cls._NAMES:
            return cls._NAMES[name][value]
        if name in cls._INDICES:
            return None if value == capi.TYN_NONE else value
        return plain(value)


def defaults(kind: type[Record]) -> Any:
    """What the C header's initializer of a record sets, in Python's own types."""
    record = kind()
    return SimpleNamespace(**{name: plain(getattr(record, name)) for name in kind._kinds()})


def _numbered(names: tuple[str, ...]) -> dict[str, int]:
    return {name: number for number, name in enumerate(names)}


def plain(value: Any) -> Any:
    """A field's value in Python's own types."""
    if isinstance(value, bytes):
        return value.decode(errors="replace")
    if isinstance(value, ctypes.Array):
        return tuple(decimal(one) for one in value)
    return decimal(value) if isinstance(value, float) else value


def _nested(value: Any) -> Any:
    return tuple(_nested(one) for one in value) if isinstance(value, list) else value
