# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Objects that own something of the library's: closing them, and keeping threads apart."""

from __future__ import annotations

import threading
import weakref
from collections import deque
from types import TracebackType
from typing import Any, Callable, TypeVar

from .. import capi
from ..errors import CancelledError, ClosedError, InvalidOperationError
from .status import error_of

_Self = TypeVar("_Self", bound="Handle")


class Guard:
    """Lets one thread at a time use a context and what was made from it, as the C API asks for. What is released while
    another thread is inside, or by the garbage collector in the middle of a call, is put off until the guard is free."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._owner: int | None = None
        self._released: deque[tuple[Callable[[Any], None], Any]] = deque()

    def __enter__(self) -> None:
        me = threading.get_ident()
        if self._owner == me:
            raise InvalidOperationError("a context cannot be used from the progress callback of its own call")
        self._lock.acquire()
        self._owner = me

    def __exit__(self, *_: object) -> None:
        self._release_all()
        self._owner = None
        self._lock.release()
        if self._released:
            self._try_release_all()

    def release(self, function: Callable[[Any], None], pointer: Any) -> None:
        """Calls `function(pointer)`, now or as soon as no call is under way."""
        self._released.append((function, pointer))
        self._try_release_all()

    def _try_release_all(self) -> None:
        if self._lock.acquire(blocking=False):
            try:
                self._release_all()
            finally:
                self._lock.release()

    def _release_all(self) -> None:
        while self._released:
            function, pointer = self._released.popleft()
            function(pointer)


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

    @property
    def closed(self) -> bool:
        """Whether the object was closed."""
        return not self._finalizer.alive

    @property
    def handle(self) -> Any:
        """The C pointer, for calls of `tyndall.capi`. Raises ClosedError if there is none any more."""
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
        with self._guard:
            _ = self.handle  # another thread may have closed it while this one waited
            self._check(function(*arguments))

    def _check(self, status: int) -> None:
        """Raises what `status` stands for. The guard is held, so that the message is still this call's."""
        if status == capi.TYN_OK:
            return
        message = capi.lib.tyn_context_message(self._root.handle).decode(errors="replace")
        if status == capi.TYN_ERROR_CANCELLED:
            raise CancelledError("the call was cancelled")
        raise error_of(status, message)
