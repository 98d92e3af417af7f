# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""tyndall_base.h, declared for ctypes: what each thing means is said there."""

from ctypes import CFUNCTYPE, POINTER, Structure, c_char, c_char_p, c_double, c_int32, c_size_t, c_uint32, c_uint64, c_void_p

from .record import Record, Signatures

TYN_VERSION_MAJOR = 0
TYN_VERSION_MINOR = 1
TYN_VERSION_PATCH = 0
TYN_VERSION = 10000 * TYN_VERSION_MAJOR + 100 * TYN_VERSION_MINOR + TYN_VERSION_PATCH

TYN_OK = 0
TYN_ERROR_INVALID_ARGUMENT = 1
TYN_ERROR_INVALID_OPERATION = 2
TYN_ERROR_OUT_OF_MEMORY = 3
TYN_ERROR_NO_DEVICE = 4
TYN_ERROR_KERNEL_BUILD = 5
TYN_ERROR_DEVICE = 6
TYN_ERROR_CANCELLED = 7
TYN_ERROR_FILE = 8
TYN_ERROR_FORMAT = 9
TYN_ERROR_INTERNAL = 10

TynProgress = CFUNCTYPE(c_int32, c_void_p, c_double)


class TynContext(Structure):
    """Opaque."""


class TynDeviceInfo(Record):
    _fields_ = [
        ("name", c_char * 128),
        ("platform", c_char * 128),
        ("driver", c_char * 64),
        ("is_gpu", c_uint32),
        ("compute_units", c_uint32),
        ("memory", c_uint64),
        ("lane_width", c_uint32),
    ]


class TynContextOptions(Record):
    _fields_ = [
        ("size", c_size_t),
        ("device", c_char_p),
        ("cache_directory", c_char_p),
        ("memory_limit", c_uint64),
        ("lane_width", c_uint32),
        ("message", c_char_p),
        ("message_capacity", c_size_t),
    ]


FUNCTIONS: Signatures = {
    "tyn_version": (c_uint32, []),
    "tyn_status_string": (c_char_p, [c_int32]),
    "tyn_device_count": (c_int32, [POINTER(c_uint32)]),
    "tyn_device_info": (c_int32, [c_uint32, POINTER(TynDeviceInfo)]),
    "tyn_context_create": (c_int32, [POINTER(TynContextOptions), POINTER(POINTER(TynContext))]),
    "tyn_context_retain": (None, [POINTER(TynContext)]),
    "tyn_context_release": (None, [POINTER(TynContext)]),
    "tyn_context_message": (c_char_p, [POINTER(TynContext)]),
    "tyn_context_device": (c_int32, [POINTER(TynContext), POINTER(TynDeviceInfo)]),
    "tyn_context_fail": (c_int32, [POINTER(TynContext), c_int32, c_char_p]),
}
