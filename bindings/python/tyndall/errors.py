# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""What goes wrong, as exceptions: TyndallError and a kind for each status of the C API."""

from __future__ import annotations

from typing import Any


class TyndallError(Exception):
    """A call failed; the message says what was wrong, with which value, and what is allowed."""


class InvalidArgumentError(TyndallError, ValueError):
    """A parameter is outside its documented range."""


class InvalidOperationError(TyndallError):
    """The object is in the wrong state, such as a scene that is not committed."""


class ClosedError(InvalidOperationError):
    """The object, or the context that it was made from, was closed."""


class OutOfMemoryError(TyndallError, MemoryError):
    """Host or device memory, or the context's memory_limit, does not suffice."""


class NoDeviceError(TyndallError):
    """There is no OpenCL device, or none that matches."""


class KernelBuildError(TyndallError):
    """A kernel did not compile; the message holds the build log."""


class DeviceError(TyndallError):
    """An OpenCL call failed; the message names it and its code."""


class CancelledError(TyndallError):
    """The progress callback asked for it. `result`: what was done so far, as the call would have returned it, or None."""

    result: Any = None


class FileError(TyndallError, OSError):
    """A file could not be opened, read or written."""


class FormatError(TyndallError, ValueError):
    """A file's contents are wrong."""


class InternalError(TyndallError):
    """A defect of the library."""


class TyndallWarning(UserWarning):
    """Something was ignored, repaired or is doubtful: in a file, or in a scene."""
