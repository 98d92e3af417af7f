# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Forked processes, which inherit an OpenCL that does not work: its threads stayed with the parent."""

from __future__ import annotations

import os

from ..errors import InvalidOperationError


class _State:
    used = False  # OpenCL, by this process
    broken = False  # used by the process that this one was forked from


def note_use() -> None:
    """OpenCL is about to be used. InvalidOperationError if it cannot be."""
    if _State.broken:
        raise InvalidOperationError(
            "this process was forked from one that had used OpenCL, which does not survive that:"
            " use the start method spawn of multiprocessing, or fork before the first use"
        )
    _State.used = True


def is_broken() -> bool:
    """Whether what was made with OpenCL must be left alone."""
    return _State.broken


def _after_fork() -> None:
    _State.broken = _State.broken or _State.used


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_after_fork)
