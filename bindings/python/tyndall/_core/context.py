# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""How a context is opened. The calls that one has are in the modules of what they make; context.py puts them together."""

from __future__ import annotations

import ctypes
import os
from typing import Any, Callable

from .. import capi
from .devices import Device, device_choice, device_of
from .fork import note_use
from .handles import Handle
from .numbers import UINT32, UINT64, integer
from .progress import LongCall
from .status import error_of

_MESSAGE_BYTES = 65536  # what a failed creation may say; a kernel's build log is cut there


class ContextHandle(Handle):
    """A device, its queue and its compiled kernels: what everything else is made from.

    One context is used by one thread at a time: calls from several threads wait for each other. For work in parallel make a
    context a thread; calls release the GIL. OpenCL does not survive a fork: processes of multiprocessing need the start method
    spawn. Closing a context closes what was made from it.
    """

    _kind = "context"

    def __init__(
        self,
        device: int | str | Device | None = None,
        *,
        memory_limit: int = 0,
        lane_width: int = 0,
        cache_directory: str | os.PathLike[str] | None = None,
    ) -> None:
        """Opens a context.

        device: index in `devices()`, part of a device's name (case is ignored), "GPU" or "CPU" for the first of the kind, or
            one of `devices()`. None: the environment variable TYNDALL_DEVICE, else the first device.
        memory_limit: bytes of device memory that may be in use; 0: the device's own. Batches shrink to fit.
        lane_width: 1, 4, 8 or 16 lanes; 0: by device. Results do not depend on it.
        cache_directory: folder for compiled kernels and tables; None: TYNDALL_CACHE_DIR, else the user's cache; "": none.

        Errors: NoDeviceError, InvalidArgumentError, OutOfMemoryError, DeviceError.
        """
        choice = device_choice(device)
        options = context_options(memory_limit, lane_width, cache_directory)
        if choice is not None:
            options.device = choice.encode()
        with LongCall(None, "context"):  # what was made is owned before an interrupt is raised
            super().__init__(create(options, capi.lib.tyn_context_create), capi.lib.tyn_context_release)

    @property
    def device(self) -> Device:
        """The device; its lane_width is the one in use."""
        info = capi.TynDeviceInfo()
        self._call(capi.lib.tyn_context_device, self.handle, ctypes.byref(info))
        return device_of(-1, info)

    def __repr__(self) -> str:
        return "<tyndall.Context, closed>" if self.closed else f"<tyndall.Context on {self.device.name}>"


def context_options(memory_limit: int, lane_width: int, cache_directory: str | os.PathLike[str] | None) -> Any:
    """The TynContextOptions of a context's arguments, without a device."""
    options = capi.TynContextOptions(
        memory_limit=integer(memory_limit, "memory_limit", 0, UINT64), lane_width=integer(lane_width, "lane_width", 0, UINT32)
    )
    if cache_directory is not None:
        options.cache_directory = os.fsencode(cache_directory)
    return options


def create(options: Any, function: Callable[..., int], *arguments: Any) -> Any:
    """The context that `function(options, *arguments, context)` makes."""
    note_use()
    message = ctypes.create_string_buffer(_MESSAGE_BYTES)
    options.message = ctypes.cast(message, ctypes.c_char_p)
    options.message_capacity = _MESSAGE_BYTES
    pointer = ctypes.POINTER(capi.TynContext)()
    status = function(ctypes.byref(options), *arguments, ctypes.byref(pointer))
    if status != capi.TYN_OK:
        raise error_of(status, message.value.decode(errors="replace"))
    return pointer
