# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""What all pictures share: matplotlib itself, axes, units, colours and line styles."""

from __future__ import annotations

import importlib
from typing import Any

from ..errors import InvalidArgumentError

INK, FAINT = "#333333", "#b8b8b8"
LINE_STYLES: list[Any] = ["-", "--", ":", "-.", (0, (5, 1, 1, 1, 1, 1)), (0, (8, 2)), (0, (1, 3)), (0, (3, 3, 1, 3))]
_RGB = ("#c8352b", "#2c8a46", "#2a5fc4")
_HUES = ("#2a5fc4", "#d9822b", "#2c8a46", "#c8352b", "#7b4fb0", "#4aa3a8", "#8a6a2c", "#c2588f", "#5c6770", "#9aa22a")
_UNITS = {1.0: "m", 1e-2: "cm", 1e-3: "mm", 1e-6: "µm"}


def load(module: str) -> Any:
    """A module of matplotlib's."""
    try:
        return importlib.import_module(module)
    except ModuleNotFoundError as error:
        if error.name is not None and error.name.partition(".")[0] not in ("matplotlib", "mpl_toolkits"):
            raise
        raise ModuleNotFoundError("tyndall.plot needs matplotlib: pip install 'tyndall[plot]'", name="matplotlib") from None


def axes(ax: Any, size: tuple[float, float], projection: str | None = None) -> Any:
    """`ax`, or the axes of a new figure of `size` inches."""
    pyplot = load("matplotlib.pyplot")
    if ax is None:
        return pyplot.figure(figsize=size, layout="constrained").add_subplot(projection=projection)
    if not hasattr(ax, "get_xlim"):
        raise InvalidArgumentError(f"ax is {ax!r}; it must be an Axes of matplotlib, or None")
    if projection is not None and getattr(ax, "name", None) != projection:
        raise InvalidArgumentError(f'ax must be an Axes of the projection "{projection}"')
    return ax


def plain_style(ax: Any) -> None:
    """Faint grid lines behind the curves, no frame above and beside them."""
    ax.grid(True, which="major", color="#e4e4e4", linewidth=0.8)
    ax.set_axisbelow(True)
    for side in ("top", "right"):
        ax.spines[side].set_visible(False)
    for side in ("left", "bottom"):
        ax.spines[side].set_color(FAINT)
    ax.tick_params(which="both", color=FAINT, labelcolor=INK)


def unit_name(metres_per_unit: float | None) -> str | None:
    """What a unit of length is called; None if it is not known."""
    if metres_per_unit is None:
        return None
    for metres, name in _UNITS.items():
        if abs(metres_per_unit / metres - 1) < 1e-6:
            return name
    return f"{metres_per_unit:g} m"


def length_label(text: str, unit: str | None, power: int = 1) -> str:
    """The label of an axis of lengths to a power."""
    if unit is None:  # of the medium, or of the scene
        unit = "length"
    base = unit if unit.isalpha() else f"({unit})"
    return f"{text} ({unit})" if power == 1 else f"{text} ({base}$^{{{power}}}$)"


def channel_colors(count: int) -> list[Any]:
    """A colour for each spectral channel: red, green and blue for three of them."""
    if count == 1:
        return [INK]
    if count == 3:
        return list(_RGB)
    colors = load("matplotlib.pyplot").get_cmap("turbo")
    return [colors(0.92 - 0.84 * index / (count - 1)) for index in range(count)]


def channel_names(count: int, names: Any = None) -> list[str]:
    """What the channels are called."""
    if names is None:
        return ["red", "green", "blue"] if count == 3 else [f"channel {index}" for index in range(count)]
    found = [str(name) for name in names]
    if len(found) != count:
        raise InvalidArgumentError(f"channels has {len(found)} names; there are {count} channels")
    return found


def model_color(index: int) -> str:
    """A colour for each of some models."""
    return _HUES[index % len(_HUES)]


def line_style(index: int) -> Any:
    """A line style for each of some models."""
    return LINE_STYLES[index % len(LINE_STYLES)]
