# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Which files the library is loaded from. The folder of the package comes first, then what the system's loader finds;
the environment variable TYNDALL_LIBRARY names another file before both. libtyndall-io is looked for beside libtyndall."""

from __future__ import annotations

import ctypes
import os
import sys
from pathlib import Path
from typing import Any

from . import driver, tyndall, tyndall_base, tyndall_bssrdf, tyndall_cl, tyndall_exact, tyndall_io, tyndall_phase, tyndall_slab
from .record import Signatures

_HEADERS = (tyndall_base, tyndall_phase, tyndall_slab, tyndall_exact, tyndall_bssrdf, tyndall, tyndall_cl)


def _file_name(stem: str) -> str:
    major = tyndall_base.TYN_VERSION_MAJOR
    if sys.platform == "darwin":
        return f"lib{stem}.{major}.dylib"
    if sys.platform == "win32":
        return f"{stem}.dll"
    return f"lib{stem}.so.{major}"


def _packaged(stem: str) -> Path | None:
    """The file inside the package. An editable installation has a second folder beside the sources."""
    package = sys.modules[__name__.partition(".")[0]]
    for folder in package.__path__:
        path = Path(folder) / "_lib" / _file_name(stem)
        if path.exists():
            return path
    return None


def _open(path: str) -> ctypes.CDLL:
    try:
        return ctypes.CDLL(path)
    except OSError as error:
        if "libOpenCL" not in str(error):
            source = (
                "" if os.path.dirname(path) else "; this package has none of its own: pip install it, or set TYNDALL_LIBRARY"
            )
            raise ImportError(f"the Tyndall library was not loaded: {error}{source}") from None
        hint = f"{error} (the OpenCL loader: Debian and Ubuntu have it as ocl-icd-libopencl1)"
    loader = driver.loader()
    if loader is None:
        raise ImportError(f"the Tyndall library was not loaded: {hint}")
    ctypes.CDLL(str(loader))  # what has been loaded under a name is found by it
    return ctypes.CDLL(path)


def _declare(library: ctypes.CDLL, path: str, signatures: Signatures) -> None:
    for name, (result, arguments) in signatures.items():
        try:
            function = getattr(library, name)
        except AttributeError:
            raise ImportError(f"{path} is not the Tyndall library of this package: it has no {name}") from None
        function.restype = result
        function.argtypes = arguments


def _version_text(version: int) -> str:
    return f"{version // 10000}.{version // 100 % 100}.{version % 100}"


def _check_version(library: ctypes.CDLL, path: str) -> None:
    """Before 1.0 a minor version may change the interface; a patch never does."""
    try:
        loaded = library.tyn_version()
    except AttributeError:
        raise ImportError(f"{path} is not a Tyndall library: it has no tyn_version") from None
    expected = tyndall_base.TYN_VERSION
    if loaded // 100 != expected // 100:
        raise ImportError(
            f"{path} is Tyndall {_version_text(loaded)}, but this package is made for {_version_text(expected)}"
            " (see TYNDALL_LIBRARY)"
        )


def _load() -> tuple[ctypes.CDLL, str]:
    wanted = os.environ.get("TYNDALL_LIBRARY")
    if wanted and os.path.dirname(wanted):
        wanted = os.path.abspath(wanted)  # libtyndall-io is looked for later, perhaps from another folder
    path = wanted or str(_packaged("tyndall") or _file_name("tyndall"))
    driver.offer()
    library = _open(path)
    _check_version(library, path)
    for header in _HEADERS:
        _declare(library, path, header.FUNCTIONS)
    return library, path


class _Files:
    """libtyndall-io, loaded when its first function is asked for."""

    def __getattr__(self, name: str) -> Any:
        directory, file = os.path.split(path)
        if "tyndall" not in file:
            raise ImportError(f"{path} is not named after tyndall: there is no telling how its tyndall-io is named")
        beside = os.path.join(directory, file.replace("tyndall", "tyndall-io", 1))
        library = _open(beside)
        _declare(library, beside, tyndall_io.FUNCTIONS)
        vars(self).update({function: getattr(library, function) for function in tyndall_io.FUNCTIONS})
        return object.__getattribute__(self, name)


lib, path = _load()
"""The library with the functions of all headers but tyndall_io.h, and the file it came from."""

io = _Files()
"""The functions of tyndall_io.h."""
