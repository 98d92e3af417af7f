# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""File names and other strings on their way to C."""

from __future__ import annotations

import os
from typing import Union

from ..errors import InvalidArgumentError

Path = Union[str, "os.PathLike[str]"]
"""The name of a file."""


def path_bytes(path: Path, name: str = "path") -> bytes:
    """A file's name as the system has it."""
    try:
        return _without_zero(os.fsencode(path), path, name)
    except TypeError:
        raise InvalidArgumentError(f"{name} is {path!r}; it must be a str or an os.PathLike") from None


def text_bytes(text: object, name: str) -> bytes:
    """A string in UTF-8."""
    return _without_zero(str(text).encode(), text, name)


def _without_zero(value: bytes, given: object, name: str) -> bytes:
    if b"\0" in value:
        raise InvalidArgumentError(f"{name} is {given!r}; it must not contain a zero byte")
    return value
