# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""tyndall_bssrdf.h, declared for ctypes: what each thing means is said there."""

from ctypes import POINTER, Structure, c_char_p, c_double, c_float, c_int32, c_size_t, c_uint32, c_uint64, c_void_p

from .record import Record, Signatures
from .tyndall_base import TynContext, TynProgress
from .tyndall_slab import TynSlab
from .tyndall_types import TynBssrdfPath


class TynBssrdfOptions(Record):
    _fields_ = [
        ("size", c_size_t),
        ("model", c_uint32),
        ("fit", c_uint32),
        ("transmitted", c_uint32),
        ("gaussian_count", c_uint32),
        ("gaussian_weights", POINTER(c_double)),
        ("gaussian_variances", POINTER(c_double)),
        ("exact_events", c_uint64),
        ("progress", TynProgress),
        ("user", c_void_p),
    ]
    _defaults_ = {"exact_events": 1500000000}


class TynBssrdf(Structure):
    """Opaque."""


FUNCTIONS: Signatures = {
    "tyn_bssrdf_model_name": (c_char_p, [c_uint32]),
    "tyn_bssrdf_find_model": (c_uint32, [c_char_p]),
    "tyn_bssrdf_create": (
        c_int32,
        [POINTER(TynContext), POINTER(TynSlab), POINTER(TynBssrdfOptions), POINTER(POINTER(TynBssrdf))],
    ),
    "tyn_bssrdf_retain": (None, [POINTER(TynBssrdf)]),
    "tyn_bssrdf_release": (None, [POINTER(TynBssrdf)]),
    "tyn_bssrdf_albedo": (c_int32, [POINTER(TynBssrdf), POINTER(c_double), c_size_t]),
    "tyn_bssrdf_profile": (c_int32, [POINTER(TynBssrdf), POINTER(c_float), c_size_t, POINTER(c_float)]),
    "tyn_bssrdf_profile_error": (c_int32, [POINTER(TynBssrdf), POINTER(c_float), c_size_t, POINTER(c_float)]),
    "tyn_bssrdf_sample": (
        c_int32,
        [POINTER(TynBssrdf), c_uint64, c_uint64, c_size_t, POINTER(c_float), POINTER(c_float), POINTER(c_float)],
    ),
    "tyn_bssrdf_pdf": (c_int32, [POINTER(TynBssrdf), POINTER(c_float), c_size_t, POINTER(c_float)]),
    "tyn_bssrdf_evaluate": (c_int32, [POINTER(TynBssrdf), POINTER(TynBssrdfPath), c_size_t, POINTER(c_float)]),
}
