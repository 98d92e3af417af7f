# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""OpenCL objects of callers: pyopencl's, or their addresses. pyopencl itself is not needed."""

from __future__ import annotations

import operator
from typing import Any

from ..errors import InvalidArgumentError
from .arrays import shown


def cl_object(value: Any, name: str) -> int:
    """The address of an OpenCL object: `value` if it is an integer, else its `int_ptr`, which pyopencl's objects have. What
    lies at an address is not looked at."""
    given = getattr(value, "int_ptr", value)
    try:
        address = 0 if isinstance(given, bool) else operator.index(given)
    except TypeError:
        address = 0
    if address <= 0:
        raise InvalidArgumentError(f"{name} is {shown(value)}; it must be an object of pyopencl's, or the address of OpenCL's")
    return address


def cl_buffer(value: Any, name: str) -> int:
    """The address of a cl_mem: of a buffer of pyopencl's, of the buffer of a pyopencl.array.Array, or `value` itself."""
    if not hasattr(value, "base_data"):
        return cl_object(value, name)
    if value.offset != 0:
        raise InvalidArgumentError(
            f"{name} is an array that begins {value.offset} bytes into its buffer; it must begin with it"
        )
    if not value.flags.c_contiguous:
        raise InvalidArgumentError(f"{name} is an array of strides {value.strides}; it must be contiguous")
    return cl_object(value.base_data, name)
