# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""What the Python package costs: the time of its import beside numpy's, and what it adds to batch calls of the C API, which
are made through the package and through tyndall.capi with everything prepared, in turns.

    PYTHONPATH=bindings/python TYNDALL_LIBRARY=build/release/lib/libtyndall.so.0 python3 tests/bench/python_overhead.py
"""

from __future__ import annotations

import ctypes
import statistics
import subprocess
import sys
import time
from typing import Callable

import numpy as np

import tyndall as ty
from tyndall import capi
from tyndall._core.arrays import data, record_data
from tyndall._slab.layers import slab_record

ROUNDS = 1000


def microseconds(calls: list[Callable[[], object]]) -> list[float]:
    """The time of each call, which take turns: the first decile, as kernels that wait for threads to wake up vary by more than
    what is looked for."""
    times: list[list[float]] = [[] for _ in calls]
    for _ in range(ROUNDS):
        for call, own in zip(calls, times):
            begin = time.perf_counter()
            call()
            own.append(time.perf_counter() - begin)
    return [1e6 * statistics.quantiles(own, n=10)[0] for own in times]


def import_seconds(module: str) -> float:
    def once() -> float:
        begin = time.perf_counter()
        subprocess.run([sys.executable, "-c", f"import {module}"], check=True)
        return time.perf_counter() - begin

    return statistics.median(once() for _ in range(11))


def cases(context: ty.Context) -> dict[str, tuple[Callable[[], object], Callable[[], object]]]:
    """By name: a batch of one through the package, and through the C API."""
    lib = capi.lib
    medium = ty.Medium(0.1, 10.0, g=0.8)
    model = context.bssrdf("standard-dipole", medium)
    radii, floats = np.ones(1, np.float32), np.empty(1, np.float32)
    scene = context.scene()
    scene.add_mesh(*ty.shapes.sphere(1.0, 3), medium=medium)
    scene.commit()
    rays = ty.rays([0, 0, 5], [0, 0, -1])
    hits = np.empty(1, ty.HIT)
    entries = ty.walk_entries([0, 0, 0.9], [0, 0, 1])
    exits, ledger, walk = np.empty(1, ty.WALK_EXIT), capi.TynLedger(), capi.TynWalkOptions()
    cosines, values, phase = np.ones(1), np.empty(1), ty.Phase.henyey_greenstein(0.5)
    slab, options = slab_record(medium, 1.0, 1.0), capi.TynSlabOptions(photons=1)

    def raw_slab() -> None:
        result = ctypes.POINTER(capi.TynSlabResult)()
        lib.tyn_slab_simulate(context.handle, ctypes.byref(slab), ctypes.byref(options), ctypes.byref(result))
        lib.tyn_slab_result_release(result)

    ray, hit = record_data(rays, capi.TynRay), record_data(hits, capi.TynHit)
    entry, exit_ = record_data(entries, capi.TynWalkEntry), record_data(exits, capi.TynWalkExit)
    return {
        "Bssrdf.profile": (
            lambda: model.profile(radii),
            lambda: lib.tyn_bssrdf_profile(model.handle, data(radii), 1, data(floats)),
        ),
        "Context.intersect": (
            lambda: context.intersect(scene, rays),
            lambda: lib.tyn_intersect(scene.handle, capi.TYN_NONE, ray, 1, hit),
        ),
        "Context.walk": (
            lambda: context.walk(scene, entries),
            lambda: lib.tyn_walk(scene.handle, ctypes.byref(walk), entry, 1, exit_, ctypes.byref(ledger)),
        ),
        "Context.slab": (lambda: context.slab(medium, photons=1), raw_slab),
        "Phase.value": (
            lambda: phase.value(cosines),
            lambda: lib.tyn_phase_value(ctypes.byref(phase.record), data(cosines), 1, data(values)),
        ),
    }


def main() -> None:
    seconds, numpy_seconds = import_seconds("tyndall"), import_seconds("numpy")
    nothing = import_seconds("sys")
    print(f"import tyndall  {seconds:.3f} s, of which numpy {numpy_seconds - nothing:.3f} s and Python {nothing:.3f} s\n")
    print(f"{'a batch of one, microseconds':<30}{'package':>10}{'C API':>10}{'added':>10}")
    with ty.Context() as context:
        for name, calls in cases(context).items():
            package, raw = microseconds(list(calls))
            print(f"{name:<30}{package:>10.1f}{raw:>10.1f}{package - raw:>10.1f}")


if __name__ == "__main__":
    main()
