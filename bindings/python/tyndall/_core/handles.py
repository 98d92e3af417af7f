# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Objects that own something of the library's: closing them, and keeping threads apart."""

from __future__ import annotations

import atexit
import threading
import weakref
from collections import deque
from functools import cache
from types import TracebackType
from typing import Any, Callable, TypeVar

from .. import capi
from ..errors import CancelledError, ClosedError, InvalidOperationError
from .fork import is_broken, note_use
from .progress import LongCall
from .status import error_of

_Self = TypeVar("_Self", bound="Handle")


class Guard:
    """Lets one thread at a time use a context and what was made from it, as the C API asks for. What is released while
    another thread is inside, or by the garbage collector in the middle of a call, is put off until the guard is free."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._owner: int | None = None
        self._released: deque[tuple[Callable[[Any], None], Any]] = deque()
        _guards.add(self)

    def run(self, call: Callable[[], None]) -> None:
        """Calls `call()` when no other thread is inside."""
        if self._owner == threading.get_ident():
            raise InvalidOperationError("a context cannot be used from the progress callback of its own call")
        if LongCall.signals_are_put_off():
            self._run_patiently(call)
        else:
            # The lock's own methods, not ones in Python: an interrupt must not come between taking and holding it.
            with self._lock:
                self._run_as_owner(call)
        self._release_if_free()

    def _run_patiently(self, call: Callable[[], None]) -> None:
        while not self._lock.acquire(timeout=_LOOK):
            LongCall.run_signals()
        try:
            self._run_as_owner(call)
        finally:
            self._lock.release()

    def _run_as_owner(self, call: Callable[[], None]) -> None:
        self._owner = threading.get_ident()
        try:
            call()
        finally:
            self._owner = None
            self._release_all()

    def release(self, function: Callable[[Any], None], pointer: Any) -> None:
        """Calls `function(pointer)`, now or as soon as no call is under way."""
        if not is_broken():
            self._released.append((function, pointer))
            self._release_if_free()

    def _release_if_free(self) -> None:
        while self._released and self._lock.acquire(blocking=False):
            try:
                self._owner = threading.get_ident()
                self._release_all()
            finally:
                self._owner = None
                self._lock.release()

    def _release_all(self) -> None:
        while self._released:
            function, pointer = self._released.popleft()
            function(pointer)

    def wait(self, seconds: float) -> None:
        """Returns when no call is under way, or after that time."""
        if self._lock.acquire(timeout=seconds):
            self._lock.release()


_LOOK = 0.05  # seconds between two looks for signals, while another thread is waited for
_PATIENCE = 5.0  # seconds that the end of the process waits for calls of daemon threads, which are cancelled
_guards: weakref.WeakSet[Guard] = weakref.WeakSet()


def _end_calls() -> None:
    """A thread that the end of the process takes out of the library in the middle of a call takes the process with it."""
    LongCall.end_all()
    for guard in list(_guards):
        guard.wait(_PATIENCE)


class Handle:
    """Owns one reference of an object of the library. It is given back by `close()`, at the end of a `with` block, or when the
    last reference to it goes. Using it afterwards raises ClosedError. Closing a context closes what was made from it."""

    _kind = "object"

    def __init__(self, pointer: Any, release: Callable[[Any], None], parent: Handle | None = None) -> None:
        self._pointer = pointer
        self._root: Handle = self if parent is None else parent._root
        if parent is None:
            self._guard = Guard()
            self._children: weakref.WeakSet[Handle] = weakref.WeakSet()
        else:
            self._guard = self._root._guard
            self._root._children.add(self)
        self._finalizer = weakref.finalize(self, self._guard.release, release, pointer)
        _register_end()

    @property
    def closed(self) -> bool:
        """Whether the object was closed."""
        return not self._finalizer.alive

    @property
    def handle(self) -> Any:
        """The C pointer, for calls of `tyndall.capi`. Raises ClosedError if there is none any more."""
        if is_broken():
            note_use()
        if not self._finalizer.alive:
            raise ClosedError(f"this {self._kind} was closed")
        return self._pointer

    def close(self) -> None:
        """Gives the object, and its memory on the device, back. Closing twice is allowed."""
        if self._root is self:
            for child in list(self._children):
                child._finalizer()
        self._finalizer()

    def __enter__(self: _Self) -> _Self:
        _ = self.handle
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None:
        self.close()

    def _call(self, function: Callable[..., int], *arguments: Any) -> None:
        """Calls `function(*arguments)`, and raises what its status stands for, with the context's message."""

        def call() -> None:
            _ = self.handle  # which may have been closed while another thread was waited for
            self._check(function(*arguments))

        self._guard.run(call)

    def _check(self, status: int) -> None:
        """Raises what `status` stands for. The guard is held, so that the message is still this call's."""
        if status == capi.TYN_OK:
            return
        if status == capi.TYN_ERROR_CANCELLED:
            raise CancelledError("the call was cancelled")
        message = capi.lib.tyn_context_message(self._root._pointer).decode(errors="replace")
        raise error_of(status, message)


@cache
def _register_end() -> None:
    """Once, after the first finalizer was made: what is registered last is called first, and finalizers must wait for calls."""
    atexit.register(_end_calls)
