# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Where pictures are taken from."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from .. import capi
from .._core.arrays import array
from .._core.fields import Fields, Numbers, defaults
from ..errors import InvalidArgumentError

_CAMERA = defaults(capi.TynCamera)


@dataclass(frozen=True)
class Camera(Fields):
    """A camera. It looks along its local -Z with +Y up (glTF 2.0). The fields are keyword arguments."""

    _RECORD = capi.TynCamera
    _NAMES = {"type": ("perspective", "orthographic")}
    _SHAPES = {"world_from_camera": (3, 4)}

    type: str = _NAMES["type"][_CAMERA.type]
    """ "perspective" or "orthographic"."""
    world_from_camera: Numbers = _CAMERA.world_from_camera
    """3 x 4: a rotation, and the camera's place in the last column, scene units."""
    yfov: float = _CAMERA.yfov
    """Perspective: vertical field of view, radians, (0, pi)."""
    ymag: float = _CAMERA.ymag
    """Orthographic: half the height of the view, scene units, > 0."""
    aspect_ratio: float = _CAMERA.aspect_ratio
    """Width / height that the camera was made for; 0: the film's. A film of another shape shows more, never less."""
    znear: float = _CAMERA.znear
    """Scene units, >= 0; nearer surfaces are not seen by camera rays."""
    name: str | None = None

    @classmethod
    def look_at(cls, eye: ArrayLike, target: ArrayLike, *, up: ArrayLike = (0.0, 1.0, 0.0), **fields: Any) -> Camera:
        """A camera at `eye` that looks towards `target`, two different points in scene units; `up`, a direction that is not
        along the view, is upwards in the picture. The other fields as for Camera()."""
        place, aim, above = (
            array(value, name, np.float64, (3,)) for value, name in ((eye, "eye"), (target, "target"), (up, "up"))
        )
        back = place - aim
        right = np.cross(above, back)
        if not (np.linalg.norm(back) > 0 and np.linalg.norm(right) > 0):
            raise InvalidArgumentError(f"eye {place}, target {aim} and up {above} do not make a view: see Camera.look_at")
        back, right = back / np.linalg.norm(back), right / np.linalg.norm(right)
        return cls(world_from_camera=np.column_stack([right, np.cross(back, right), back, place]), **fields)
