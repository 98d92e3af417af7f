# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""check_style.py FOLDER...: whether ruff finds the Python files in the project's one style (pyproject.toml)."""

import subprocess
import sys

commands = [["format", "--check", "--diff"], ["check"]]
results = [subprocess.run([sys.executable, "-m", "ruff", *one, "--no-cache", *sys.argv[1:]]).returncode for one in commands]
sys.exit(max(results))
