# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Enumerations of the C API as strings."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from ..errors import InvalidArgumentError


def choice(value: Any, name: str, choices: Mapping[str, int]) -> int:
    """The number of the choice that `value` names; else InvalidArgumentError, which names the argument and the choices."""
    try:
        return choices[value]
    except (KeyError, TypeError):
        allowed = ", ".join(f'"{one}"' for one in choices)
        raise InvalidArgumentError(f"{name} is {value!r}; it must be one of {allowed}") from None
