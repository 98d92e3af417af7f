# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""An OpenCL driver from PyPI (the extra ``cpu``: Intel's, for x86-64 processors of any make), for machines that have none.
It is used only where neither the system nor the environment names a driver."""

from __future__ import annotations

import ctypes
import os
import sys
from pathlib import Path

_LIBRARIES = Path(sys.prefix) / "lib"
_DRIVER = _LIBRARIES / "libintelocl.so"
# What the driver is linked with, in an order in which each finds what it needs; it has no path to them.
_NEEDED = ("libintlc.so.5", "libimf.so", "libirng.so", "libsvml.so")
# By the first Khronos's loader knows a driver's file, by the second Debian's.
_VARIABLES = ("OCL_ICD_FILENAMES", "OCL_ICD_VENDORS")


def _wanted() -> bool:
    if not _DRIVER.exists() or any(os.environ.get(variable) for variable in _VARIABLES):
        return False
    return not any(Path("/etc/OpenCL/vendors").glob("*.icd"))


def offer() -> None:
    """Makes the OpenCL loader find the driver, through variables of the environment. Before the loader is first asked."""
    if _wanted():
        try:
            for name in _NEEDED:
                ctypes.CDLL(str(_LIBRARIES / name))
        except OSError:  # they were not installed with it
            return
        for variable in _VARIABLES:
            os.environ[variable] = str(_DRIVER)


def loader() -> Path | None:
    """The OpenCL loader that comes with the driver, for systems that have none; None if it is not there."""
    path = _LIBRARIES / "libOpenCL.so.1"
    return path if path.exists() else None


def environment() -> dict[str, str]:
    """The environment of a program that shall find the driver, too."""
    variables = dict(os.environ)
    if variables.get("OCL_ICD_FILENAMES") == str(_DRIVER):
        paths = [str(_LIBRARIES), *filter(None, [variables.get("LD_LIBRARY_PATH")])]
        variables["LD_LIBRARY_PATH"] = os.pathsep.join(paths)
    return variables
