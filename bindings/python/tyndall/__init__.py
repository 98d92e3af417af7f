# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Tyndall: subsurface scattering."""

from . import exact
from .colors import albedo_from_color, color_from_albedo
from .context import Context, default_context
from .devices import Device, devices
from .estimate import Estimate
from .exact import adding_doubling
from .layers import Layer
from .medium import Medium
from .mie import mie, mie_cosines, mie_lognormal, rayleigh_cross_section
from .phase import Phase
from .slab_results import SlabResult

__all__ = [
    "Context",
    "Device",
    "Estimate",
    "Layer",
    "Medium",
    "Phase",
    "SlabResult",
    "adding_doubling",
    "albedo_from_color",
    "color_from_albedo",
    "default_context",
    "devices",
    "exact",
    "mie",
    "mie_cosines",
    "mie_lognormal",
    "rayleigh_cross_section",
]
