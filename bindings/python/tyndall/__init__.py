# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Tyndall: light that enters skin, wax, marble or milk, wanders about inside and comes out somewhere else.

    import tyndall as ty

    context = ty.Context()                              # a device; closes at the end of a `with` block, too
    skin = ty.Medium.preset("skin1")                    # coefficients in 1/mm; or Medium(sigma_a, sigma_s, g=0.8, ior=1.4)
    result = context.slab([ty.Layer(skin, thickness=2.0)], photons=1e6, radial=(10.0, 200))
    result.reflectance.total, result.reflectance.total.stderr, result.radial.reflectance

What is made from what:
    Context     slabs (`slab`), scenes (`scene`, `load`), rays (`intersect`, `occluded`), walks (`walk`), BSSRDF models
                (`bssrdf`), pictures (`render`, `renderer`)
    Medium      coefficients and a Phase; in a Layer of a slab, or inside the meshes of a Scene
    exact       closed forms and solvers: adding-doubling, Chandrasekhar's half-space, Seeliger's law
    plot        matplotlib pictures of all of these
    shapes      closed meshes to try things with
    errors      what goes wrong: TyndallError and its kinds
    capi        the C API as it is

Arrays are numpy's: whatever it can view comes in, float32 without a copy; what comes out owns its memory. Of several spectral
channels each has a column, the last axis. Lengths are in a unit of the caller's, coefficients in its inverse, unless media
and scenes say theirs (metres_per_unit). Calls release the GIL, and Ctrl-C cancels the long ones. One context is used by one
thread at a time; different contexts at once.

The environment: TYNDALL_DEVICE chooses the device, TYNDALL_CACHE_DIR the folder of compiled kernels and tables,
TYNDALL_LIBRARY the library to load instead of the package's own.
"""

from . import capi, errors, exact, plot, shapes
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
from .errors import TyndallError, TyndallWarning
from .exact import adding_doubling
from .functions import bssrdf

__version__ = f"{capi.TYN_VERSION_MAJOR}.{capi.TYN_VERSION_MINOR}.{capi.TYN_VERSION_PATCH}"

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
    "TyndallError",
    "TyndallWarning",
    "adding_doubling",
    "albedo_from_color",
    "bssrdf",
    "bssrdf_models",
    "capi",
    "color_from_albedo",
    "default_context",
    "devices",
    "errors",
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
