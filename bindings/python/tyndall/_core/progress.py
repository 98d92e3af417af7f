# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Long calls: what they report, and what may stop them."""

from __future__ import annotations

# The module that signal's functions call, and make enumerations of what it says: most of what a short call would cost.
import _signal  # type: ignore[import-not-found]
import signal
import threading
from types import FrameType, TracebackType
from typing import Any, Callable, ClassVar, Union

from .. import capi

Progress = Union[bool, Callable[[float], object], None]
"""What a long call's `progress` may be: True for a bar (tqdm, of the extra ``progress``), a function that is called with the
fraction done in [0, 1] and that cancels the call by returning something true, or None or False for silence."""


class _Bar:
    def __init__(self, label: str) -> None:
        try:
            from tqdm.auto import tqdm
        except ModuleNotFoundError:
            raise ModuleNotFoundError("progress=True needs tqdm: pip install 'tyndall[progress]'", name="tqdm") from None
        self._bar = tqdm(
            total=1.0, desc=label, bar_format="{desc}: {percentage:3.0f} %|{bar}| {elapsed}, {remaining} left", leave=True
        )

    def __call__(self, fraction: float) -> None:
        self._bar.update(max(0.0, fraction - self._bar.n))

    def close(self) -> None:
        self._bar.close()


class LongCall:
    """A call that reports: `with LongCall(progress, "walk") as call:` hand `call.callback` to the library.

    An exception must not leave the callback, as ctypes would print it and go on; and in a callback the handlers of signals
    run before its first statement. So in the main thread they are put off while the block lasts: one that has come runs at
    the next report, and what it raises (KeyboardInterrupt, for Ctrl-C) cancels the call and is raised when the block ends.
    """

    _innermost: ClassVar[LongCall | None] = None  # of the main thread
    _process_ends: ClassVar[bool] = False

    def __init__(self, progress: Progress, label: str) -> None:
        if progress is not None and not isinstance(progress, bool) and not callable(progress):
            raise TypeError(f"progress is {progress!r}; it must be a bool, a function of the fraction done, or None")
        self._bar = _Bar(label) if progress is True else None
        self._listener: Callable[[float], object] | None = self._bar or (progress if callable(progress) else None)
        self._error: BaseException | None = None
        self._outer: LongCall | None = None
        self._before: dict[int, Any] = {}  # what is put back
        self._handlers: dict[int, Callable[[int, FrameType | None], Any]] = {}
        self._arrived: list[tuple[int, FrameType | None]] = []
        self.callback: Any = capi.TynProgress(self._report)

    def _report(self, user: object, fraction: float) -> int:
        try:
            self._run_handlers()
            if LongCall._process_ends:
                return 1
            return 1 if self._listener is not None and self._listener(fraction) else 0
        except BaseException as error:
            self._error = error
            return 1

    def _run_handlers(self) -> None:
        while self._arrived:
            number, frame = self._arrived.pop(0)
            self._handlers[number](number, frame)

    def _note(self, number: int, frame: FrameType | None) -> None:
        self._arrived.append((number, frame))

    def __enter__(self) -> LongCall:
        if threading.current_thread() is threading.main_thread():
            self._outer, LongCall._innermost = LongCall._innermost, self
            for number in _SIGNALS:
                handler = _signal.getsignal(number)
                if callable(handler):
                    self._before[number] = handler
                    # within another call's report: that call ends by what this one raises
                    self._handlers[number] = self._outer._handlers.get(number, handler) if self._outer else handler
                    _signal.signal(number, self._note)
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None:
        for number, handler in self._before.items():
            if _signal.getsignal(number) == self._note:
                _signal.signal(number, handler)
        if LongCall._innermost is self:
            LongCall._innermost = self._outer
        if self._bar is not None:
            self._bar.close()
        raised = self._error
        self.callback = self._listener = self._bar = self._error = None  # which refer to this object in turn
        try:
            if raised is not None:
                raise raised from None
        finally:
            self._run_handlers()

    @classmethod
    def signals_are_put_off(cls) -> bool:
        """Whether this thread is inside such a block and has its signals put off."""
        return cls._innermost is not None and threading.current_thread() is threading.main_thread()

    @classmethod
    def run_signals(cls) -> None:
        """Runs the handlers of what has come: where such a block waits outside the library."""
        if cls._innermost is not None:
            cls._innermost._run_handlers()

    @classmethod
    def end_all(cls) -> None:
        """Cancels every call at its next report: the process ends."""
        cls._process_ends = True


# Those that programs handle by raising something. (To look at every signal there is takes longer than a small call.)
_SIGNALS = tuple(getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGALRM", "SIGHUP") if hasattr(signal, name))
