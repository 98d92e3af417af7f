# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Pictures on axes."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from .._core.arrays import array, shown
from .._core.choices import choice
from .._files.writing import TONES
from .._render.image import Image
from ..errors import InvalidArgumentError
from ._axes import axes, length_label, load, unit_name

_DATA = {"normal", "depth", "samples"}


def image(
    img: Image | NDArray[Any],
    layer: str = "beauty",
    *,
    tone: str = "srgb",
    exposure: float = 0.0,
    ax: Any = None,
) -> Any:
    """Draws a layer of a picture, as `write_png` would write it, but depth and samples in colours with a bar beside them.

    img: an Image that has the layer; or pixels, height x width x 3 or 4, linear RGB, with which `layer` does nothing.
    layer: one of `Renderer.layers()`.
    tone: "srgb", clamped to [0, 1] and the sRGB curve; or "aces", the fit of Narkowicz 2015 to the ACES curve, and sRGB.
    exposure: stops, added before the tone curve.
    ax: Axes to draw into; None: of a new figure.
    """
    load("matplotlib.pyplot")  # what is missing is said first
    choice(tone, "tone", TONES)
    if not np.isfinite(exposure):
        raise InvalidArgumentError(f"exposure is {exposure}; it must be finite")
    pixels = _pixels(img, layer)
    height, width = pixels.shape[:2]
    ax = axes(ax, (6.4 + 0.9 * (pixels.shape[2] == 1), max(2.0, 6.4 * height / width)))
    if isinstance(img, Image) and pixels.shape[2] == 1:
        _draw_data(ax, img, layer, pixels[..., 0])
    else:
        is_normal = isinstance(img, Image) and layer == "normal"
        colors = 0.5 + 0.5 * pixels if is_normal else tone_mapped(pixels[..., :3], tone, exposure)
        ax.imshow(np.clip(colors, 0, 1), interpolation="nearest")
    ax.set_axis_off()
    return ax


def _pixels(img: Any, layer: str) -> NDArray[Any]:
    if isinstance(img, Image):
        choice(layer, "layer", {name: 0 for name in img})
        return img[layer]
    if not isinstance(img, np.ndarray) or img.ndim != 3 or img.shape[2] not in (3, 4):
        raise InvalidArgumentError(f"img is {shown(img)}; it must be a tyndall.Image, or pixels, height x width x 3 or 4")
    return array(img, "img")


def tone_mapped(values: NDArray[np.float32], tone: str, exposure: float) -> NDArray[np.float32]:
    """Linear radiance as values for a display, in [0, 1]."""
    v = np.clip(np.nan_to_num(values) * np.float32(2.0**exposure), 0, 1e6)
    if tone == "aces":
        v = v * (2.51 * v + 0.03) / (v * (2.43 * v + 0.59) + 0.14)
    v = np.minimum(v, 1)
    result: NDArray[np.float32] = np.where(v <= 0.0031308, 12.92 * v, 1.055 * v ** (1 / 2.4) - 0.055)
    return result


def _draw_data(ax: Any, img: Image, layer: str, values: NDArray[np.float32]) -> None:
    """Nothing is drawn where rays hit nothing."""
    masked = np.ma.masked_invalid(values)
    drawn = ax.imshow(masked, interpolation="nearest", cmap="viridis_r" if layer == "depth" else "viridis")
    unit = unit_name(None if img.renderer is None else img.renderer.scene.metres_per_unit)
    label = length_label("depth", unit) if layer == "depth" else "samples a pixel"
    bar = ax.figure.colorbar(drawn, ax=ax, label=label, fraction=0.04, pad=0.02)
    bar.outline.set_visible(False)
