# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""What the records of the C headers have in common: their size, their defaults, and a look at every value."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from ctypes import Array, Structure, _SimpleCData, c_char_p, c_int32, c_size_t, c_uint32, c_uint64, sizeof
from typing import Any, ClassVar

from ..errors import InvalidArgumentError

Signatures = Mapping[str, "tuple[Any, Sequence[Any]]"]

# ctypes would take any integer and keep its lowest bits.
_LIMITS: Mapping[type[_SimpleCData[Any]], tuple[int, int]] = {
    c_int32: (-(1 << 31), (1 << 31) - 1),
    c_uint32: (0, (1 << 32) - 1),
    c_uint64: (0, (1 << 64) - 1),
    c_size_t: (0, (1 << 8 * sizeof(c_size_t)) - 1),
}


def checked_integer(kind: type[_SimpleCData[Any]], name: str, value: Any) -> int:
    """`value` as an integer that `kind` can hold; InvalidArgumentError with `name` otherwise."""
    low, high = _LIMITS[kind]
    try:
        number = int(value.__index__())
    except (AttributeError, TypeError):
        raise InvalidArgumentError(f"{name} is {value!r}; it must be an integer in [{low}, {high}]") from None
    if not low <= number <= high:
        raise InvalidArgumentError(f"{name} is {number}; it must be an integer in [{low}, {high}]")
    return number


def _text(value: Any, name: str) -> bytes | None:
    """`value` as a C string; ctypes would take an integer for its address."""
    if isinstance(value, str):
        try:
            value = value.encode()
        except UnicodeEncodeError:
            raise InvalidArgumentError(f"{name} is {value!r}, which is not Unicode") from None
    if value is not None and not isinstance(value, bytes):
        raise InvalidArgumentError(f"{name} is {value!r}; it must be a string, or None")
    if value is not None and b"\0" in value:
        raise InvalidArgumentError(f"{name} is {value!r}; it must not contain a zero byte")
    return value


class Record(Structure):
    """A record of the C headers. `Record(field=value, ...)` is what the header's initializer of that record gives, with these
    fields set; `size` sets itself."""

    _defaults_: ClassVar[Mapping[str, Any]] = {}

    def __init__(self, **fields: Any) -> None:
        super().__init__()
        kinds = self._kinds()
        if "size" in kinds:
            fields["size"] = sizeof(self)
        for name, value in (*self._defaults_.items(), *fields.items()):
            kind = kinds.get(name)
            if kind is None:
                raise AttributeError(f"{type(self).__name__} has no field {name}")
            if kind in _LIMITS:
                value = checked_integer(kind, name, value)
            elif kind is c_char_p:
                value = _text(value, name)
            elif isinstance(kind, type) and issubclass(kind, Array) and not isinstance(value, (kind, bytes)):
                value = kind(*value)
            setattr(self, name, value)

    @classmethod
    def _kinds(cls) -> dict[str, Any]:
        """The ctypes type of every field; looked up once a class."""
        if "_kinds_" not in cls.__dict__:
            cls._kinds_ = {field[0]: field[1] for field in cls._fields_}
        kinds: dict[str, Any] = cls._kinds_
        return kinds

    _kinds_: ClassVar[dict[str, Any]]
