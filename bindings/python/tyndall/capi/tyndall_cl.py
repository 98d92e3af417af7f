# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""tyndall_cl.h, declared for ctypes: what each thing means is said there."""

from ctypes import POINTER, c_int32, c_size_t, c_uint32, c_uint64, c_void_p

from .record import Signatures
from .tyndall import TynLedger, TynScene, TynWalkOptions
from .tyndall_base import TynContext, TynContextOptions
from .tyndall_bssrdf import TynBssrdf

FUNCTIONS: Signatures = {
    "tyn_context_create_cl": (c_int32, [POINTER(TynContextOptions), c_void_p, c_void_p, POINTER(POINTER(TynContext))]),
    "tyn_context_cl": (c_int32, [POINTER(TynContext), POINTER(c_void_p), POINTER(c_void_p), POINTER(c_void_p)]),
    "tyn_intersect_cl": (c_int32, [POINTER(TynScene), c_uint32, c_void_p, c_size_t, c_void_p]),
    "tyn_occluded_cl": (c_int32, [POINTER(TynScene), c_uint32, c_void_p, c_size_t, c_void_p]),
    "tyn_walk_cl": (c_int32, [POINTER(TynScene), POINTER(TynWalkOptions), c_void_p, c_size_t, c_void_p, POINTER(TynLedger)]),
    "tyn_bssrdf_profile_cl": (c_int32, [POINTER(TynBssrdf), c_void_p, c_size_t, c_void_p]),
    "tyn_bssrdf_pdf_cl": (c_int32, [POINTER(TynBssrdf), c_void_p, c_size_t, c_void_p]),
    "tyn_bssrdf_sample_cl": (c_int32, [POINTER(TynBssrdf), c_uint64, c_uint64, c_size_t, c_void_p, c_void_p, c_void_p]),
    "tyn_bssrdf_evaluate_cl": (c_int32, [POINTER(TynBssrdf), c_void_p, c_size_t, c_void_p]),
    "tyn_bssrdf_sample_exits_cl": (
        c_int32,
        [POINTER(TynBssrdf), POINTER(TynScene), c_uint64, c_uint64, c_void_p, c_size_t, c_void_p, c_void_p],
    ),
}
