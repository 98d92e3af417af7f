# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Walks in space."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .._core.arrays import array
from .._scene.scene import Scene
from ..errors import InvalidArgumentError
from ._axes import FAINT, INK, axes, length_label, load, plain_style, unit_name
from ._walk_paths import walk_paths

_ENTRY, _EXIT = "#2c8a46", "#c8352b"


def walk(
    scene: Scene,
    entries: Any,
    *,
    mesh: tuple[ArrayLike, ArrayLike] | None = None,
    view: str = "xyz",
    seed: int = 0,
    first_path: int = 0,
    max_scatterings: int = 100,
    ax: Any = None,
) -> Any:
    """Draws walks from where they enter to where they leave, through every point where they scatter: a line a walk,
    which is what `walk_paths` gives.

    scene, entries, seed, first_path, max_scatterings: as for `walk_paths`. A few dozen walks are enough.
    mesh: positions (n x 3) and triangles (m x 3) to draw around them, such as went to `Scene.add_mesh`; None: nothing.
    view: "xyz", in space; or two of them, "xy", "zy", ..., for the projection on that plane.
    ax: Axes to draw into, three-dimensional for "xyz"; None: of a new figure.
    """
    load("matplotlib.pyplot")  # what is missing is said first
    if view != "xyz" and (len(view) != 2 or view[0] == view[1] or not set(view) <= set("xyz")):
        raise InvalidArgumentError(f'view is {view!r}; it must be "xyz", or two different of x, y and z')
    chosen = ["xyz".index(letter) for letter in view]
    paths = [path[:, chosen] for path in walk_paths(
        scene, entries, seed=seed, first_path=first_path, max_scatterings=max_scatterings
    )]  # fmt: skip
    ax = axes(ax, (6.4, 5.6), "3d" if view == "xyz" else "rectilinear")
    extent = [np.concatenate(paths)] if paths else [np.zeros((1, len(chosen)))]
    if mesh is not None:
        extent.append(_draw_mesh(ax, mesh, chosen))
    colors = load("matplotlib.pyplot").get_cmap("viridis")
    last = max(1, len(paths) - 1)
    for number, path in enumerate(paths):
        ax.plot(*path.T, color=colors(0.78 * number / last), linewidth=1.2, alpha=0.85, label=f"walk {number}")
    _draw_ends(ax, paths)
    _decorate(ax, np.concatenate(extent), view, unit_name(scene.metres_per_unit))
    return ax


def _draw_mesh(ax: Any, mesh: tuple[ArrayLike, ArrayLike], chosen: list[int]) -> NDArray[Any]:
    positions = array(mesh[0], "mesh", np.float64, (None, 3))
    triangles = array(mesh[1], "mesh", np.uint32, (None, 3))
    if triangles.size and triangles.max() >= len(positions):
        raise InvalidArgumentError(f"mesh has a triangle with vertex {triangles.max()}; it has {len(positions)} vertices")
    corners = positions[:, chosen][triangles]
    if len(chosen) == 3:
        collection = load("mpl_toolkits.mplot3d.art3d").Poly3DCollection
    else:
        collection = load("matplotlib.collections").PolyCollection
    ax.add_collection(collection(corners, facecolor=(0.5, 0.5, 0.55, 0.05), edgecolor=(0.4, 0.4, 0.45, 0.18), linewidth=0.5))
    return positions[:, chosen]


def _draw_ends(ax: Any, paths: list[NDArray[Any]]) -> None:
    for name, color, place in (("entry", _ENTRY, 0), ("exit", _EXIT, -1)):
        ends = [path[place] for path in paths if len(path) > 1]
        if ends:
            ax.plot(*np.array(ends).T, "o", color=color, markersize=5, markeredgecolor="white", markeredgewidth=0.6, label=name)


def _decorate(ax: Any, points: NDArray[Any], view: str, unit: str | None) -> None:
    low, high = points.min(axis=0), points.max(axis=0)
    middle, half = (low + high) / 2, max(float((high - low).max()) / 2, 1e-30) * 1.05
    for letter, center, axis in zip(view, middle, "xyz"):
        getattr(ax, f"set_{axis}label")(length_label(letter, unit), labelpad=10 if view == "xyz" else 4)
        getattr(ax, f"set_{axis}lim")(center - half, center + half)
    handles = [one for one in ax.get_lines() if one.get_label() in ("entry", "exit")]
    if handles:
        ax.legend(handles=handles, frameon=False, loc="upper right")
    if view == "xyz":
        ax.set_box_aspect((1, 1, 1), zoom=0.9)
        for axis in (ax.xaxis, ax.yaxis, ax.zaxis):
            axis.set_major_locator(load("matplotlib.ticker").MaxNLocator(4))
            axis.set_pane_color((1, 1, 1, 0))
            axis._axinfo["grid"].update(color="#e4e4e4", linewidth=0.6)
    else:
        ax.set_aspect("equal")
        plain_style(ax)
    ax.tick_params(color=FAINT, labelcolor=INK)
