# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""check_wheel.py SOURCE WORK: builds the wheel of SOURCE with pip, installs it into an empty environment in WORK, and runs the
package's tests there, outside the source tree. What the tests need comes from the environment that this program runs in; it
is seen only after the package has been imported without."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import sysconfig
import venv
import zipfile
from pathlib import Path

SKIPPED = 77


def run(command: list[str | Path], **options: object) -> str:
    done = subprocess.run([str(one) for one in command], stdout=subprocess.PIPE, text=True, **options)  # type: ignore[call-overload]
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}: status {done.returncode}\n{done.stdout}")
    return str(done.stdout)


def build(source: Path, work: Path) -> Path:
    """The wheel; the build's folder inside SOURCE is kept for the next time."""
    folder = work / "wheel"
    shutil.rmtree(folder, ignore_errors=True)
    pip = [sys.executable, "-m", "pip", "--disable-pip-version-check", "--retries", "1"]
    if subprocess.run([*pip, "download", "-q", "--no-deps", "-d", work / "reach", "scikit-build-core"]).returncode != 0:
        print("pip does not reach PyPI: the wheel is not built")
        sys.exit(SKIPPED)
    run([*pip, "wheel", "-q", "--no-deps", "-w", folder, source])
    (wheel,) = folder.glob("*.whl")
    return wheel


def check_contents(wheel: Path, work: Path, source: Path) -> None:
    """The name's tags, no C++ runtime, exports, and no path of this machine."""
    assert re.fullmatch(r"tyndall-[\d.]+-py3-none-(linux|macosx|win)\w*\.whl", wheel.name), wheel.name
    names = zipfile.ZipFile(wheel).namelist()
    assert not [name for name in names if re.search(r"libstdc\+\+|libgcc|libOpenCL|libc\.so", name)], names
    assert len([name for name in names if name.startswith("tyndall/_bin/tyndall-")]) == 4, names
    unpacked = work / "unpacked"
    shutil.rmtree(unpacked, ignore_errors=True)
    zipfile.ZipFile(wheel).extractall(unpacked)
    for library in unpacked.glob("tyndall/_lib/libtyndall*"):
        for line in run(["nm", "-D", "--defined-only", library]).splitlines():
            assert re.search(r" (tyn_\w+(@@\w+)?|TYNDALL_\d+)$", line), line
    for binary in [*unpacked.glob("tyndall/_lib/lib*.so*"), *unpacked.glob("tyndall/_bin/*")]:
        paths = re.findall(r"(?:RUNPATH|RPATH).*\[(.*)\]", run(["readelf", "-d", binary]))
        assert all(path.startswith("$ORIGIN") for path in paths), (binary, paths)
        needed = re.findall(r"NEEDED.*\[(.*)\]", run(["readelf", "-d", binary]))
        there = {one.name for one in binary.parent.parent.glob("_lib/*")}
        system = r"lib(c|m|dl|rt|pthread|z|gcc_s|stdc\+\+|OpenCL)\.so\.\d+|ld-linux.*"
        assert all(name in there or re.fullmatch(system, name) for name in needed), (binary, needed)
        assert str(source).encode() not in binary.read_bytes(), binary


def install(wheel: Path, work: Path) -> Path:
    """The Python of an environment with the wheel and what it depends on."""
    environment = work / "environment"
    shutil.rmtree(environment, ignore_errors=True)
    venv.create(environment, with_pip=True)
    python = environment / "bin/python"
    run([python, "-m", "pip", "--disable-pip-version-check", "install", "-q", wheel])
    return python


def main() -> None:
    source, work = (Path(one).resolve() for one in sys.argv[1:3])
    work.mkdir(parents=True, exist_ok=True)
    wheel = build(source, work)
    check_contents(wheel, work, source)
    python = install(wheel, work)
    outside = {name: value for name, value in os.environ.items() if name not in ("PYTHONPATH", "TYNDALL_LIBRARY")}
    code = "import tyndall; print(tyndall.__file__, tyndall.Context())"
    print(says := run([python, "-c", code], cwd=work, env=outside), end="")
    assert str(work / "environment") in says
    print(run([python.parent / "tyndall-info", "--devices"], cwd=work, env=outside), end="")

    tests = work / "tests"
    shutil.rmtree(tests, ignore_errors=True)
    shutil.copytree(source / "tests/python", tests, ignore=shutil.ignore_patterns("__pycache__"))
    shutil.copytree(source / "bindings/python/examples", work / "examples", dirs_exist_ok=True)
    (site,) = (python.parent.parent / "lib").glob("python*/site-packages")
    (site / "peers.pth").write_text(f"{sysconfig.get_path('purelib')}\n")
    outside.update(TYNDALL_INCLUDE=str(source / "lib/include"), TYNDALL_EXAMPLES=str(work / "examples"))
    command = [python, "-m", "pytest", "-c", source / "pyproject.toml", "--rootdir", tests, "-p", "no:cacheprovider", tests]
    sys.exit(subprocess.run([str(one) for one in command], cwd=work, env=outside).returncode)


if __name__ == "__main__":
    main()
