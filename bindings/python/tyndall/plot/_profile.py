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
from .._slab.results import SlabResult
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
from ._models import Curve, Models, made

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

    models: a Bssrdf, the name of a model, or a SlabResult with `radial`; several of them, or {label: one of them}; all with as
        many channels. A SlabResult is drawn as steps, a bin each. Its R(r) is of the light that arrives, and a model's of the
        light that gets in, so it is divided by 1 - reflectance.specular to stand beside models of the same medium: right
        for perpendicular light in a pencil on a half-space, or on a layer whose lower side reflects nothing unscattered.
    medium: what models that are given by name are made of.
    radii: length, > 0, one-dimensional; None: 200 from 0.01 to 20 reduced mean free paths, 1 / (sigma_a + sigma_s (1 - g)), of
        the first Bssrdf; where there is none, those of the bins of the first SlabResult.
    channels: names of the channels; None: red, green and blue if there are three.
    errors: bands of two standard errors to both sides, of models that have one ("exact") and of SlabResults.
    context: where models that are given by name are made; None: `default_context()`.
    ax: Axes to draw into; None: of a new figure.
    options: for `Context.bssrdf`, of models that are given by name, such as ior_above.
    """
    load("matplotlib.pyplot")  # what is missing is said first
    found = made(models, medium, context, options)
    count = _channels(found)
    units = {one.metres_per_unit for one in found.values() if isinstance(one, Bssrdf)}
    if len(units) > 1:
        raise InvalidArgumentError("models are of media in different units of length")
    r = np.unique(_default_radii(found) if radii is None else array(radii, "radii", np.float32, (None,)))
    names = channel_names(count, channels)
    ax = axes(ax, (6.4, 4.4))
    highest = 0.0
    for index, (label, one) in enumerate(found.items()):
        if isinstance(one, Bssrdf):
            values: NDArray[Any] = one.profile(r)
            _draw(ax, r, values, one.profile_error(r) if errors else None, index, label, names)
        else:
            edges, values, deviation = _measured(one)
            _draw_steps(ax, edges, values, deviation if errors else None, index, label, names)
            values = values[(edges[1:] > r.min(initial=np.inf)) & (edges[:-1] < r.max(initial=0.0))]
        highest = max(highest, float(np.max(values, initial=0.0)))
    _decorate(ax, next(iter(units), None), r, highest)
    _add_legend(ax, list(found), names)
    return ax


def _channels(found: dict[str, Curve]) -> int:
    for label, one in found.items():
        if isinstance(one, SlabResult) and one.radial is None:
            raise InvalidArgumentError(f"{label} is a SlabResult without R(r); run the slab with radial=(largest radius, bins)")
    counts = {one.channels if isinstance(one, Bssrdf) else one.absorbed.size for one in found.values()}
    if len(counts) > 1:
        raise InvalidArgumentError(f"models have {sorted(counts)} channels; give as many to all")
    return counts.pop()


def _measured(result: SlabResult) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """Edges of the bins, R(r) of the light that gets in, and its standard errors. The first bin begins at half its width, as
    logarithmic axes have no 0."""
    radial = result.radial
    assert radial is not None
    edges = radial.edges.copy()
    edges[0] = edges[1] / 2
    entered = 1 - np.asarray(result.reflectance.specular)
    with np.errstate(divide="ignore", invalid="ignore"):
        return edges, np.asarray(radial.reflectance) / entered, radial.reflectance.stderr / entered


def _default_radii(found: dict[str, Curve]) -> NDArray[Any]:
    model = next((one for one in found.values() if isinstance(one, Bssrdf)), None)
    if model is None:
        return _measured(next(one for one in found.values() if isinstance(one, SlabResult)))[0]
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


def _draw_steps(ax: Any, edges: Any, values: Any, deviation: Any, index: int, label: str, names: list[str]) -> None:
    style = line_style(index) if len(names) > 1 else "-"
    for channel, color in enumerate(_colors(index, len(names))):
        heights = values[:, channel]
        full = label if len(names) == 1 else f"{label}, {names[channel]}"
        ax.stairs(heights, edges, baseline=None, color=color, linestyle=style, linewidth=1.2, label=full)
        if deviation is not None:
            spread = 2 * deviation[:, channel]
            low = np.maximum(heights - spread, np.finfo(np.float32).tiny)
            low, high = (np.append(one, one[-1]) for one in (low, heights + spread))
            ax.fill_between(edges, low, high, step="post", color=color, alpha=0.22, linewidth=0)


def _decorate(ax: Any, metres_per_unit: float | None, r: Any, highest: float) -> None:
    unit = unit_name(metres_per_unit)
    ax.set_xscale("log")
    ax.set_yscale("log")
    ax.set_xlabel(length_label("distance r", unit))
    ax.set_ylabel(length_label("radiant exitance per unit of power, R", unit, -2))
    if r.size > 1:
        ax.set_xlim(r[0], r[-1])
    low = ax.get_ylim()[0]
    if highest > 0:
        top = max([highest, *(float(np.max(line.get_ydata(), initial=0.0)) for line in ax.get_lines())])
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
