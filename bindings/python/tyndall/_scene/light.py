# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Lights without size, and light from infinitely far away."""

from __future__ import annotations

from dataclasses import dataclass

from .. import capi
from .._core.fields import Fields, Numbers, defaults

_LIGHT = defaults(capi.TynLight)
_ENVIRONMENT = defaults(capi.TynEnvironment)


@dataclass(frozen=True)
class Light(Fields):
    """A light without size (KHR_lights_punctual). The fields are keyword arguments."""

    _RECORD = capi.TynLight
    _NAMES = {"type": ("point", "spot", "directional")}

    type: str = _NAMES["type"][_LIGHT.type]
    """ "point", "spot" or "directional"."""
    position: Numbers = _LIGHT.position
    """Point, spot: x, y, z, scene units."""
    direction: Numbers = _LIGHT.direction
    """Spot, directional: unit, the direction the light travels in."""
    intensity: Numbers = _LIGHT.intensity
    """RGB, or one number for all, >= 0. Point, spot: radiant intensity, power per steradian with lengths in scene units (the
    irradiance at distance d is intensity / d^2); directional: irradiance."""
    inner_cone: float = _LIGHT.inner_cone
    """Spot: half angle at which the falloff begins, radians, [0, outer_cone)."""
    outer_cone: float = _LIGHT.outer_cone
    """Spot: half angle at which it reaches 0, radians, (0, pi/2]."""
    name: str | None = None


@dataclass(frozen=True)
class Environment(Fields):
    """Light from infinitely far away. An image is latitude-longitude: its centre column looks along -Z (glTF's default view),
    its top row along +Y, columns run to the right (+X). The fields are keyword arguments."""

    _RECORD = capi.TynEnvironment
    _INDICES = ("image",)

    radiance: Numbers = _ENVIRONMENT.radiance
    """RGB, or one number for all, >= 0: constant radiance, or a factor on the image."""
    image: int | None = None
    """Index from `Scene.add_image` of float32 pixels; None: constant."""
    rotation: float = _ENVIRONMENT.rotation
    """Radians about +Y, counter-clockwise seen from above."""
    hidden_from_camera: bool = bool(_ENVIRONMENT.hidden_from_camera)
    """Camera rays that leave the scene see black (alpha is 0 either way)."""
