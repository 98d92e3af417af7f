# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Tyndall inside a program that already uses OpenCL: its context, queue and buffers (tyndall_cl.h).

They are given as pyopencl's objects, or as addresses, integers; pyopencl itself is not needed. Its own loader and the system's
may both be in the program, as OpenCL objects carry the functions of their driver.

Queues are in order. What a call enqueues runs after what was enqueued before on the same queue, and is done when something
enqueued after it is, or when the queue is finished; work on other queues must wait for that. OpenCL keeps the buffers of
enqueued work alive, so they may be released at once; host memory under a buffer (USE_HOST_PTR) is the caller's to keep until
the queue is finished."""

from __future__ import annotations

import ctypes
from typing import Any, TypeVar

from . import capi
from ._core.context import ContextHandle, context_options, create
from ._core.handles import Handle
from ._core.numbers import UINT64, integer
from ._core.opencl import cl_buffer, cl_object
from ._scene.scene import Scene, mesh_choice, scene_of
from ._walk.calls import walk_options
from ._walk.ledger import Ledger

_Self = TypeVar("_Self", bound="InteropCalls")


class InteropCalls(ContextHandle):
    """The calls of a context on OpenCL's own objects."""

    @classmethod
    def from_cl(
        cls: type[_Self],
        context: Any,
        queue: Any,
        *,
        memory_limit: int = 0,
        lane_width: int = 0,
        cache_directory: str | None = None,
    ) -> _Self:
        """A context on the caller's OpenCL context and queue, both of which it keeps alive. Its device is the queue's.

        context: a pyopencl.Context, or the address of a cl_context.
        queue: a pyopencl.CommandQueue of that context, in order, or the address of a cl_command_queue. Made with profiling
            enabled, it lets a renderer say where its time went.
        memory_limit, lane_width, cache_directory: as for Context().

        Errors: InvalidArgumentError, OutOfMemoryError, DeviceError. An address that is not of such an object is not noticed.
        """
        options = context_options(memory_limit, lane_width, cache_directory)
        pointer = create(
            options, capi.lib.tyn_context_create_cl, cl_object(context, "context"), cl_object(queue, "queue")
        )  # fmt: skip
        self = cls.__new__(cls)
        Handle.__init__(self, pointer, capi.lib.tyn_context_release)
        return self

    @property
    def cl_context(self) -> int:
        """The address of the cl_context, valid as long as this context: `pyopencl.Context.from_int_ptr(address)` keeps it."""
        return self._cl_addresses()[0]

    @property
    def cl_queue(self) -> int:
        """The address of the cl_command_queue, in order, valid as long as this context."""
        return self._cl_addresses()[1]

    @property
    def cl_device(self) -> int:
        """The address of the cl_device_id."""
        return self._cl_addresses()[2]

    def _cl_addresses(self) -> tuple[int, int, int]:
        found = [ctypes.c_void_p() for _ in range(3)]
        self._call(capi.lib.tyn_context_cl, self.handle, *(ctypes.byref(one) for one in found))
        context, queue, device = (one.value or 0 for one in found)
        return context, queue, device

    def intersect_cl(self, scene: Scene, rays: Any, count: int, hits: Any, *, mesh: int | None = None) -> None:
        """`intersect` on buffers. Only enqueues: see `tyndall.interop`. The rays are not checked.

        rays: buffer of `count` RAY, of the context's cl_context. hits: buffer that receives `count` HIT.
        mesh: index of the only mesh to look at; None: the whole scene.
        """
        scene_of(self, scene)._call(
            capi.lib.tyn_intersect_cl, scene.handle, mesh_choice(mesh), cl_buffer(rays, "rays"), _count(count),
            cl_buffer(hits, "hits"),
        )  # fmt: skip

    def occluded_cl(self, scene: Scene, rays: Any, count: int, occluded: Any, *, mesh: int | None = None) -> None:
        """`occluded` on buffers. occluded: buffer that receives `count` uint32, 1 or 0. The rest as for `intersect_cl`."""
        scene_of(self, scene)._call(
            capi.lib.tyn_occluded_cl, scene.handle, mesh_choice(mesh), cl_buffer(rays, "rays"), _count(count),
            cl_buffer(occluded, "occluded"),
        )  # fmt: skip

    def walk_cl(
        self,
        scene: Scene,
        entries: Any,
        count: int,
        exits: Any,
        *,
        ledger: bool = True,
        seed: int = 0,
        first_path: int = 0,
        max_scatterings: int = 0,
        roulette_threshold: float = 0.1,
        roulette: bool = True,
    ) -> Ledger | None:
        """`walk` on buffers. The entries are not checked, except that an index out of range ends its walk as "lost".

        entries: buffer of `count` WALK_ENTRY, of the context's cl_context. exits: buffer that receives `count` WALK_EXIT.
        ledger: True: waits, and returns the ledger. False: only enqueues (see `tyndall.interop`), and returns None.
        The rest as for `walk`.
        """
        options = walk_options(seed, first_path, max_scatterings, roulette_threshold, roulette)
        sums = capi.TynLedger() if ledger else None
        scene_of(self, scene)._call(
            capi.lib.tyn_walk_cl, scene.handle, ctypes.byref(options), cl_buffer(entries, "entries"), _count(count),
            cl_buffer(exits, "exits"), None if sums is None else ctypes.byref(sums),
        )  # fmt: skip
        return None if sums is None else Ledger.of(sums)


def _count(count: int) -> int:
    """ctypes would take any integer and keep its lowest bits."""
    return integer(count, "count", 0, UINT64)
