# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""OpenCL objects of callers: pyopencl's, and addresses."""

from __future__ import annotations

import ctypes
import os
import subprocess
import sys
from collections.abc import Iterator
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

import tyndall as ty
from tyndall._core.opencl import cl_buffer, cl_object
from tyndall.errors import ClosedError, InvalidArgumentError, InvalidOperationError

COUNT = 500


@pytest.fixture(scope="module")
def cl() -> Any:
    # pyopencl brings a loader of its own, which may not know where the system's drivers are listed.
    if os.path.isdir("/etc/OpenCL/vendors"):
        os.environ.setdefault("OCL_ICD_VENDORS", "/etc/OpenCL/vendors")
    return pytest.importorskip("pyopencl", reason="pyopencl is not installed")


@pytest.fixture(scope="module")
def theirs(cl: Any, context: ty.Context) -> Any:
    """pyopencl's context and queue on the device that the other tests use."""
    for platform in cl.get_platforms():
        for device in platform.get_devices():
            if (device.name, device.driver_version) == (context.device.name, context.device.driver):
                found = cl.Context([device])
                return SimpleNamespace(context=found, queue=cl.CommandQueue(found), device=device)
    return pytest.skip(f"pyopencl does not see the device {context.device.name}")


@pytest.fixture(scope="module")
def ours(theirs: Any) -> Iterator[ty.Context]:
    with ty.Context.from_cl(theirs.context, theirs.queue) as one:
        yield one


def scene_of(context: ty.Context) -> ty.Scene:
    scene = context.scene()
    scene.add_mesh(*ty.shapes.sphere(1.0, 2), medium=ty.Medium(0.1, 4, g=0.5, ior=1.3))
    scene.commit()
    return scene


@pytest.fixture(scope="module")
def scene(ours: ty.Context) -> Iterator[ty.Scene]:
    with scene_of(ours) as one:
        yield one


def buffer_of(cl: Any, theirs: Any, array: Any) -> Any:
    flags = cl.mem_flags.READ_WRITE | cl.mem_flags.COPY_HOST_PTR
    return cl.Buffer(theirs.context, flags, hostbuf=array)


def room(cl: Any, theirs: Any, count: int, dtype: Any) -> Any:
    return cl.Buffer(theirs.context, cl.mem_flags.READ_WRITE, count * np.dtype(dtype).itemsize)


def read(cl: Any, theirs: Any, buffer: Any, count: int, dtype: Any) -> Any:
    result = np.empty(count, dtype)
    cl.enqueue_copy(theirs.queue, result, buffer)
    return result


def entries() -> Any:
    position = np.random.default_rng(1).uniform(-0.5, 0.5, (COUNT, 3))
    return ty.walk_entries(position, [0, 0, 1])


def test_a_context_on_the_caller_s(theirs: Any, ours: ty.Context, context: ty.Context) -> None:
    assert ours.cl_context == theirs.context.int_ptr
    assert ours.cl_queue == theirs.queue.int_ptr
    assert ours.cl_device == theirs.device.int_ptr
    assert isinstance(ours, ty.Context) and ours.device.name == context.device.name
    with ty.Context.from_cl(theirs.context.int_ptr, theirs.queue.int_ptr, lane_width=4, memory_limit=1 << 26) as other:
        assert (other.device.lane_width, other.device.memory) == (4, ours.device.memory)
        with scene_of(other) as small, scene_of(ours) as usual:
            walked = other.walk(small, entries(), seed=3)
            assert walked.tobytes() == ours.walk(usual, entries(), seed=3).tobytes()


def test_the_context_keeps_what_it_was_made_on(cl: Any, theirs: Any, context: ty.Context) -> None:
    mine = cl.Context([theirs.device])
    made = ty.Context.from_cl(mine, cl.CommandQueue(mine))
    del mine
    with made, scene_of(made) as one, scene_of(context) as other:
        assert made.walk(one, entries()).tobytes() == context.walk(other, entries()).tobytes()


def test_walks_on_buffers(cl: Any, theirs: Any, ours: ty.Context, scene: ty.Scene, context: ty.Context) -> None:
    given, left = buffer_of(cl, theirs, entries()), room(cl, theirs, COUNT, ty.WALK_EXIT)
    options: Any = {"seed": 7, "first_path": 1 << 33, "max_scatterings": 20, "roulette_threshold": 0.5}
    ledger = ours.walk_cl(scene, given, COUNT, left, **options)
    with scene_of(context) as other:
        expected = context.walk(other, entries(), **options)
        without_roulette = context.walk(other, entries(), roulette=False)
    assert read(cl, theirs, left, COUNT, ty.WALK_EXIT).tobytes() == expected.tobytes()
    assert ledger is not None and expected.ledger is not None
    assert repr(ledger) == repr(expected.ledger) and ledger.capped_walks > 0
    assert ours.walk_cl(scene, given, COUNT, left, ledger=False, roulette=False) is None
    assert read(cl, theirs, left, COUNT, ty.WALK_EXIT).tobytes() == without_roulette.tobytes()


def test_rays_on_buffers(cl: Any, theirs: Any, ours: ty.Context, scene: ty.Scene) -> None:
    rays = ty.rays([(x, 0.1, 3) for x in np.linspace(-1.5, 1.5, COUNT)], [0, 0, -1])
    given, hits, met = buffer_of(cl, theirs, rays), room(cl, theirs, COUNT, ty.HIT), room(cl, theirs, COUNT, np.uint32)
    ours.intersect_cl(scene, given, COUNT, hits)
    ours.occluded_cl(scene, given, COUNT, met, mesh=0)
    expected = ours.intersect(scene, rays)
    assert read(cl, theirs, hits, COUNT, ty.HIT).tobytes() == expected.tobytes()
    found = read(cl, theirs, met, COUNT, np.uint32)
    assert np.array_equal(found, (expected["mesh"] == 0).astype(np.uint32)) and 0 < found.sum() < COUNT


def test_arrays_of_pyopencl(cl: Any, theirs: Any, ours: ty.Context, scene: ty.Scene) -> None:
    arrays = pytest.importorskip("pyopencl.array")
    rays = ty.rays([(x, 0.1, 3) for x in np.linspace(-1.5, 1.5, COUNT)], [0, 0, -1])
    given = arrays.to_device(theirs.queue, rays.view(np.float32))
    met = arrays.zeros(theirs.queue, COUNT, np.uint32)
    ours.occluded_cl(scene, given, COUNT, met)
    assert np.array_equal(met.get().astype(bool), ours.occluded(scene, rays))
    with pytest.raises(InvalidArgumentError, match="occluded is an array that begins 4 bytes into its buffer"):
        ours.occluded_cl(scene, given, COUNT - 1, met[1:])
    with pytest.raises(InvalidArgumentError, match=r"occluded is an array of strides \(8,\)"):
        ours.occluded_cl(scene, given, COUNT // 2, met[::2])


def test_buffers_may_go_before_the_work_is_done(cl: Any, theirs: Any, ours: ty.Context, scene: ty.Scene) -> None:
    left = room(cl, theirs, COUNT, ty.WALK_EXIT)
    ours.walk_cl(scene, buffer_of(cl, theirs, entries()), COUNT, left, ledger=False, seed=5)
    assert read(cl, theirs, left, COUNT, ty.WALK_EXIT).tobytes() == ours.walk(scene, entries(), seed=5).tobytes()


def test_a_context_of_ours_in_pyopencl(cl: Any, theirs: Any, context: ty.Context) -> None:
    mine = cl.Context.from_int_ptr(context.cl_context)
    queue = cl.CommandQueue.from_int_ptr(context.cl_queue)
    here = SimpleNamespace(context=mine, queue=queue)
    with scene_of(context) as one:
        left = room(cl, here, COUNT, ty.WALK_EXIT)
        context.walk_cl(one, buffer_of(cl, here, entries()), COUNT, left, ledger=False)
        assert read(cl, here, left, COUNT, ty.WALK_EXIT).tobytes() == context.walk(one, entries()).tobytes()


def test_addresses_without_pyopencl(context: ty.Context) -> None:
    """A second context on the first one's objects needs nothing but numbers."""
    with ty.Context.from_cl(context.cl_context, context.cl_queue) as other:
        assert (other.cl_context, other.cl_queue, other.cl_device) == (context.cl_context, context.cl_queue, context.cl_device)
        assert other.cl_context > 0 and other.device.name == context.device.name
        with scene_of(other) as one, scene_of(context) as two:
            assert other.walk(one, entries()).tobytes() == context.walk(two, entries()).tobytes()
    with pytest.raises(ClosedError):
        _ = other.cl_queue


def test_the_package_does_without_pyopencl() -> None:
    code = "import sys, tyndall; sys.exit('pyopencl' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


# ---- bad input


def test_bad_queues_are_refused(cl: Any, theirs: Any) -> None:
    properties = cl.command_queue_properties.OUT_OF_ORDER_EXEC_MODE_ENABLE
    if not theirs.device.queue_properties & properties:
        pytest.skip("the device has no queues out of order")
    with pytest.raises(InvalidArgumentError, match="order"):
        ty.Context.from_cl(theirs.context, cl.CommandQueue(theirs.context, properties=properties))


def test_queues_of_other_contexts_are_refused(cl: Any, theirs: Any) -> None:
    other = cl.Context([theirs.device])
    with pytest.raises(InvalidArgumentError, match="context"):
        ty.Context.from_cl(other, theirs.queue)


def test_bad_buffers_are_refused(cl: Any, theirs: Any, ours: ty.Context, scene: ty.Scene) -> None:
    given, left = buffer_of(cl, theirs, entries()), room(cl, theirs, COUNT, ty.WALK_EXIT)
    other = SimpleNamespace(context=cl.Context([theirs.device]))
    foreign = room(cl, other, COUNT, ty.WALK_EXIT)
    cases: list[tuple[Any, int, Any, str]] = [
        (given, COUNT + 1, left, f"entries has {COUNT * 96} bytes; {COUNT + 1} elements of 96 bytes do not fit"),
        (given, COUNT, room(cl, theirs, 1, ty.WALK_EXIT), "exits has 96 bytes"),
        (given, COUNT, foreign, "exits belongs to another cl_context"),
        (None, COUNT, left, "entries is None; it must be an object of pyopencl's"),
        (given, COUNT, entries(), "exits is .*; it must be an object of pyopencl's"),
        (given, -1, left, "count is -1"),
        (given, 1 << 64, left, "count is 18446744073709551616"),
        (given, 0.5, left, "count is 0.5"),  # type: ignore[list-item]
    ]
    for first, count, second, said in cases:
        with pytest.raises(InvalidArgumentError, match=said):
            ours.walk_cl(scene, first, count, second)
    with pytest.raises(InvalidArgumentError, match="rays has"):
        ours.intersect_cl(scene, room(cl, theirs, 1, ty.RAY), 2, left)
    with pytest.raises(InvalidArgumentError, match="occluded has"):
        ours.occluded_cl(scene, given, COUNT, room(cl, theirs, 1, np.uint32))
    with pytest.raises(InvalidArgumentError, match="mesh is 1"):
        ours.occluded_cl(scene, given, COUNT, left, mesh=1)
    with ours.scene() as fresh, pytest.raises(InvalidOperationError, match="not committed"):
        ours.walk_cl(fresh, given, COUNT, left)
    assert ours.walk_cl(scene, given, 0, left, ledger=False) is None


def test_bad_entries_on_buffers_are_lost(cl: Any, theirs: Any, ours: ty.Context, scene: ty.Scene) -> None:
    bad = entries()
    bad["mesh"][:10] = 5
    left = room(cl, theirs, COUNT, ty.WALK_EXIT)
    ledger = ours.walk_cl(scene, buffer_of(cl, theirs, bad), COUNT, left)
    assert ledger is not None and ledger.lost_walks == 10 and ledger.walks == COUNT


@pytest.mark.parametrize("value", [None, 0, -1, True, 1.5, "queue", object(), np.arange(3)])
def test_what_is_not_an_object_of_opencl_is_refused(value: Any) -> None:
    for check in (cl_object, cl_buffer):
        with pytest.raises(InvalidArgumentError, match=r"thing is .*; it must be an object of pyopencl's, or the address"):
            check(value, "thing")
    with pytest.raises(InvalidArgumentError, match="context is "):
        ty.Context.from_cl(value, 1)


@pytest.mark.parametrize("address", [0x7F0012345678, np.uint64(0x7F0012345678), SimpleNamespace(int_ptr=0x7F0012345678)])
def test_addresses_of_objects(address: Any) -> None:
    assert cl_object(address, "thing") == cl_buffer(address, "thing") == 0x7F0012345678
    assert ctypes.sizeof(ctypes.c_void_p) == 8
