# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""The OpenCL devices of the machine."""

from __future__ import annotations

import ctypes
from dataclasses import dataclass

from .. import capi
from ..errors import NoDeviceError
from .fork import note_use
from .status import error_of


@dataclass(frozen=True)
class Device:
    """One OpenCL device."""

    index: int
    """Its place in `devices()`; -1 for the device of a context."""
    name: str
    platform: str
    driver: str
    is_gpu: bool
    compute_units: int
    memory: int
    """Bytes of global memory."""
    lane_width: int
    """Lanes that the kernels use on it: 16, 8 or 4 on a CPU, 1 on a GPU."""


def device_of(index: int, info: capi.TynDeviceInfo) -> Device:
    def text(value: bytes) -> str:
        return value.decode(errors="replace")

    return Device(
        index, text(info.name), text(info.platform), text(info.driver), bool(info.is_gpu), info.compute_units, info.memory,
        info.lane_width,
    )  # fmt: skip


def devices() -> list[Device]:
    """All OpenCL devices: GPUs first, then CPUs, each in the order of their platforms. Empty if there is none."""
    note_use()
    count = ctypes.c_uint32()
    _check(capi.lib.tyn_device_count(ctypes.byref(count)))
    found = []
    for index in range(count.value):
        info = capi.TynDeviceInfo()
        _check(capi.lib.tyn_device_info(index, ctypes.byref(info)))
        found.append(device_of(index, info))
    return found


def _check(status: int) -> None:
    if status != capi.TYN_OK:
        raise error_of(status, "")


def device_choice(device: int | str | Device | None) -> str | None:
    """What the C API takes: an index or part of a name. "GPU" and "CPU" mean the first of the kind."""
    if isinstance(device, Device):
        return device.name if device.index < 0 else str(device.index)
    if isinstance(device, str) and device.upper() in ("GPU", "CPU"):
        wanted = device.upper() == "GPU"
        found = devices()
        for one in found:
            if one.is_gpu == wanted:
                return str(one.index)
        names = ", ".join(one.name for one in found) or "none at all"
        raise NoDeviceError(f"there is no {device.upper()} among the OpenCL devices: {names}")
    return None if device is None else str(device)
