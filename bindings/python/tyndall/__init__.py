# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Tyndall: subsurface scattering."""

from . import exact, plot, shapes
from ._bssrdf.models import Bssrdf, BssrdfExits, BssrdfSamples, bssrdf_models
from ._bssrdf.records import BSSRDF_ENTRY, BSSRDF_EXIT, BSSRDF_PATH
from ._core.devices import Device, devices
from ._core.dtypes import HIT, NONE, RAY, WALK_ENTRY, WALK_EXIT
from ._files.writing import write_exr, write_png
from ._media.colors import albedo_from_color, color_from_albedo
from ._media.medium import Medium
from ._media.mie import mie, mie_cosines, mie_lognormal, rayleigh_cross_section
from ._media.phase import Phase
from ._render.image import Image
from ._render.renderer import Renderer, RenderStats
from ._scene.camera import Camera
from ._scene.info import MeshInfo, SceneInfo
from ._scene.light import Environment, Light
from ._scene.material import Material, Texture
from ._scene.rays import rays
from ._scene.scene import Scene
from ._slab.estimate import Estimate
from ._slab.layers import Layer
from ._slab.results import SlabResult
from ._walk.entries import walk_entries, walk_entries_at
from ._walk.exits import Exits
from ._walk.ledger import Ledger
from .context import Context, default_context
from .exact import adding_doubling
from .functions import bssrdf

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
    "plot",
    "rayleigh_cross_section",
    "rays",
    "shapes",
    "walk_entries",
    "walk_entries_at",
    "write_exr",
    "write_png",
]
