# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Names that callers give."""

from __future__ import annotations

from typing import Any

from ..errors import InvalidArgumentError
from .arrays import shown


def optional_name(value: Any, name: str = "name") -> str | None:
    """`value`, a string that C can hold, or None."""
    if value is None or (isinstance(value, str) and "\0" not in value):
        return value
    raise InvalidArgumentError(f"{name} is {shown(value)}; it must be a str without a zero byte, or None")
