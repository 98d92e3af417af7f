# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Albedos of models over the single-scattering albedo."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from .._core.arrays import array
from .._media.medium import Medium
from .._media.phase import Phase
from ..context import Context, default_context
from ..errors import InvalidArgumentError
from ._axes import axes, channel_colors, line_style, load, model_color, plain_style
from ._models import Models, named

_MODELS: dict[str, str] = {
    "exact": "normalized-diffusion",
    "photon-beam-diffusion": "photon-beam-diffusion",
    "better-dipole": "better-dipole",
    "standard-dipole": "standard-dipole",
}


def albedo(
    models: Models | None = None,
    *,
    single_scattering_albedo: ArrayLike | None = None,
    g: float = 0.0,
    ior: float = 1.0,
    phase: Phase | None = None,
    media: Mapping[str, Medium] | None = None,
    context: Context | None = None,
    ax: Any = None,
    **options: Any,
) -> Any:
    """Draws the total albedo of a half-space, what comes back of light that got in perpendicularly, over its single-scattering
    albedo: a curve a model.

    models: the name of a model, several of them, or {label: name}; None: four. What is called "exact" there is the albedo of
        "normalized-diffusion", which is exact, too, and takes milliseconds where that of "exact" takes seconds.
    single_scattering_albedo: where curves are evaluated, in [0, 1], one-dimensional, at most 1024; None: 41 that are denser
        towards 1.
    g, ior, phase: of the half-space, as for `Medium`.
    media: {label: Medium} to mark on the picture, by the first of the models that it is made of; a marker a channel. Each keeps
        its own phase function and index of refraction.
    context: where models are made; None: `default_context()`.
    ax: Axes to draw into; None: of a new figure.
    options: for `Context.bssrdf`, such as ior_above.
    """
    load("matplotlib.pyplot")  # what is missing is said first
    where = 1 - np.linspace(1, 0, 41) ** 2 if single_scattering_albedo is None else single_scattering_albedo
    x = np.unique(array(where, "single_scattering_albedo", np.float64, (None,)))
    names = named(_MODELS if models is None else models)
    if not all(isinstance(one, str) for one in names.values()):
        raise InvalidArgumentError("models must be names here: they are made of many media")
    maker = context or default_context()
    medium = Medium.from_albedo(x, g=g, ior=ior, phase=phase)  # a channel for each albedo
    curves = {label: _albedos(maker, name, medium, options) for label, name in names.items()}
    ax = axes(ax, (6.0, 4.4))
    for index, (label, curve) in enumerate(curves.items()):
        ax.plot(x, curve, color=model_color(index), linestyle=line_style(index), linewidth=1.6, label=label)
    for index, (label, one) in enumerate((media or {}).items()):
        _mark(ax, label, one, _albedos(maker, next(iter(names.values())), one, options), "oDs^vPX*"[index % 8])
    ax.set_xlabel("single-scattering albedo $\\sigma_s / (\\sigma_a + \\sigma_s)$")
    ax.set_ylabel("albedo of the half-space")
    ax.set_xlim(0, 1)
    ax.set_ylim(bottom=0)
    plain_style(ax)
    ax.legend(frameon=False, loc="upper left", handlelength=2.6)
    return ax


def _albedos(context: Context, name: Any, medium: Medium, options: Mapping[str, Any]) -> Any:
    with context.bssrdf(name, medium, **options) as model:
        return model.albedo


def _mark(ax: Any, label: str, medium: Medium, albedos: Any, marker: str) -> None:
    for x, y, color in zip(medium.albedo, albedos, channel_colors(medium.channels)):
        ax.plot([x], [y], marker, color=color, markeredgecolor="white", markersize=7, zorder=4)
    ax.plot([], [], marker, color="#333333", markersize=6, label=label)
