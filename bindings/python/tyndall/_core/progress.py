# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Long calls: what they report, and what may stop them."""

from __future__ import annotations

import signal
import threading

# Not signal.getsignal, which makes an enumeration of each answer: most of what a short call would cost.
from types import FrameType, TracebackType
from typing import Any, Callable, Union

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
    run before its first statement. So in the main thread they are put off while the call lasts: one that has come runs at
    the next report, and what it raises (KeyboardInterrupt, for Ctrl-C) cancels the call and is raised when the block ends.
    """

    def __init__(self, progress: Progress, label: str) -> None:
        self._bar = _Bar(label) if progress is True else None
        self._listener: Callable[[float], object] | None = self._bar or (progress if callable(progress) else None)
        if progress not in (None, True, False) and not callable(progress):
            raise TypeError(f"progress is {progress!r}; it must be a bool, a function of the fraction done, or None")
        self._error: BaseException | None = None
        self._handlers: dict[int, Callable[[int, FrameType | None], Any]] = {}
        self._arrived: list[tuple[int, FrameType | None]] = []
        self.callback = capi.TynProgress(self._report)

    def _report(self, user: object, fraction: float) -> int:
        try:
            self._run_handlers()
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
            for number in _SIGNALS:
                handler = signal.getsignal(number)
                if callable(handler):
                    self._handlers[number] = handler
                    signal.signal(number, self._note)
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None:
        for number, handler in self._handlers.items():
            if signal.getsignal(number) == self._note:
                signal.signal(number, handler)
        if self._bar is not None:
            self._bar.close()
        if self._error is not None:
            raise self._error from None
        self._run_handlers()


# Those that programs handle by raising something. (To look at every signal there is takes longer than a small call.)
_SIGNALS = tuple(getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGALRM", "SIGHUP") if hasattr(signal, name))
