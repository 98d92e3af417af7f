# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""The package in one process with others, some of which bring a C++ runtime, LLVM, Embree or an OpenCL loader of their own:
kernels still compile. In new processes, without a cache, with the package imported first and last."""

from __future__ import annotations

import importlib.util
import os
import subprocess
import sys
from pathlib import Path

import pytest

OTHERS = ["numpy", "scipy.stats", "matplotlib", "pyopencl", "OpenEXR", "mitsuba"]

PROGRAM = """
import importlib, sys
for name in sys.argv[1].split(","):
    importlib.import_module(name)
if "mitsuba" in sys.modules:
    sys.modules["mitsuba"].set_variant("llvm_ad_rgb")
import tyndall as ty
with ty.Context(cache_directory="") as context:
    result = context.slab(ty.Medium(1, 9, g=0.75), photons=1000)
runtimes = {line.split()[-1] for line in open("/proc/self/maps") if "libstdc++" in line}
print(float(result.reflectance.total[0]), len(runtimes))
"""


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="reads /proc")
@pytest.mark.parametrize("first", [True, False])
def test_kernels_compile_beside_other_packages(first: bool, tmp_path: Path) -> None:
    there = [name for name in OTHERS if importlib.util.find_spec(name.partition(".")[0]) is not None]
    names = ["tyndall", *there] if first else [*there, "tyndall"]
    environment = {**os.environ, "POCL_CACHE_DIR": str(tmp_path)}
    command = [sys.executable, "-c", PROGRAM, ",".join(names)]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stderr
    reflectance, runtimes = done.stdout.split()
    assert 0.1 < float(reflectance) < 0.3
    assert int(runtimes) == 1
