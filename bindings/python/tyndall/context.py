# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""The context with all of its calls, each from the module of what it makes."""

from __future__ import annotations

import threading

from ._bssrdf.models import BssrdfCalls
from ._core.context import ContextHandle
from ._files.loading import LoadCalls
from ._render.calls import RenderCalls
from ._scene.rays import RayCalls
from ._scene.scene import SceneCalls
from ._slab.calls import SlabCalls
from ._walk.calls import WalkCalls
from .interop import InteropCalls


class Context(SlabCalls, BssrdfCalls, SceneCalls, LoadCalls, RayCalls, WalkCalls, RenderCalls, InteropCalls):
    __doc__ = ContextHandle.__doc__


_default: Context | None = None
_default_lock = threading.Lock()


def default_context() -> Context:
    """The context that functions use which are given none: `Context()`, made when it is first asked for."""
    global _default
    with _default_lock:
        if _default is None or _default.closed:
            _default = Context()
        return _default
