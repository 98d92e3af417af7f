# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Pictures: the layers of a renderer's film as arrays."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from types import TracebackType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .._core.arrays import shown
from .._core.choices import choice
from ..errors import InvalidArgumentError
from .renderer import LAYERS, Renderer, RenderStats


def layer_names(layers: Iterable[str] | None) -> list[str]:
    """The names of the layers that are asked for."""
    if isinstance(layers, str):
        raise InvalidArgumentError(f"layers is {layers!r}; it must be a list of names")
    names = list(LAYERS) if layers is None else list(layers)
    for name in names:
        choice(name, "layers", LAYERS)
    return names


class Image(Mapping[str, NDArray[np.float32]]):
    """The layers of a film as it was when the image was made, by name: `image["beauty"]`, or `image.beauty`; float32, height x
    width x channels, rows from top to bottom. `Renderer.layers` says what they hold.

    The renderer stays, for files and for more samples, until `close()` gives its memory on the device back; the arrays remain.
    Copies and pickles have the arrays and `stats` alone: their renderer is None.
    """

    renderer: Renderer | None
    """What drew it; None in copies."""

    def __init__(self, renderer: Renderer, layers: Iterable[str] | None = None) -> None:
        """Reads the film of `renderer`. layers: names of those that are read; None: all."""
        names = layer_names(layers)
        if not isinstance(renderer, Renderer):
            raise InvalidArgumentError(f"renderer is {shown(renderer)}; it must be a tyndall.Renderer")
        self.renderer = renderer
        self.stats = renderer.stats
        """What was done for it, and where the energy of all walks went."""
        self._layers = {name: renderer.read(name) for name in names}

    @property
    def names(self) -> list[str]:
        """The names of the layers that it has."""
        return list(self._layers)

    def __getitem__(self, name: str) -> NDArray[np.float32]:
        try:
            return self._layers[name]
        except KeyError:
            raise KeyError(f"there is no layer {name!r}; there are: {', '.join(self._layers)}") from None

    def __getattr__(self, name: str) -> NDArray[np.float32]:
        layers = self.__dict__.get("_layers", {})
        if name not in layers:
            raise AttributeError(f"an Image has no {name!r}; its layers are: {', '.join(layers)}")
        found: NDArray[np.float32] = layers[name]
        return found

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self._layers]

    def __iter__(self) -> Iterator[str]:
        return iter(self._layers)

    def __len__(self) -> int:
        return len(self._layers)

    __hash__ = object.__hash__

    def __eq__(self, other: object) -> bool:
        return self is other  # a mapping's own would compare arrays

    @property
    def closed(self) -> bool:
        """Whether the renderer was closed, or there is none."""
        return self.renderer is None or self.renderer.closed

    def close(self) -> None:
        """Closes the renderer. The arrays remain; files can no more be written."""
        if self.renderer is not None:
            self.renderer.close()

    def __reduce__(self) -> Any:
        return _without_renderer, (self.stats, self._layers)

    def __enter__(self) -> Image:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None:
        self.close()

    def __repr__(self) -> str:
        size = f"{self.stats.width} x {self.stats.height}"
        return f"<tyndall.Image {size}, {self.stats.samples} samples a pixel: {', '.join(self._layers)}>"


def _without_renderer(stats: RenderStats, layers: dict[str, NDArray[np.float32]]) -> Image:
    image = Image.__new__(Image)
    image.renderer, image.stats, image._layers = None, stats, dict(layers)
    return image
