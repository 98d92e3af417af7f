# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""tyndall_types.h, declared for ctypes: what each thing means is said there."""

from ctypes import c_float, c_uint32

from .record import Record

TYN_NONE = 0xFFFFFFFF


class TynRay(Record):
    _fields_ = [
        ("origin", c_float * 3),
        ("t_min", c_float),
        ("direction", c_float * 3),
        ("t_max", c_float),
    ]


class TynHit(Record):
    _fields_ = [
        ("t", c_float),
        ("u", c_float),
        ("v", c_float),
        ("mesh", c_uint32),
        ("triangle", c_uint32),
        ("normal", c_float * 3),
    ]


TYN_ENTRY_INSIDE = 0
TYN_ENTRY_REFRACT = 1
TYN_ENTRY_COSINE = 2


class TynWalkEntry(Record):
    _fields_ = [
        ("position", c_float * 3),
        ("kind", c_uint32),
        ("direction", c_float * 3),
        ("mesh", c_uint32),
        ("weight", c_float * 3),
        ("triangle", c_uint32),
        ("albedo", c_float * 3),
        ("medium", c_uint32),
        ("sigma_t", c_float * 3),
        ("reserved", c_uint32),
        ("roughness", c_float),
        ("path", c_uint32 * 2),
        ("reserved2", c_uint32),
    ]


TYN_WALK_ESCAPED = 0
TYN_WALK_ABSORBED = 1
TYN_WALK_CAPPED = 2
TYN_WALK_LEAKED = 3
TYN_WALK_LOST = 4
TYN_WALK_REFLECTED = 5


class TynWalkExit(Record):
    _fields_ = [
        ("position", c_float * 3),
        ("status", c_uint32),
        ("direction", c_float * 3),
        ("triangle", c_uint32),
        ("weight", c_float * 3),
        ("scatterings", c_uint32),
        ("geometric_normal", c_float * 3),
        ("path_length", c_float),
        ("shading_normal", c_float * 3),
        ("u", c_float),
        ("uv", c_float * 2),
        ("v", c_float),
        ("reserved", c_uint32),
    ]


class TynBssrdfEntry(Record):
    _fields_ = [
        ("position", c_float * 3),
        ("mesh", c_uint32),
        ("normal", c_float * 3),
        ("reserved", c_uint32),
        ("path", c_uint32 * 2),
        ("reserved2", c_uint32 * 2),
    ]


TYN_BSSRDF_EXIT_FOUND = 0
TYN_BSSRDF_EXIT_NONE = 1
TYN_BSSRDF_EXIT_LOST = 2


class TynBssrdfExit(Record):
    _fields_ = [
        ("position", c_float * 3),
        ("status", c_uint32),
        ("geometric_normal", c_float * 3),
        ("triangle", c_uint32),
        ("shading_normal", c_float * 3),
        ("hits", c_uint32),
        ("u", c_float),
        ("v", c_float),
        ("uv", c_float * 2),
        ("distance", c_float),
        ("pdf", c_float),
        ("reserved", c_uint32 * 2),
    ]


TYN_PHASE_ISOTROPIC = 0
TYN_PHASE_RAYLEIGH = 1
TYN_PHASE_HENYEY_GREENSTEIN = 2
TYN_PHASE_TWO_LOBE = 3
TYN_PHASE_DRAINE = 4
TYN_PHASE_TABULATED = 5
TYN_PHASE_KIND_COUNT = 6

TYN_BSSRDF_STANDARD_DIPOLE = 0
TYN_BSSRDF_BETTER_DIPOLE = 1
TYN_BSSRDF_PHOTON_BEAM_DIFFUSION = 2
TYN_BSSRDF_MULTIPOLE = 3
TYN_BSSRDF_NORMALIZED_DIFFUSION = 4
TYN_BSSRDF_GAUSSIANS = 5
TYN_BSSRDF_SINGLE_SCATTERING = 6
TYN_BSSRDF_QUANTIZED_DIFFUSION = 7
TYN_BSSRDF_DIRECTIONAL_DIPOLE = 8
TYN_BSSRDF_EXACT = 9
TYN_BSSRDF_MODEL_COUNT = 10


class TynBssrdfPath(Record):
    _fields_ = [
        ("entry_position", c_float * 3),
        ("entry_normal", c_float * 3),
        ("entry_direction", c_float * 3),
        ("exit_position", c_float * 3),
        ("exit_normal", c_float * 3),
        ("exit_direction", c_float * 3),
    ]


TYN_NORMALIZED_SEARCHLIGHT = 0
TYN_NORMALIZED_DIFFUSE = 1
TYN_NORMALIZED_DMFP = 2
TYN_NORMALIZED_FIT_COUNT = 3

TYN_INCIDENCE_COLLIMATED = 0
TYN_INCIDENCE_DIFFUSE = 1

TYN_BEAM_PENCIL = 0
TYN_BEAM_DISC = 1
TYN_BEAM_GAUSSIAN = 2
