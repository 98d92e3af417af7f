# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""The gallery of examples: every file runs as it stands, draws its picture, and prints what is right."""

from __future__ import annotations

import ast
import importlib.util
import math
import os
import pathlib
import re
import subprocess
import sys
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest

import tyndall as ty

pytest.importorskip("matplotlib")
pytest.importorskip("scipy")
Image = pytest.importorskip("PIL.Image")

_HERE = pathlib.Path(__file__).resolve()
FOLDER = pathlib.Path(os.environ.get("TYNDALL_EXAMPLES") or _HERE.parents[2] / "bindings" / "python" / "examples")
FILES = sorted(FOLDER.glob("*.py"))
NAMES = {
    "against_iadpython", "compare_models", "fit_medium", "layered_skin", "presets", "render_model", "walk_histogram",
}  # fmt: skip
NEEDS = {"fit_medium": {"scipy"}, "against_iadpython": {"iadpython"}}
NUMBER = r"([-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?)"


def test_the_gallery_is_whole() -> None:
    assert {file.stem for file in FILES} == NAMES


@pytest.mark.parametrize("file", FILES, ids=lambda file: file.stem)
def test_each_is_short_and_plain(file: pathlib.Path) -> None:
    text = file.read_text(encoding="utf-8")
    tree = ast.parse(text, feature_version=(3, 9))
    assert len(text.splitlines()) < 60
    assert text.startswith("# SPDX-FileCopyrightText:") and ast.get_docstring(tree)
    imported = {name.partition(".")[0] for node in ast.walk(tree) for name in _imports(node)}
    assert imported <= {"sys", "numpy", "matplotlib", "tyndall"} | NEEDS.get(file.stem, set())
    used = {node.attr for node in ast.walk(tree) if isinstance(node, ast.Attribute)}
    assert "capi" not in used and not any(name.startswith("_") for name in used)


def _imports(node: ast.AST) -> Iterator[str]:
    if isinstance(node, ast.Import):
        yield from (one.name for one in node.names)
    elif isinstance(node, ast.ImportFrom):
        assert node.module is not None and not node.module.startswith("tyndall")
        yield node.module


@pytest.mark.parametrize("file", FILES, ids=lambda file: file.stem)
def test_each_runs(file: pathlib.Path, tmp_path: pathlib.Path) -> None:
    printed = _run(file, tmp_path)
    if printed.startswith("skipped:"):
        assert importlib.util.find_spec("iadpython") is None and file.stem == "against_iadpython"
        pytest.skip(printed.strip())
    picture = f"{file.stem}.png"
    assert [path.name for path in tmp_path.glob("*.png")] == [picture]
    assert re.search(rf"^wrote .*{picture}$", printed, re.MULTILINE)
    _require_contents(tmp_path / picture)
    globals()[f"_check_{file.stem}"](printed, tmp_path)


def _run(file: pathlib.Path, folder: pathlib.Path) -> str:
    """What the example prints."""
    package = str(pathlib.Path(ty.__file__).resolve().parents[1])
    environment = {**os.environ, "MPLBACKEND": "Agg", "PYTHONIOENCODING": "utf-8"}
    environment["PYTHONPATH"] = os.pathsep.join([package, *filter(None, [os.environ.get("PYTHONPATH")])])
    if "TYNDALL_LIBRARY" in environment:
        environment["TYNDALL_LIBRARY"] = os.path.abspath(environment["TYNDALL_LIBRARY"])
    command = [sys.executable, "-W", "error", str(file)]
    done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, encoding="utf-8", timeout=300)
    assert done.returncode == 0, done.stderr
    assert done.stderr == ""
    return done.stdout


def _require_contents(picture: pathlib.Path) -> None:
    """Something is drawn in every quarter of the picture."""
    with Image.open(picture) as opened:
        pixels = np.asarray(opened.convert("RGB"), np.int16)
    height, width = pixels.shape[:2]
    assert height > 400 and width > 800
    for rows in np.array_split(pixels, 2, axis=0):
        for quarter in np.array_split(rows, 2, axis=1):
            assert len(np.unique(quarter.reshape(-1, 3), axis=0)) > 50
            assert np.mean(np.any(quarter != quarter[0, 0], axis=2)) > 0.01


def _rows(printed: str, pattern: str) -> list[list[str]]:
    return [list(found.groups()) for found in re.finditer(pattern, printed, re.MULTILINE)]


def _check_compare_models(printed: str, folder: pathlib.Path) -> None:
    rows = {name: [float(one) for one in numbers] for name, *numbers in _rows(
        printed, rf"^(\S+) +{NUMBER} +{NUMBER} % +{NUMBER} %$"
    )}  # fmt: skip
    assert set(rows) == set(ty.bssrdf_models())
    albedo, ior = 1 / 1.05, 1.4
    fdr = -1.440 / ior**2 + 0.710 / ior + 0.668 + 0.0636 * ior  # Jensen et al. 2001
    root = math.sqrt(3 * (1 - albedo))
    dipole = albedo / 2 * (1 + math.exp(-4 / 3 * (1 + fdr) / (1 - fdr) * root)) * math.exp(-root)
    assert rows["standard-dipole"][0] == pytest.approx(dipole, abs=1e-4)
    with ty.Context() as context:
        back = context.slab(ty.Medium(0.05, 5.0, g=0.8, ior=1.4), photons=200_000).reflectance
    inside = 1 - float(back.specular[0])
    assert rows["exact"][0] == pytest.approx(float(back.diffuse[0]) / inside, abs=4 * back.diffuse.stderr[0] / inside + 1e-4)
    assert rows["exact"][1:] == [0, 0]
    assert rows["normalized-diffusion"][0] == pytest.approx(rows["exact"][0], abs=2e-4)
    assert rows["standard-dipole"][1] == pytest.approx(100 * (dipole / rows["exact"][0] - 1), abs=0.1)
    assert 30 < rows["standard-dipole"][2] < 70  # docs/bssrdf-models.md: +47 at 0.99, +81 at 0.9, of g = 0


def _check_fit_medium(printed: str, folder: pathlib.Path) -> None:
    ((truth_a, truth_s),) = _rows(printed, rf"^true +{NUMBER} +{NUMBER}$")
    rows = {name: [float(one) for one in numbers] for name, *numbers in _rows(
        printed, rf"^(\S+) +{NUMBER} ± +{NUMBER} +{NUMBER} ± +{NUMBER} +{NUMBER}$"
    )}  # fmt: skip
    assert (float(truth_a), float(truth_s)) == (0.05, 1.0) and len(rows) == 3
    a, a_error, s, s_error, chi2 = rows["exact"]
    assert abs(a - 0.05) < 4 * a_error and abs(s - 1) < 4 * s_error and a_error < 0.001 and s_error < 0.02 and 0.4 < chi2 < 2
    a, a_error, s, s_error, chi2 = rows["standard-dipole"]
    assert abs(s - 1) > 10 * s_error and chi2 > 4


def _check_layered_skin(printed: str, folder: pathlib.Path) -> None:
    rows = _rows(printed, rf"^(\w+) skin +at (\d+) nm: {NUMBER} ± {NUMBER}, by adding and doubling {NUMBER}$")
    assert [row[:2] for row in rows] == [[skin, nm] for skin in ("dark", "tanned", "light") for nm in ("550", "650")]
    walks, error, exact = np.array([row[2:] for row in rows], float).T
    assert np.all(np.abs(walks - exact) < 4 * error + 1e-4) and np.all(error < 0.02 * exact + 1e-3)
    green, red = exact[::2], exact[1::2]
    assert 0.02 < green[0] < 0.06 < green[1] < 0.2 < green[2] < 0.4 and np.all(red > 1.2 * green)


def _check_presets(printed: str, folder: pathlib.Path) -> None:
    rows = _rows(printed, rf"^(\w+) +{NUMBER} walks, +{NUMBER} scatterings each, {NUMBER} leaked$")
    assert [row[0] for row in rows] == ty.Medium.presets()
    assert all(int(row[1]) > 10000 and int(row[3]) == 0 for row in rows)
    scatterings = {row[0]: float(row[2]) for row in rows}
    assert max(scatterings, key=lambda name: scatterings[name]) == "spectralon"  # white, and the densest


def _check_render_model(printed: str, folder: pathlib.Path) -> None:
    assert _rows(printed, rf"walks leaked {NUMBER}, lost {NUMBER}$") == [["0", "0"]]
    part = pytest.importorskip("OpenEXR").File(str(folder / "render_model.exr"), separate_channels=True).parts[0]
    pixels = {name: channel.pixels for name, channel in part.channels.items()}
    for color in "RGB":
        parts: Any = [pixels[f"{layer}.{color}"] for layer in ("subsurface", "specular", "diffuse", "emission")]
        np.testing.assert_allclose(sum(parts), pixels[color], rtol=1e-4, atol=1e-5)
        assert parts[0].max() > 0.2 and parts[3].max() > 10  # wax that glows, and the flame
    assert pixels["subsurface.R"].sum() > 2 * pixels["subsurface.B"].sum() > 0


def _check_walk_histogram(printed: str, folder: pathlib.Path) -> None:
    rows = _rows(
        printed,
        rf"^mean free path {NUMBER} mm: mean path {NUMBER} ± {NUMBER} mm, 4 V / S = {NUMBER} mm\n"
        rf"  entered {NUMBER}, escaped {NUMBER}, lost {NUMBER}, {NUMBER} scatterings each$",
    )
    assert len(rows) == 3
    for mean_free_path, mean, error, expected, entered, escaped, lost, scatterings in np.array(rows, float):
        assert expected == pytest.approx(4 / 3 * 10, rel=1e-3)  # 4 V / S of a ball of 10 mm
        assert abs(mean - expected) < 4 * error + 1e-3 and error < 0.03
        assert entered == escaped == 1e6 and lost == 0
        assert scatterings == pytest.approx(expected / mean_free_path, rel=0.01, abs=0.006)


def _check_against_iadpython(printed: str, folder: pathlib.Path) -> None:
    ((worst,),) = _rows(printed, rf"^iadpython - adding_doubling: at most {NUMBER}$")
    ((spread,),) = _rows(printed, rf"^slab engine - adding_doubling: {NUMBER} standard errors, root mean square$")
    assert 0 < float(worst) < 2e-4  # its own error, with 32 points, of g = 0.8
    assert 0.2 < float(spread) < 2.5  # errors of neighbours go together: a few independent ones
