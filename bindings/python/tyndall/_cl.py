# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""OpenCL objects of callers: pyopencl's, or their addresses. pyopencl itself is not needed."""

from __future__ import annotations

from typing import Any

from .errors import InvalidArgumentError


def cl_object(value: Any, name: str) -> int:
    """The address of an OpenCL object: `value` if it is an integer, else its `int_ptr`, which pyopencl's objects have. What
    lies at an address is not looked at."""
    address = getattr(value, "int_ptr", value)
    if isinstance(address, bool) or not hasattr(address, "__index__") or address.__index__() <= 0:
        raise InvalidArgumentError(
            f"{name} is {value!r}; it must be an object of pyopencl's, or the address of one of OpenCL's"
        )
    return int(address.__index__())


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
