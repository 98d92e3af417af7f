# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Statuses of the C API as exceptions."""

from __future__ import annotations

from .. import capi, errors

_KINDS: dict[int, type[errors.TyndallError]] = {
    capi.TYN_ERROR_INVALID_ARGUMENT: errors.InvalidArgumentError,
    capi.TYN_ERROR_INVALID_OPERATION: errors.InvalidOperationError,
    capi.TYN_ERROR_OUT_OF_MEMORY: errors.OutOfMemoryError,
    capi.TYN_ERROR_NO_DEVICE: errors.NoDeviceError,
    capi.TYN_ERROR_KERNEL_BUILD: errors.KernelBuildError,
    capi.TYN_ERROR_DEVICE: errors.DeviceError,
    capi.TYN_ERROR_CANCELLED: errors.CancelledError,
    capi.TYN_ERROR_FILE: errors.FileError,
    capi.TYN_ERROR_FORMAT: errors.FormatError,
    capi.TYN_ERROR_INTERNAL: errors.InternalError,
}


def error_of(status: int, message: str) -> errors.TyndallError:
    """The exception of a status other than TYN_OK; without a message it says the status."""
    return _KINDS.get(status, errors.InternalError)(message or capi.lib.tyn_status_string(status).decode())
