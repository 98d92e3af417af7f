# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""tyndall_io.h, declared for ctypes: what each thing means is said there."""

from ctypes import CFUNCTYPE, POINTER, c_char_p, c_float, c_int32, c_size_t, c_uint32, c_uint64, c_void_p

from .record import Record, Signatures
from .tyndall import TynRenderer, TynScene

TynWarning = CFUNCTYPE(None, c_void_p, c_char_p)


class TynMediumAssignment(Record):
    _fields_ = [
        ("material", c_char_p),
        ("medium", c_char_p),
    ]


class TynGltfOptions(Record):
    _fields_ = [
        ("size", c_size_t),
        ("assignments", POINTER(TynMediumAssignment)),
        ("assignment_count", c_size_t),
        ("skip_lights", c_uint32),
        ("max_file_bytes", c_uint64),
        ("max_triangles", c_uint64),
        ("max_image_pixels", c_uint64),
        ("warning", TynWarning),
        ("user", c_void_p),
    ]
    _defaults_ = {"max_file_bytes": 1 << 30, "max_triangles": 100000000, "max_image_pixels": 1 << 28}


class TynAttribute(Record):
    _fields_ = [
        ("name", c_char_p),
        ("value", c_char_p),
    ]


TYN_TONE_SRGB = 0
TYN_TONE_ACES = 1


class TynPngOptions(Record):
    _fields_ = [
        ("size", c_size_t),
        ("exposure", c_float),
        ("tone", c_uint32),
        ("layer", c_uint32),
        ("transparent", c_uint32),
    ]


FUNCTIONS: Signatures = {
    "tyn_gltf_load": (c_int32, [POINTER(TynScene), c_char_p, POINTER(TynGltfOptions)]),
    "tyn_exr_load": (c_int32, [POINTER(TynScene), c_char_p, POINTER(c_uint32)]),
    "tyn_exr_write": (c_int32, [POINTER(TynRenderer), c_char_p, POINTER(TynAttribute), c_size_t]),
    "tyn_png_write": (c_int32, [POINTER(TynRenderer), c_char_p, POINTER(TynPngOptions)]),
}
