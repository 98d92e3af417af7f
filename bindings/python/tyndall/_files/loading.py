# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Scenes from files, in one call."""

from __future__ import annotations

import os
from typing import Union

from numpy.typing import ArrayLike

from .._bssrdf.paths import Path
from .._core.arrays import array
from .._core.context import ContextHandle
from .._scene.files import LIMITS, Assignments
from .._scene.light import Environment
from .._scene.scene import Scene
from ..errors import InvalidArgumentError

Surroundings = Union[ArrayLike, Path, Environment, None]
"""Light from infinitely far away: a radiance, or an image in a file, or an Environment."""


class LoadCalls(ContextHandle):
    """What makes scenes of files."""

    def load(
        self,
        path: Path,
        *,
        medium: Assignments = None,
        environment: Surroundings = None,
        lights: bool = True,
        max_file_bytes: int = LIMITS.max_file_bytes,
        max_triangles: int = LIMITS.max_triangles,
        max_image_pixels: int = LIMITS.max_image_pixels,
        commit: bool = True,
    ) -> Scene:
        """The scene of a glTF 2.0 file, .gltf or .glb, committed.

        environment: radiance from everywhere, a number or linear RGB, >= 0; or the path of an OpenEXR file, latitude-longitude;
            or an Environment. None: black.
        commit: False for a scene that more can be added to.
        The others are as in `Scene.load_gltf`, as are warnings and errors.
        """
        scene = Scene(self)
        try:
            scene._load_gltf(path, medium, lights, max_file_bytes, max_triangles, max_image_pixels, stacklevel=3)
            if environment is not None:
                scene.set_environment(_environment(scene, environment))
            if commit:
                scene.commit()
            return scene
        except BaseException:
            scene.close()
            raise


def _environment(scene: Scene, value: Surroundings) -> Environment:
    if isinstance(value, Environment):
        return value
    if isinstance(value, (str, os.PathLike)):
        return Environment(radiance=1.0, image=scene.load_exr(value))
    radiance = array(value, "environment")  # type: ignore[arg-type]
    if radiance.shape not in ((), (3,)):
        raise InvalidArgumentError(f"environment has the shape {radiance.shape}; it must be a number, RGB, or a path")
    return Environment(radiance=radiance)
