# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Tyndall: subsurface scattering."""

from . import exact, shapes
from .bssrdf_records import BSSRDF_ENTRY, BSSRDF_EXIT, BSSRDF_PATH
from .camera import Camera
from .colors import albedo_from_color, color_from_albedo
from .context import Context, default_context
from .devices import Device, devices
from .dtypes import HIT, NONE, RAY, WALK_ENTRY, WALK_EXIT
from .estimate import Estimate
from .exact import adding_doubling
from .exits import Exits
from .files import write_exr, write_png
from .functions import bssrdf
from .image import Image
from .layers import Layer
from .ledger import Ledger
from .light import Environment, Light
from .material import Material, Texture
from .medium import Medium
from .mie import mie, mie_cosines, mie_lognormal, rayleigh_cross_section
from .models import Bssrdf, BssrdfExits, BssrdfSamples, bssrdf_models
from .phase import Phase
from .rays import rays
from .renderer import Renderer, RenderStats
from .scene import Scene
from .scene_info import MeshInfo, SceneInfo
from .slab_results import SlabResult
from .walk_entries import walk_entries, walk_entries_at

__all__ = [
    "BSSRDF_ENTRY",
    "BSSRDF_EXIT",
    "BSSRDF_PATH",
    "HIT",
    "NONE",
    "RAY",
    "WALK_ENTRY",
    "WALK_EXIT",
    "Bssrdf",
    "BssrdfExits",
    "BssrdfSamples",
    "Camera",
    "Context",
    "Device",
    "Environment",
    "Estimate",
    "Exits",
    "Image",
    "Layer",
    "Ledger",
    "Light",
    "Material",
    "Medium",
    "MeshInfo",
    "Phase",
    "RenderStats",
    "Renderer",
    "Scene",
    "SceneInfo",
    "SlabResult",
    "Texture",
    "adding_doubling",
    "albedo_from_color",
    "bssrdf",
    "bssrdf_models",
    "color_from_albedo",
    "default_context",
    "devices",
    "exact",
    "mie",
    "mie_cosines",
    "mie_lognormal",
    "rayleigh_cross_section",
    "rays",
    "shapes",
    "walk_entries",
    "walk_entries_at",
    "write_exr",
    "write_png",
]
