# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Pictures as files: OpenEXR and PNG."""

from __future__ import annotations

import ctypes
from collections.abc import Mapping
from typing import Union

from .. import capi
from .._bssrdf.paths import Path, path_bytes, text_bytes
from .._core.arrays import shown
from .._core.choices import choice
from .._core.numbers import number
from .._render.image import Image
from .._render.renderer import LAYERS, Renderer
from ..errors import ClosedError, InvalidArgumentError

Picture = Union[Image, Renderer]
"""What has a film."""

TONES = {"srgb": capi.TYN_TONE_SRGB, "aces": capi.TYN_TONE_ACES}


def write_exr(path: Path, image: Picture, *, attributes: Mapping[str, object] | None = None) -> None:
    """Writes all layers of a film as one OpenEXR file: R G B A (beauty) and layer.channel for the others, 32-bit float, ZIP.

    path: appears only when the file is complete.
    image: an Image whose renderer was not closed, or a Renderer, of which the film as it is now is written.
    attributes: strings for the header by their names, besides chromaticities, software, seed, samples, seconds and device.

    Errors: FileError, InvalidArgumentError (an attribute that the file has anyway), ClosedError.
    """
    renderer = _renderer(image)
    pairs = [
        capi.TynAttribute(name=text_bytes(name, "attributes"), value=text_bytes(value, "attributes"))
        for name, value in (attributes or {}).items()
    ]
    records = (capi.TynAttribute * len(pairs))(*pairs)
    renderer._call(capi.io.tyn_exr_write, renderer.handle, path_bytes(path), records, len(pairs))


def write_png(
    path: Path,
    image: Picture,
    *,
    exposure: float = 0.0,
    tone: str = "srgb",
    layer: str = "beauty",
    transparent: bool = False,
) -> None:
    """Writes one layer of a film as an 8-bit PNG.

    path, image: as in `write_exr`.
    exposure: stops, added before the tone curve.
    tone: "srgb", clamped to [0, 1] and the sRGB curve; or "aces", the rational fit of Narkowicz 2015 to the ACES curve, and
        sRGB. Of colours only: normals are 0.5 + 0.5 n, of depth and samples the range is from black to white (near is white).
    layer: one of `Renderer.layers()`.
    transparent: writes beauty's alpha.

    Errors: FileError, InvalidArgumentError, ClosedError.
    """
    renderer = _renderer(image)
    options = capi.TynPngOptions(
        exposure=number(exposure, "exposure"), tone=choice(tone, "tone", TONES), layer=choice(layer, "layer", LAYERS),
        transparent=int(bool(transparent)),
    )  # fmt: skip
    renderer._call(capi.io.tyn_png_write, renderer.handle, path_bytes(path), ctypes.byref(options))


def _renderer(image: Picture) -> Renderer:
    if isinstance(image, Image) and image.renderer is None:
        raise ClosedError("a copy of an Image has no renderer, of which files are written")
    found = image.renderer if isinstance(image, Image) else image
    if not isinstance(found, Renderer):
        raise InvalidArgumentError(f"image is {shown(image)}; it must be a tyndall.Image or a tyndall.Renderer")
    return found
