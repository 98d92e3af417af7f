# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Puts the command-line tools of the package on the path."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from pathlib import Path
from typing import NoReturn

from .capi import driver


def _program(name: str) -> Path:
    for folder in sys.modules[__name__.partition(".")[0]].__path__:
        path = Path(folder) / "_bin" / name
        if path.exists():
            return path
    sys.exit(f"{name}: this installation of the package has no tools")


def main() -> NoReturn:
    """Runs the tool that this process is named after, in its place."""
    program = _program(Path(sys.argv[0]).name)
    environment = driver.environment()
    if sys.platform == "win32":
        sys.exit(subprocess.run([program, *sys.argv[1:]], env=environment).returncode)
    signal.signal(signal.SIGPIPE, signal.SIG_DFL)  # Python ignores it, and what it starts would, too
    os.execve(program, [str(program), *sys.argv[1:]], environment)
