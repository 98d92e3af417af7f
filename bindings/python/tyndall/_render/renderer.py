# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""The progressive path tracer: a film, samples that are added to it, and its layers."""

from __future__ import annotations

import ctypes
from dataclasses import dataclass, fields
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .. import capi
from .._bssrdf.models import model_choice
from .._core.arrays import data
from .._core.choices import choice
from .._core.handles import Handle
from .._core.numbers import UINT32, UINT64, integer, number
from .._core.progress import LongCall, Progress
from .._scene.camera import Camera
from .._scene.scene import Scene
from .._walk.ledger import Ledger
from ..errors import InvalidArgumentError, InvalidOperationError

LAYERS: dict[str, int] = {capi.lib.tyn_layer_name(layer).decode(): layer for layer in range(capi.TYN_LAYER_COUNT)}
"""The layers of a film and their numbers, capi.TYN_LAYER_*."""

_EXITS = {"diffuse": capi.TYN_EXIT_DIFFUSE, "dielectric": capi.TYN_EXIT_DIELECTRIC}


@dataclass(frozen=True, eq=False)
class RenderStats:
    """What a renderer did so far."""

    width: int
    height: int
    samples: int
    """A pixel."""
    seconds: float
    """Spent in `run`."""
    error: float
    """As in target_error; 0 before 2 samples."""
    paths: int
    nonfinite_paths: int
    """Whose contribution was not finite and was left out; 0 unless there is a defect."""
    seed: int
    ledger: Ledger
    """Where the energy of all walks went."""
    seconds_rays: float
    """Of `seconds`, on the device: camera rays, nearest hits, shadow rays from surfaces. All 0 if it is not known, because a
    caller's queue was made without profiling."""
    seconds_walks: float
    """Walks inside media."""
    seconds_exits: float
    """Light samples and next rays where walks left their medium."""
    seconds_shading: float
    """Materials, light samples and next rays at surfaces, and the film."""

    @classmethod
    def of(cls, record: Any) -> RenderStats:
        """What a TynRenderStats says."""
        values = {field.name: getattr(record, field.name) for field in fields(cls)}
        return cls(**{**values, "ledger": Ledger.of(record.ledger)})


class Renderer(Handle):
    """A progressive path tracer over a committed scene, with a film that samples are added to; made by `Context.renderer`."""

    _kind = "renderer"

    def __init__(
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
    ) -> None:
        """A renderer with an empty film; see `Context.renderer`."""
        if not isinstance(scene, Scene):
            raise InvalidArgumentError(f"scene is {scene!r}; it must be a tyndall.Scene")
        options = capi.TynRenderOptions(
            width=integer(width, "width", 0, UINT32), height=integer(height, "height", 0, UINT32),
            seed=integer(seed, "seed", 0, UINT64), max_bounces=integer(max_bounces, "max_bounces", 0, UINT32),
            exit=choice(exit, "exit", _EXITS), bssrdf=capi.TYN_NONE if bssrdf is None else model_choice(bssrdf, "bssrdf"),
        )  # fmt: skip
        _ = scene.handle
        if not scene.committed:
            raise InvalidOperationError("the scene is not committed; call its commit() first")
        self.scene = scene
        self.width, self.height = int(options.width), int(options.height)
        self.camera = _camera(scene, camera, max(self.width, 1) / max(self.height, 1))
        """The view."""
        options.camera = self.camera.record()
        pointer = ctypes.POINTER(capi.TynRenderer)()
        scene._call(capi.lib.tyn_renderer_create, scene.handle, ctypes.byref(options), ctypes.byref(pointer))
        super().__init__(pointer, capi.lib.tyn_renderer_release, scene)

    def run(self, spp: int = 64, *, seconds: float = 0.0, target_error: float = 0.0, progress: Progress = None) -> None:
        """Adds samples to the film until one of the limits is reached; call it again to go on. The bits of a film depend on the
        number of its samples alone, not on how they were split over calls.

        spp: samples a pixel to add; 0: no limit.
        seconds: wall-clock, looked at between passes; 0: no limit.
        target_error: mean over the pixels of the standard error / (value + 0.01 x mean value) of beauty's luminance, looked at
            at fixed sample counts from 16 on; 0: no limit. At least one of the three must be a limit.
        progress: what hears of the fraction done.

        Errors: InvalidArgumentError, OutOfMemoryError, DeviceError, KernelBuildError; CancelledError, which leaves a valid film
        with fewer samples, as does an exception that `progress` raises.
        """
        budget = capi.TynRenderBudget(
            samples=integer(spp, "spp", 0, UINT32),
            seconds=number(seconds, "seconds"),
            target_error=number(target_error, "target_error"),
        )
        with LongCall(progress, "render") as call:
            budget.progress = call.callback
            self._call(capi.lib.tyn_renderer_run, self.handle, ctypes.byref(budget))

    @staticmethod
    def layers() -> list[str]:
        """The names of the layers of a film. beauty = subsurface + specular + diffuse + emission, by the first thing a path
        did.

        beauty: R G B A, radiance, and the fraction of camera rays that hit something.
        subsurface: R G B, paths whose first event went through a medium.
        specular: R G B, first reflected by an interface or a metal, or passed a thin wall.
        diffuse: R G B, first reflected by an opaque or thin-walled diffuse surface.
        emission: R G B, lights, emissive surfaces and environment seen directly.
        albedo: R G B, colour of the first surface.
        normal: X Y Z, first shading normal, mean over samples.
        depth: mean distance along the view axis of the samples that hit, scene units; inf where none did.
        samples: number of samples.
        variance: R G B, variance of the mean of beauty, the squared standard error.
        """
        return list(LAYERS)

    def read(self, layer: str) -> NDArray[np.float32]:
        """A layer of the film: height x width x channels, rows from top to bottom."""
        number = choice(layer, "layer", LAYERS)
        pixels = np.empty((self.height, self.width, capi.lib.tyn_layer_channels(number)), np.float32)
        self._call(capi.lib.tyn_renderer_read, self.handle, number, data(pixels), pixels.size)
        return pixels

    @property
    def stats(self) -> RenderStats:
        """What was done so far."""
        record = capi.TynRenderStats()
        self._call(capi.lib.tyn_renderer_stats, self.handle, ctypes.byref(record))
        return RenderStats.of(record)

    def __repr__(self) -> str:
        if self.closed:
            return "<tyndall.Renderer, closed>"
        return f"<tyndall.Renderer {self.width} x {self.height}, {self.stats.samples} samples a pixel>"


def _camera(scene: Scene, camera: Camera | int | None, aspect_ratio: float) -> Camera:
    if isinstance(camera, Camera):
        return camera
    if camera is None:
        return scene.camera(0) if scene.info.camera_count else scene.frame(aspect_ratio)
    if isinstance(camera, bool) or not hasattr(camera, "__index__"):
        raise InvalidArgumentError(
            f"camera is {camera!r}; it must be a tyndall.Camera, the index of one of the scene's, or None"
        )
    count = scene.info.camera_count
    if not 0 <= camera < count:
        raise InvalidArgumentError(f"camera is {camera}; the scene has {count} camera{'' if count == 1 else 's'}")
    return scene.camera(camera)
