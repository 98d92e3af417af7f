# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""tyndall.h, declared for ctypes: what each thing means is said there."""

from ctypes import POINTER, Structure, c_char_p, c_double, c_float, c_int32, c_size_t, c_uint32, c_uint64, c_void_p

from .record import Record, Signatures
from .tyndall_base import TynContext, TynProgress
from .tyndall_bssrdf import TynBssrdf
from .tyndall_phase import TynPhase
from .tyndall_types import TYN_NONE, TynBssrdfEntry, TynBssrdfExit, TynHit, TynRay, TynWalkEntry, TynWalkExit


class TynMedium(Record):
    _fields_ = [
        ("size", c_size_t),
        ("name", c_char_p),
        ("sigma_a", c_float * 3),
        ("sigma_s", c_float * 3),
        ("g", c_float),
        ("ior", c_float),
        ("phase", POINTER(TynPhase)),
    ]
    _defaults_ = {"ior": 1.0}


class TynMediumDescription(Record):
    _fields_ = [
        ("albedo", c_float * 3),
        ("diffuse_albedo", c_float * 3),
        ("mean_free_path_mm", c_double * 3),
        ("transport_mean_free_path_mm", c_double * 3),
        ("diffusion_length_mm", c_double * 3),
        ("mean_free_path_fraction", c_double * 3),
        ("transport_mean_free_path_fraction", c_double * 3),
        ("diffusion_length_fraction", c_double * 3),
    ]


class TynScene(Structure):
    """Opaque."""


class TynSceneOptions(Record):
    _fields_ = [
        ("size", c_size_t),
        ("metres_per_unit", c_double),
    ]
    _defaults_ = {"metres_per_unit": 1.0}


TYN_IMAGE_RGBA8_SRGB = 0
TYN_IMAGE_RGBA8_LINEAR = 1
TYN_IMAGE_RGBA32F = 2


class TynImage(Record):
    _fields_ = [
        ("size", c_size_t),
        ("name", c_char_p),
        ("width", c_uint32),
        ("height", c_uint32),
        ("format", c_uint32),
        ("pixels", c_void_p),
        ("row_stride", c_size_t),
    ]


TYN_WRAP_REPEAT = 0
TYN_WRAP_CLAMP = 1
TYN_WRAP_MIRROR = 2

TYN_FILTER_LINEAR = 0
TYN_FILTER_NEAREST = 1


class TynTexture(Record):
    _fields_ = [
        ("image", c_uint32),
        ("wrap_u", c_uint32),
        ("wrap_v", c_uint32),
        ("filter", c_uint32),
        ("transform", c_float * 6),
    ]
    _defaults_ = {"image": TYN_NONE, "transform": (1.0, 0.0, 0.0, 0.0, 1.0, 0.0)}


class TynMaterial(Record):
    _fields_ = [
        ("size", c_size_t),
        ("name", c_char_p),
        ("base_color", c_float * 3),
        ("metallic", c_float),
        ("roughness", c_float),
        ("ior", c_float),
        ("transmission", c_float),
        ("emission", c_float * 3),
        ("normal_scale", c_float),
        ("double_sided", c_uint32),
        ("thin_walled", c_uint32),
        ("thin_scatter", c_float),
        ("thin_scatter_color", c_float * 3),
        ("thin_scatter_anisotropy", c_float),
        ("multiscatter_color", c_float * 3),
        ("scatter_strength", c_float),
        ("base_color_texture", TynTexture),
        ("metallic_roughness_texture", TynTexture),
        ("normal_texture", TynTexture),
        ("emission_texture", TynTexture),
        ("transmission_texture", TynTexture),
        ("multiscatter_color_texture", TynTexture),
        ("scatter_strength_texture", TynTexture),
    ]
    _defaults_ = {
        "base_color": (1.0, 1.0, 1.0),
        "roughness": 1.0,
        "ior": 1.5,
        "normal_scale": 1.0,
        "thin_scatter_color": (1.0, 1.0, 1.0),
        "multiscatter_color": (-1.0, 0.0, 0.0),
        "scatter_strength": 1.0,
        "base_color_texture": TynTexture(),
        "metallic_roughness_texture": TynTexture(),
        "normal_texture": TynTexture(),
        "emission_texture": TynTexture(),
        "transmission_texture": TynTexture(),
        "multiscatter_color_texture": TynTexture(),
        "scatter_strength_texture": TynTexture(),
    }


class TynMesh(Record):
    _fields_ = [
        ("size", c_size_t),
        ("name", c_char_p),
        ("positions", POINTER(c_float)),
        ("position_stride", c_size_t),
        ("vertex_count", c_uint32),
        ("normals", POINTER(c_float)),
        ("normal_stride", c_size_t),
        ("uvs", POINTER(c_float)),
        ("uv_stride", c_size_t),
        ("indices", POINTER(c_uint32)),
        ("triangle_count", c_uint32),
        ("medium", c_uint32),
        ("material", c_uint32),
        ("triangle_materials", POINTER(c_uint32)),
    ]
    _defaults_ = {"medium": TYN_NONE, "material": TYN_NONE}


TYN_LIGHT_POINT = 0
TYN_LIGHT_SPOT = 1
TYN_LIGHT_DIRECTIONAL = 2


class TynLight(Record):
    _fields_ = [
        ("size", c_size_t),
        ("name", c_char_p),
        ("type", c_uint32),
        ("position", c_float * 3),
        ("direction", c_float * 3),
        ("intensity", c_float * 3),
        ("inner_cone", c_float),
        ("outer_cone", c_float),
    ]
    _defaults_ = {"direction": (0.0, 0.0, -1.0), "intensity": (1.0, 1.0, 1.0), "outer_cone": 0.78539816}


class TynEnvironment(Record):
    _fields_ = [
        ("size", c_size_t),
        ("radiance", c_float * 3),
        ("image", c_uint32),
        ("rotation", c_float),
        ("hidden_from_camera", c_uint32),
    ]
    _defaults_ = {"image": TYN_NONE}


TYN_CAMERA_PERSPECTIVE = 0
TYN_CAMERA_ORTHOGRAPHIC = 1


class TynCamera(Record):
    _fields_ = [
        ("size", c_size_t),
        ("name", c_char_p),
        ("type", c_uint32),
        ("world_from_camera", c_float * 12),
        ("yfov", c_float),
        ("ymag", c_float),
        ("aspect_ratio", c_float),
        ("znear", c_float),
    ]
    _defaults_ = {"world_from_camera": (1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0), "yfov": 0.69, "ymag": 1.0}


class TynSceneInfo(Record):
    _fields_ = [
        ("size", c_size_t),
        ("mesh_count", c_uint32),
        ("medium_count", c_uint32),
        ("material_count", c_uint32),
        ("image_count", c_uint32),
        ("light_count", c_uint32),
        ("camera_count", c_uint32),
        ("emissive_triangle_count", c_uint32),
        ("has_environment", c_uint32),
        ("triangle_count", c_uint64),
        ("metres_per_unit", c_double),
        ("lower", c_float * 3),
        ("upper", c_float * 3),
    ]


class TynMeshInfo(Record):
    _fields_ = [
        ("size", c_size_t),
        ("name", c_char_p),
        ("vertex_count", c_uint32),
        ("triangle_count", c_uint32),
        ("welded_vertex_count", c_uint32),
        ("closed", c_uint32),
        ("boundary_edges", c_uint32),
        ("nonmanifold_edges", c_uint32),
        ("degenerate_triangles", c_uint32),
        ("duplicate_triangles", c_uint32),
        ("components", c_uint32),
        ("inverted_components", c_uint32),
        ("turned_triangles", c_uint32),
        ("medium", c_uint32),
        ("material", c_uint32),
        ("area", c_double),
        ("volume", c_double),
        ("lower", c_float * 3),
        ("upper", c_float * 3),
        ("overlapping_components", c_uint32),
    ]


class TynWalkOptions(Record):
    _fields_ = [
        ("size", c_size_t),
        ("seed", c_uint64),
        ("first_path", c_uint64),
        ("max_scatterings", c_uint32),
        ("roulette_threshold", c_float),
        ("roulette_off", c_uint32),
        ("progress", TynProgress),
        ("user", c_void_p),
    ]
    _defaults_ = {"roulette_threshold": 0.1}


class TynLedger(Record):
    _fields_ = [
        ("entered", c_double * 3),
        ("reflected", c_double * 3),
        ("escaped", c_double * 3),
        ("absorbed", c_double * 3),
        ("balance", c_double * 3),
        ("capped", c_double * 3),
        ("leaked", c_double * 3),
        ("lost", c_double * 3),
        ("walks", c_uint64),
        ("escaped_walks", c_uint64),
        ("absorbed_walks", c_uint64),
        ("capped_walks", c_uint64),
        ("leaked_walks", c_uint64),
        ("lost_walks", c_uint64),
        ("reflected_walks", c_uint64),
        ("scatterings", c_uint64),
    ]


class TynRenderer(Structure):
    """Opaque."""


TYN_EXIT_DIFFUSE = 0
TYN_EXIT_DIELECTRIC = 1


class TynRenderOptions(Record):
    _fields_ = [
        ("size", c_size_t),
        ("width", c_uint32),
        ("height", c_uint32),
        ("camera", TynCamera),
        ("seed", c_uint64),
        ("max_bounces", c_uint32),
        ("exit", c_uint32),
        ("bssrdf", c_uint32),
    ]
    _defaults_ = {"width": 640, "height": 480, "camera": TynCamera(), "max_bounces": 64, "bssrdf": TYN_NONE}


class TynRenderBudget(Record):
    _fields_ = [
        ("size", c_size_t),
        ("samples", c_uint32),
        ("seconds", c_double),
        ("target_error", c_double),
        ("progress", TynProgress),
        ("user", c_void_p),
    ]
    _defaults_ = {"samples": 64}


TYN_LAYER_BEAUTY = 0
TYN_LAYER_SUBSURFACE = 1
TYN_LAYER_SPECULAR = 2
TYN_LAYER_DIFFUSE = 3
TYN_LAYER_EMISSION = 4
TYN_LAYER_ALBEDO = 5
TYN_LAYER_NORMAL = 6
TYN_LAYER_DEPTH = 7
TYN_LAYER_SAMPLES = 8
TYN_LAYER_VARIANCE = 9
TYN_LAYER_COUNT = 10


class TynRenderStats(Record):
    _fields_ = [
        ("size", c_size_t),
        ("width", c_uint32),
        ("height", c_uint32),
        ("samples", c_uint32),
        ("seconds", c_double),
        ("error", c_double),
        ("paths", c_uint64),
        ("nonfinite_paths", c_uint64),
        ("seed", c_uint64),
        ("ledger", TynLedger),
        ("seconds_rays", c_double),
        ("seconds_walks", c_double),
        ("seconds_exits", c_double),
        ("seconds_shading", c_double),
    ]


FUNCTIONS: Signatures = {
    "tyn_medium_preset_count": (c_uint32, []),
    "tyn_medium_preset_name": (c_char_p, [c_uint32]),
    "tyn_medium_preset": (c_int32, [c_char_p, c_double, POINTER(TynMedium)]),
    "tyn_albedo_from_color": (c_float, [c_float, c_float]),
    "tyn_color_from_albedo": (c_float, [c_float, c_float]),
    "tyn_medium_describe": (c_int32, [POINTER(TynMedium), c_double, c_double, POINTER(TynMediumDescription)]),
    "tyn_scene_create": (c_int32, [POINTER(TynContext), POINTER(TynSceneOptions), POINTER(POINTER(TynScene))]),
    "tyn_scene_retain": (None, [POINTER(TynScene)]),
    "tyn_scene_release": (None, [POINTER(TynScene)]),
    "tyn_scene_context": (POINTER(TynContext), [POINTER(TynScene)]),
    "tyn_scene_add_image": (c_int32, [POINTER(TynScene), POINTER(TynImage), POINTER(c_uint32)]),
    "tyn_scene_add_medium": (c_int32, [POINTER(TynScene), POINTER(TynMedium), POINTER(c_uint32)]),
    "tyn_scene_add_material": (c_int32, [POINTER(TynScene), POINTER(TynMaterial), POINTER(c_uint32)]),
    "tyn_scene_add_mesh": (c_int32, [POINTER(TynScene), POINTER(TynMesh), POINTER(c_uint32)]),
    "tyn_scene_add_light": (c_int32, [POINTER(TynScene), POINTER(TynLight), POINTER(c_uint32)]),
    "tyn_scene_add_camera": (c_int32, [POINTER(TynScene), POINTER(TynCamera), POINTER(c_uint32)]),
    "tyn_scene_set_environment": (c_int32, [POINTER(TynScene), POINTER(TynEnvironment)]),
    "tyn_scene_clear_lights": (c_int32, [POINTER(TynScene)]),
    "tyn_scene_commit": (c_int32, [POINTER(TynScene)]),
    "tyn_scene_info": (c_int32, [POINTER(TynScene), POINTER(TynSceneInfo)]),
    "tyn_scene_mesh_info": (c_int32, [POINTER(TynScene), c_uint32, POINTER(TynMeshInfo)]),
    "tyn_scene_medium": (c_int32, [POINTER(TynScene), c_uint32, POINTER(TynMedium)]),
    "tyn_scene_camera": (c_int32, [POINTER(TynScene), c_uint32, POINTER(TynCamera)]),
    "tyn_intersect": (c_int32, [POINTER(TynScene), c_uint32, POINTER(TynRay), c_size_t, POINTER(TynHit)]),
    "tyn_occluded": (c_int32, [POINTER(TynScene), c_uint32, POINTER(TynRay), c_size_t, POINTER(c_uint32)]),
    "tyn_walk": (
        c_int32,
        [POINTER(TynScene), POINTER(TynWalkOptions), POINTER(TynWalkEntry), c_size_t, POINTER(TynWalkExit), POINTER(TynLedger)],
    ),
    "tyn_bssrdf_sample_exits": (
        c_int32,
        [
            POINTER(TynBssrdf),
            POINTER(TynScene),
            c_uint64,
            c_uint64,
            POINTER(TynBssrdfEntry),
            c_size_t,
            POINTER(TynBssrdfExit),
            POINTER(c_float),
        ],
    ),
    "tyn_scene_frame": (c_int32, [POINTER(TynScene), c_float, POINTER(TynCamera)]),
    "tyn_renderer_create": (c_int32, [POINTER(TynScene), POINTER(TynRenderOptions), POINTER(POINTER(TynRenderer))]),
    "tyn_renderer_retain": (None, [POINTER(TynRenderer)]),
    "tyn_renderer_release": (None, [POINTER(TynRenderer)]),
    "tyn_renderer_scene": (POINTER(TynScene), [POINTER(TynRenderer)]),
    "tyn_renderer_run": (c_int32, [POINTER(TynRenderer), POINTER(TynRenderBudget)]),
    "tyn_layer_name": (c_char_p, [c_uint32]),
    "tyn_layer_channels": (c_uint32, [c_uint32]),
    "tyn_renderer_read": (c_int32, [POINTER(TynRenderer), c_uint32, POINTER(c_float), c_size_t]),
    "tyn_renderer_stats": (c_int32, [POINTER(TynRenderer), POINTER(TynRenderStats)]),
}
