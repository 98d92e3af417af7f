#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""tyn_mie against the PyPI package miepython: efficiencies, mean cosine and phase function on a grid of spheres.

miepython writes m = n - i k where tyn_mie writes m = n + i k. It truncates its series earlier and starts its recurrences
closer to the turning point, so the two are not expected to agree to the last digit: the tolerances are its accuracy.
Exit status 77 where miepython is missing.
"""
import ctypes
import math
import os
import sys

os.environ.setdefault("MIEPYTHON_USE_JIT", "0")  # compiling would take longer than the whole test
try:
    import miepython
    import numpy
except ImportError as error:
    print(f"miepython cannot be imported: {error}")
    sys.exit(77)

SIZES = [1e-3, 0.01, 0.1, 0.5, 1.0, 2.0, 5.213, 10.0, 37.7, 100.0, 1000.0, 10000.0]
INDICES = [(1.05, 0.0), (1.33, 0.0), (1.33, 1e-5), (1.5, 0.0), (1.5, 0.1), (1.55, 0.0), (0.75, 0.0), (2.5, 0.0),
           (1.5, 1.0), (0.2, 3.0), (10.0, 10.0)]
ANGLES = [0.0, 1e-3, 0.01, 0.1, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 3.14, math.pi]
EFFICIENCY_TOLERANCE = 1e-6   # relative to q_ext
BACK_TOLERANCE = 5e-6         # relative to q_back, or to 1 % of q_ext: a sum that cancels, so that truncation shows
COSINE_TOLERANCE = 1e-6
PHASE_TOLERANCE = 1e-5        # relative to p, or to 1e-5 of its peak where waves cancel


class Mie(ctypes.Structure):
    _fields_ = [(name, ctypes.c_double) for name in ("q_ext", "q_sca", "q_abs", "q_back", "mean_cosine")]


def load():
    library = ctypes.CDLL(os.path.join(os.environ["TYNDALL_LIB_DIR"], "libtyndall.so"))
    pointer = ctypes.POINTER(ctypes.c_double)
    library.tyn_mie.argtypes = [ctypes.c_double, pointer, ctypes.POINTER(Mie), pointer, ctypes.c_size_t, pointer]
    library.tyn_mie.restype = ctypes.c_int32
    return library


def tyndall(library, x, index, cosines):
    mie = Mie()
    values = (ctypes.c_double * len(cosines))()
    status = library.tyn_mie(x, (ctypes.c_double * 2)(*index), ctypes.byref(mie),
                             (ctypes.c_double * len(cosines))(*cosines), len(cosines), values)
    assert status == 0, f"tyn_mie({x}, {index}) returned {status}"
    return mie, numpy.array(values)


def compare(library, x, index, cosines, worst):
    mie, values = tyndall(library, x, index, cosines)
    m = complex(index[0], -index[1])
    q_ext, q_sca, q_back, g = miepython.efficiencies_mx(m, x)
    expected = numpy.asarray(miepython.i_unpolarized(m, x, numpy.array(cosines), norm="one"))
    floor = 1e-5 * expected.max()
    errors = {
        "q_ext": abs(mie.q_ext - q_ext) / q_ext / EFFICIENCY_TOLERANCE,
        "q_sca": abs(mie.q_sca - q_sca) / q_ext / EFFICIENCY_TOLERANCE,
        "q_back": abs(mie.q_back - q_back) / max(q_back, 1e-2 * q_ext) / BACK_TOLERANCE,
        "mean cosine": abs(mie.mean_cosine - g) / COSINE_TOLERANCE,
        "phase function": float(numpy.max(abs(values - expected) / numpy.maximum(expected, floor))) / PHASE_TOLERANCE,
    }
    failures = 0
    for name, error in errors.items():
        worst[name] = max(worst.get(name, 0.0), error)
        if not error <= 1:
            print(f"x = {x}, m = {index[0]} + {index[1]} i: {name} is off by {error:.3g} times the tolerance")
            failures += 1
    return failures


def main():
    library = load()
    cosines = [max(-1.0, math.cos(angle)) for angle in ANGLES]
    worst = {}
    failures = sum(compare(library, x, index, cosines, worst) for x in SIZES for index in INDICES)
    print(f"{len(SIZES) * len(INDICES)} spheres, {len(ANGLES)} angles against miepython {miepython.__version__}; "
          "worst errors in units of the tolerance:")
    for name, error in worst.items():
        print(f"  {name}: {error:.3g}")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
