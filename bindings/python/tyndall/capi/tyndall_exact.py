# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""tyndall_exact.h, declared for ctypes: what each thing means is said there."""

from ctypes import POINTER, c_char_p, c_double, c_int32, c_size_t, c_uint32
from math import inf

from .record import Record, Signatures
from .tyndall_phase import TynPhase
from .tyndall_slab import TynSlab


class TynSingleScattering(Record):
    _fields_ = [
        ("size", c_size_t),
        ("albedo", c_double),
        ("optical_thickness", c_double),
        ("ior", c_double),
        ("phase", POINTER(TynPhase)),
    ]
    _defaults_ = {"optical_thickness": inf, "ior": 1.0}


class TynAddingDoublingOptions(Record):
    _fields_ = [
        ("size", c_size_t),
        ("channel", c_uint32),
        ("incidence", c_uint32),
        ("angle", c_double),
        ("tolerance", c_double),
        ("max_nodes", c_uint32),
        ("cosines", POINTER(c_double)),
        ("cosine_count", c_size_t),
    ]
    _defaults_ = {"tolerance": 1e-6, "max_nodes": 192}


class TynAddingDoublingResult(Record):
    _fields_ = [
        ("size", c_size_t),
        ("reflectance", c_double),
        ("transmittance", c_double),
        ("absorbed", c_double),
        ("specular_reflectance", c_double),
        ("direct_transmittance", c_double),
        ("accuracy", c_double),
        ("nodes", c_uint32),
    ]


FUNCTIONS: Signatures = {
    "tyn_reduced_intensity": (c_double, [c_double, c_double]),
    "tyn_effective_source": (c_double, [c_double, c_double, c_double, c_double]),
    "tyn_seeliger_brdf": (c_double, [c_double, c_double, c_double, c_double]),
    "tyn_hanrahan_krueger": (
        c_int32,
        [POINTER(TynSingleScattering), c_double, c_double, c_double, POINTER(c_double), POINTER(c_double)],
    ),
    "tyn_chandrasekhar_h": (c_int32, [c_double, POINTER(c_double), c_size_t, POINTER(c_double)]),
    "tyn_half_space_brdf": (c_int32, [c_double, c_double, POINTER(c_double), c_size_t, POINTER(c_double)]),
    "tyn_half_space_albedo": (c_int32, [c_double, c_double, POINTER(c_double)]),
    "tyn_adding_doubling": (
        c_int32,
        [
            POINTER(TynSlab),
            POINTER(TynAddingDoublingOptions),
            POINTER(TynAddingDoublingResult),
            POINTER(c_double),
            POINTER(c_double),
            c_char_p,
            c_size_t,
        ],
    ),
}
