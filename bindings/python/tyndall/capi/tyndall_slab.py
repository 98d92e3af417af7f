# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""tyndall_slab.h, declared for ctypes: what each thing means is said there."""

from ctypes import POINTER, Structure, c_char_p, c_double, c_int32, c_size_t, c_uint32, c_uint64, c_void_p
from math import inf

from .record import Record, Signatures
from .tyndall_base import TynContext, TynProgress
from .tyndall_phase import TynPhase


class TynSlabLayer(Record):
    _fields_ = [
        ("size", c_size_t),
        ("sigma_a", POINTER(c_double)),
        ("sigma_s", POINTER(c_double)),
        ("g", c_double),
        ("phase", POINTER(TynPhase)),
        ("ior", c_double),
        ("thickness", c_double),
    ]
    _defaults_ = {"ior": 1.0, "thickness": inf}


class TynSlab(Record):
    _fields_ = [
        ("size", c_size_t),
        ("channel_count", c_uint32),
        ("layer_count", c_uint32),
        ("layers", POINTER(TynSlabLayer)),
        ("ior_above", c_double),
        ("ior_below", c_double),
    ]
    _defaults_ = {"channel_count": 1, "ior_above": 1.0, "ior_below": 1.0}


class TynSlabOptions(Record):
    _fields_ = [
        ("size", c_size_t),
        ("incidence", c_uint32),
        ("angle", c_double),
        ("beam", c_uint32),
        ("beam_radius", c_double),
        ("photons", c_uint64),
        ("seconds", c_double),
        ("target_error", c_double),
        ("seed", c_uint64),
        ("max_order", c_uint32),
        ("roulette_threshold", c_double),
        ("radial_max", c_double),
        ("radial_bins", c_uint32),
        ("angular_bins", c_uint32),
        ("radial_angular", c_uint32),
        ("depth_max", c_double),
        ("depth_bins", c_uint32),
        ("order_bins", c_uint32),
        ("path_max", c_double),
        ("path_bins", c_uint32),
        ("sweep_count", c_uint32),
        ("sweep_sigma_a", POINTER(c_double)),
        ("sweep_sigma_s", POINTER(c_double)),
        ("progress", TynProgress),
        ("user", c_void_p),
    ]
    _defaults_ = {"photons": 1000000, "roulette_threshold": 0.1}


class TynEstimate(Record):
    _fields_ = [
        ("value", c_double),
        ("standard_error", c_double),
    ]


class TynSlabTotals(Record):
    _fields_ = [
        ("size", c_size_t),
        ("specular_reflectance", TynEstimate),
        ("diffuse_reflectance", TynEstimate),
        ("reflectance", TynEstimate),
        ("direct_transmittance", TynEstimate),
        ("diffuse_transmittance", TynEstimate),
        ("transmittance", TynEstimate),
        ("absorbed", TynEstimate),
        ("cut", TynEstimate),
    ]


class TynSlabRun(Record):
    _fields_ = [
        ("size", c_size_t),
        ("photons", c_uint64),
        ("events", c_uint64),
        ("seconds", c_double),
        ("build_seconds", c_double),
        ("seed", c_uint64),
        ("channel_count", c_uint32),
        ("layer_count", c_uint32),
    ]


TYN_SLAB_LAYER_ABSORBED = 0
TYN_SLAB_RADIAL_REFLECTANCE = 1
TYN_SLAB_RADIAL_TRANSMITTANCE = 2
TYN_SLAB_ANGULAR_REFLECTANCE = 3
TYN_SLAB_ANGULAR_TRANSMITTANCE = 4
TYN_SLAB_RADIAL_ANGULAR_REFLECTANCE = 5
TYN_SLAB_RADIAL_ANGULAR_TRANSMITTANCE = 6
TYN_SLAB_DEPTH_ABSORBED = 7
TYN_SLAB_DEPTH_FLUENCE = 8
TYN_SLAB_ORDER_REFLECTANCE = 9
TYN_SLAB_ORDER_TRANSMITTANCE = 10
TYN_SLAB_PATH_REFLECTANCE = 11
TYN_SLAB_PATH_TRANSMITTANCE = 12
TYN_SLAB_SWEEP_REFLECTANCE = 13
TYN_SLAB_SWEEP_TRANSMITTANCE = 14
TYN_SLAB_SWEEP_ABSORBED = 15
TYN_SLAB_QUANTITY_COUNT = 16


class TynSlabResult(Structure):
    """Opaque."""


FUNCTIONS: Signatures = {
    "tyn_slab_quantity_name": (c_char_p, [c_uint32]),
    "tyn_slab_simulate": (
        c_int32,
        [POINTER(TynContext), POINTER(TynSlab), POINTER(TynSlabOptions), POINTER(POINTER(TynSlabResult))],
    ),
    "tyn_slab_result_retain": (None, [POINTER(TynSlabResult)]),
    "tyn_slab_result_release": (None, [POINTER(TynSlabResult)]),
    "tyn_slab_result_run": (c_int32, [POINTER(TynSlabResult), POINTER(TynSlabRun)]),
    "tyn_slab_result_totals": (c_int32, [POINTER(TynSlabResult), c_uint32, POINTER(TynSlabTotals)]),
    "tyn_slab_result_count": (c_size_t, [POINTER(TynSlabResult), c_uint32]),
    "tyn_slab_result_read": (
        c_int32,
        [POINTER(TynSlabResult), c_uint32, c_uint32, POINTER(c_double), POINTER(c_double), c_size_t],
    ),
}
