# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Profiles over the radius."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .._bssrdf.models import Bssrdf
from .._core.arrays import array
from .._slab.layers import Layers
from ..context import Context
from ..errors import InvalidArgumentError
from ._axes import (
    axes,
    channel_colors,
    channel_names,
    length_label,
    line_style,
    load,
    model_color,
    plain_style,
    unit_name,
)
from ._models import Models, made

_DECADES = 9  # that are shown of R


def profile(
    models: Models,
    medium: Layers | None = None,
    *,
    radii: ArrayLike | None = None,
    channels: Sequence[str] | None = None,
    errors: bool = True,
    context: Context | None = None,
    ax: Any = None,
    **options: Any,
) -> Any:
    """Draws the profiles R(r) of BSSRDF models over the radius, on logarithmic axes: a colour a channel, or a model if there is
    one channel, and a line style a model.

    models: a Bssrdf or the name of a model, several of them, or {label: Bssrdf or name}; all with as many channels.
    medium: what models that are given by name are made of.
    radii: length, > 0, one-dimensional; None: 200 from 0.01 to 20 reduced mean free paths, 1 / (sigma_a + sigma_s (1 - g)).
    channels: names of the channels; None: red, green and blue if there are three.
    errors: bands of two standard errors to both sides, of models that have one ("exact").
    context: where models that are given by name are made; None: `default_context()`.
    ax: Axes to draw into; None: of a new figure.
    options: for `Context.bssrdf`, of models that are given by name, such as ior_above.
    """
    load("matplotlib.pyplot")  # what is missing is said first
    found = made(models, medium, context, options)
    first = next(iter(found.values()))
    if any(one.channels != first.channels for one in found.values()):
        raise InvalidArgumentError(
            f"models have {sorted({one.channels for one in found.values()})} channels; give as many to all"
        )
    if any(one.metres_per_unit != first.metres_per_unit for one in found.values()):
        raise InvalidArgumentError("models are of media in different units of length")
    r = np.unique(_default_radii(first) if radii is None else array(radii, "radii", np.float32, (None,)))
    names = channel_names(first.channels, channels)
    ax = axes(ax, (6.4, 4.4))
    highest = 0.0
    for index, (label, model) in enumerate(found.items()):
        values = model.profile(r)
        highest = max(highest, float(values.max(initial=0.0)))
        _draw(ax, r, values, model.profile_error(r) if errors else None, index, label, names)
    _decorate(ax, first, r, highest)
    _add_legend(ax, list(found), names)
    return ax


def _default_radii(model: Bssrdf) -> NDArray[np.float32]:
    medium = model.layers[0].medium
    extinction = medium.sigma_a + medium.sigma_s * (1 - medium.g)
    if not np.all(extinction > 0):
        return np.geomspace(0.01, 20, 200).astype(np.float32)
    return np.geomspace(0.01 / extinction.max(), 20 / extinction.min(), 200).astype(np.float32)


def _colors(index: int, count: int) -> list[Any]:
    return [model_color(index)] if count == 1 else channel_colors(count)


def _draw(ax: Any, r: Any, values: Any, deviation: Any, index: int, label: str, names: list[str]) -> None:
    style = line_style(index) if len(names) > 1 else "-"
    for channel, color in enumerate(_colors(index, len(names))):
        curve = values[:, channel]
        full = label if len(names) == 1 else f"{label}, {names[channel]}"
        ax.plot(r, curve, color=color, linestyle=style, linewidth=1.6, label=full)
        if deviation is not None and np.any(deviation[:, channel] > 0):
            spread = 2 * deviation[:, channel]
            low = np.maximum(curve - spread, np.finfo(np.float32).tiny)
            ax.fill_between(r, low, curve + spread, color=color, alpha=0.22, linewidth=0)


def _decorate(ax: Any, model: Bssrdf, r: Any, highest: float) -> None:
    unit = unit_name(model.metres_per_unit)
    ax.set_xscale("log")
    ax.set_yscale("log")
    ax.set_xlabel(length_label("distance r", unit))
    ax.set_ylabel(length_label("radiant exitance per unit of power, R", unit, -2))
    if r.size > 1:
        ax.set_xlim(r[0], r[-1])
    low = ax.get_ylim()[0]
    if highest > 0:
        top = max(highest, *(float(np.max(line.get_ydata(), initial=0.0)) for line in ax.get_lines()))
        ax.set_ylim(max(low, highest * 10.0**-_DECADES), top * 2)  # automatic margins are decades where a curve is steep
    plain_style(ax)


def _add_legend(ax: Any, labels: list[str], names: list[str]) -> None:
    """One entry a model and one a channel, not one a curve."""
    line = load("matplotlib.lines").Line2D
    several = len(names) > 1
    handles = [
        line(
            [],
            [],
            color="#333333" if several else model_color(index),
            linestyle=line_style(index) if several else "-",
            label=label,
        )
        for index, label in enumerate(labels)
    ]
    if several:
        handles += [
            line([], [], color=color, linewidth=4, label=name) for name, color in zip(names, channel_colors(len(names)))
        ]
    ax.legend(handles=handles, frameon=False, loc="lower left", handlelength=2.6)
