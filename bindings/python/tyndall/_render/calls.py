# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""A context's calls that render."""

from __future__ import annotations

import warnings
from collections.abc import Iterable

from .._core.context import ContextHandle
from .._core.progress import Progress
from .._scene.camera import Camera
from .._scene.scene import Scene
from ..errors import CancelledError, InvalidArgumentError, TyndallWarning
from .image import Image, layer_names
from .renderer import Renderer


class RenderCalls(ContextHandle):
    """The renderers of a context."""

    def renderer(
        self,
        scene: Scene,
        *,
        width: int = 640,
        height: int = 480,
        camera: Camera | int | None = None,
        seed: int = 0,
        max_bounces: int = 64,
        exit: str = "diffuse",
        bssrdf: str | None = None,
    ) -> Renderer:
        """A progressive path tracer with an empty film.

        scene: committed. If nothing lights it, there is a TyndallWarning.
        width, height: pixels, 1 to 32768.
        camera: a Camera, the index of one of the scene's, or None: the scene's first, else a view of the whole scene. A film of
            another shape than the camera's aspect_ratio shows more, never less.
        seed: >= 0, < 2^64. Same scene, options and number of samples: the same bits.
        max_bounces: surface interactions of a path, >= 1; a walk counts as one. Roulette ends most before.
        exit: how light that was scattered inside a medium leaves it: "diffuse", by the normalized-Fresnel cosine lobe, with
            little noise, or "dielectric", in the walk's own refracted direction, which is exact, with more noise; light
            of lights without size, which no such direction meets, goes through the diffuse lobe all the same.
        bssrdf: None: light walks; or one of `bssrdf_models()` that takes its place, an approximation for surfaces that are flat
            over a few mean free paths (not "gaussians", and not with exit="dielectric").

        Errors: InvalidOperationError (the scene is not committed), InvalidArgumentError, OutOfMemoryError, DeviceError.
        """
        return self._renderer(scene, width, height, camera, seed, max_bounces, exit, bssrdf)

    def render(
        self,
        scene: Scene,
        *,
        width: int = 640,
        height: int = 480,
        spp: int = 64,
        seconds: float = 0.0,
        target_error: float = 0.0,
        camera: Camera | int | None = None,
        seed: int = 0,
        max_bounces: int = 64,
        exit: str = "diffuse",
        bssrdf: str | None = None,
        layers: Iterable[str] | None = None,
        progress: Progress = None,
    ) -> Image:
        """Renders a picture.

        spp, seconds, target_error: when to stop, as in `Renderer.run`: samples a pixel, wall-clock seconds, mean relative
            standard error; whichever comes first, 0 is no limit.
        layers: names of the layers that are read; None: all of `Renderer.layers()`.
        progress: what hears of the fraction done.
        The others are as in `renderer`.

        Errors: those of `renderer` and `Renderer.run`. `CancelledError.result` is the Image of what was done.
        Ctrl-C raises KeyboardInterrupt, and the film is lost; that of a Renderer is kept.
        """
        names = layer_names(layers)
        renderer = self._renderer(scene, width, height, camera, seed, max_bounces, exit, bssrdf)
        try:
            renderer.run(spp, seconds=seconds, target_error=target_error, progress=progress)
            return Image(renderer, names)
        except CancelledError as error:
            error.result = Image(renderer, names)
            raise
        except BaseException:
            renderer.close()
            raise

    def _renderer(
        self,
        scene: Scene,
        width: int,
        height: int,
        camera: Camera | int | None,
        seed: int,
        max_bounces: int,
        exit: str,
        bssrdf: str | None,
    ) -> Renderer:
        """`renderer`, as far below the caller as `render`, so that the warning names the caller's line."""
        if isinstance(scene, Scene) and scene.context is not self:
            raise InvalidArgumentError("scene was made from another context than this one")
        made = Renderer(
            scene, width=width, height=height, camera=camera, seed=seed, max_bounces=max_bounces, exit=exit, bssrdf=bssrdf
        )
        info = scene.info
        if not (info.light_count or info.emissive_triangle_count or info.has_environment):
            warnings.warn(
                "nothing lights the scene: it has no light, no emissive material and a black environment",
                TyndallWarning,
                stacklevel=3,
            )
        return made
