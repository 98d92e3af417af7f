# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""tyndall_phase.h, declared for ctypes: what each thing means is said there."""

from ctypes import POINTER, c_char_p, c_double, c_int32, c_size_t, c_uint32, c_uint64

from .record import Record, Signatures


class TynPhase(Record):
    _fields_ = [
        ("size", c_size_t),
        ("kind", c_uint32),
        ("g", c_double),
        ("g2", c_double),
        ("weight", c_double),
        ("alpha", c_double),
        ("cosines", POINTER(c_double)),
        ("values", POINTER(c_double)),
        ("count", c_uint32),
    ]
    _defaults_ = {"weight": 1.0}


class TynMie(Record):
    _fields_ = [
        ("q_ext", c_double),
        ("q_sca", c_double),
        ("q_abs", c_double),
        ("q_back", c_double),
        ("mean_cosine", c_double),
    ]


class TynMieDistribution(Record):
    _fields_ = [
        ("size", c_size_t),
        ("median_radius", c_double),
        ("geometric_deviation", c_double),
        ("wavelength", c_double),
        ("relative_index", c_double * 2),
    ]
    _defaults_ = {"geometric_deviation": 1.0}


class TynMieCrossSections(Record):
    _fields_ = [
        ("extinction", c_double),
        ("scattering", c_double),
        ("absorption", c_double),
        ("mean_cosine", c_double),
    ]


FUNCTIONS: Signatures = {
    "tyn_phase_name": (c_char_p, [c_uint32]),
    "tyn_phase_value": (c_int32, [POINTER(TynPhase), POINTER(c_double), c_size_t, POINTER(c_double)]),
    "tyn_phase_sample": (c_int32, [POINTER(TynPhase), c_uint64, c_uint64, c_size_t, POINTER(c_double)]),
    "tyn_phase_pdf": (c_int32, [POINTER(TynPhase), POINTER(c_double), c_size_t, POINTER(c_double)]),
    "tyn_phase_moments": (c_int32, [POINTER(TynPhase), c_size_t, POINTER(c_double)]),
    "tyn_phase_mean_cosine": (c_int32, [POINTER(TynPhase), POINTER(c_double)]),
    "tyn_rayleigh_cross_section": (c_int32, [c_double, c_double, POINTER(c_double), POINTER(c_double)]),
    "tyn_mie": (c_int32, [c_double, POINTER(c_double), POINTER(TynMie), POINTER(c_double), c_size_t, POINTER(c_double)]),
    "tyn_mie_lognormal": (
        c_int32,
        [POINTER(TynMieDistribution), POINTER(TynMieCrossSections), POINTER(c_double), c_size_t, POINTER(c_double)],
    ),
    "tyn_mie_cosines": (c_int32, [c_double, c_size_t, POINTER(c_double)]),
}
