# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Interrupts, forks, exits and garbage collection in the middle of calls: a context stays usable, a process never hangs."""

from __future__ import annotations

import gc
import os
import signal
import subprocess
import sys
import threading
import time
import weakref
from typing import Any

import pytest

import tyndall as ty
from tyndall import errors

THIN = ty.Layer(ty.Medium(0.5, 1.0), 0.1)
PHOTONS_FOR_EVER = 10**13

needs_alarms = pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="the system has no timers")


class Interrupted(Exception):
    pass


def interrupt(*_: Any) -> None:
    raise Interrupted


@pytest.fixture
def alarms() -> Any:
    before = signal.signal(signal.SIGALRM, interrupt)
    yield
    signal.setitimer(signal.ITIMER_REAL, 0)
    signal.signal(signal.SIGALRM, before)


@needs_alarms
def test_interrupts_between_short_calls_leave_the_context_free(alarms: None) -> None:
    """At any place of the Python code: 300 of them."""
    with ty.Context() as context:
        for number in range(300):
            with pytest.raises(Interrupted):
                signal.setitimer(signal.ITIMER_REAL, 0.0002 + 1e-6 * (number % 100))
                while True:
                    _ = context.device
        assert context.device.name
        done = threading.Thread(target=lambda: context.device, daemon=True)
        done.start()
        done.join(10)
        assert not done.is_alive()


@needs_alarms
def test_an_interrupt_ends_the_wait_for_another_thread(alarms: None) -> None:
    with ty.Context() as context:
        stop = threading.Event()
        inside = threading.Event()

        def listen(_: float) -> bool:
            inside.set()
            return stop.is_set()

        def other() -> None:
            with pytest.raises(errors.CancelledError):
                context.slab(THIN, photons=PHOTONS_FOR_EVER, progress=listen)

        thread = threading.Thread(target=other)
        thread.start()
        assert inside.wait(30)
        signal.setitimer(signal.ITIMER_REAL, 0.2)
        with pytest.raises(Interrupted):
            context.slab(THIN, photons=1000)
        assert thread.is_alive()  # it was not what ended the wait
        stop.set()
        thread.join()


@needs_alarms
def test_an_interrupt_in_a_nested_call_ends_both(alarms: None) -> None:
    with ty.Context() as outer, ty.Context() as inner:

        def nested(_: float) -> None:
            signal.setitimer(signal.ITIMER_REAL, 0.1)
            inner.slab(THIN, photons=PHOTONS_FOR_EVER)

        with pytest.raises(Interrupted):
            outer.slab(THIN, photons=PHOTONS_FOR_EVER, progress=nested)
        assert signal.getsignal(signal.SIGALRM) is interrupt
        assert inner.slab(THIN, photons=1000) and outer.slab(THIN, photons=1000)


@needs_alarms
def test_an_interrupt_is_not_lost_beside_another_exception(alarms: None, context: ty.Context) -> None:
    def fail(_: float) -> None:
        signal.raise_signal(signal.SIGALRM)
        raise ValueError("mine")

    with pytest.raises(Interrupted) as caught:
        context.slab(THIN, photons=PHOTONS_FOR_EVER, progress=fail)
    assert isinstance(caught.value.__context__, ValueError)


@needs_alarms
def test_an_interrupted_commit_is_known(alarms: None, context: ty.Context) -> None:
    with context.scene() as scene:
        scene.add_mesh(*ty.shapes.sphere(1.0, 5), medium=ty.Medium(0.1, 1.0))
        signal.setitimer(signal.ITIMER_REAL, 0.005)
        with pytest.raises(Interrupted):
            scene.commit()
            time.sleep(10)
        if not scene.committed:
            scene.commit()
        assert len(context.walk(scene, [[0, 0, 0]], [[0, 0, 1]])) == 1


def test_a_context_closed_in_its_own_call_still_gives_what_was_done() -> None:
    context = ty.Context()

    def close(_: float) -> bool:
        context.close()
        return True

    with pytest.raises(errors.CancelledError) as caught:
        context.slab(THIN, photons=PHOTONS_FOR_EVER, progress=close)
    assert caught.value.result.run.photons > 0
    with pytest.raises(errors.ClosedError):
        _ = context.device


def test_what_a_call_was_given_goes_with_it(context: ty.Context) -> None:
    class Listener:
        def __call__(self, fraction: float) -> None:
            pass

    gc.collect()
    gc.disable()
    try:
        listener = Listener()
        gone = weakref.ref(listener)
        context.slab(THIN, photons=1000, progress=listener)
        del listener
        assert gone() is None
    finally:
        gc.enable()


def run(program: str, status: int = 0) -> str:
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=120)
    assert done.returncode == status, done.stderr
    return done.stdout


def test_the_end_of_the_process_ends_calls_of_daemon_threads() -> None:
    program = """
import threading, time, tyndall as ty
context = ty.Context()
inside = threading.Event()
def work():
    context.slab(ty.Layer(ty.Medium(0.5, 1.0), 0.1), photons=10**13, progress=lambda fraction: inside.set())
threading.Thread(target=work, daemon=True).start()
assert inside.wait(60)
print("end")
"""
    assert run(program) == "end\n"


@pytest.mark.skipif(not hasattr(os, "fork"), reason="the system has no fork")
@pytest.mark.filterwarnings("ignore::DeprecationWarning")
def test_forked_processes_are_told() -> None:
    program = """
import os, tyndall as ty
context = ty.Context()
scene = context.scene()
if os.fork() == 0:
    said = []
    for call in (lambda: context.device, ty.Context, ty.devices, lambda: scene.info):
        try:
            call()
        except ty.errors.InvalidOperationError as error:
            said.append("spawn" in str(error))
    del scene
    context.close()
    print(said, flush=True)
else:
    os.wait()
    print(context.device.name != "")
"""
    assert run(program) == "[True, True, True, True]\nTrue\n"


def test_a_fork_before_the_first_use_is_allowed() -> None:
    program = """
import os, tyndall as ty
if os.fork() == 0:
    print(ty.Context().device.name != "", flush=True)
    os._exit(0)
os.wait()
"""
    if hasattr(os, "fork"):
        assert run(program) == "True\n"


@pytest.mark.parametrize("name", [7, True, b"a\0b", "a\0b", "\udc80", 1.5])
def test_names_are_strings(name: Any, context: ty.Context) -> None:
    with context.scene() as scene, pytest.raises(errors.InvalidArgumentError, match="name is "):
        scene.add_mesh(*ty.shapes.box(), name=name)
