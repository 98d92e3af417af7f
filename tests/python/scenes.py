# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Scenes for tests, made with raw calls."""

from __future__ import annotations

import ctypes
from typing import Any

import numpy as np

import tyndall as ty
from tyndall import capi


def add_mesh(scene: ty.Scene, positions: Any, indices: Any, **fields: Any) -> None:
    p, i = np.ascontiguousarray(positions, np.float32), np.ascontiguousarray(indices, np.uint32)
    mesh = capi.TynMesh(
        positions=p.ctypes.data_as(ctypes.POINTER(ctypes.c_float)), vertex_count=len(p),
        indices=i.ctypes.data_as(ctypes.POINTER(ctypes.c_uint32)), triangle_count=len(i), **fields,
    )  # fmt: skip
    assert capi.lib.tyn_scene_add_mesh(scene.handle, ctypes.byref(mesh), None) == capi.TYN_OK


def add(scene: ty.Scene, function: Any, record: Any) -> int:
    index = ctypes.c_uint32()
    assert function(scene.handle, ctypes.byref(record), ctypes.byref(index)) == capi.TYN_OK
    return index.value


def light_everywhere(scene: ty.Scene, radiance: float = 1.0) -> None:
    environment = capi.TynEnvironment(radiance=[radiance] * 3)
    assert capi.lib.tyn_scene_set_environment(scene.handle, ctypes.byref(environment)) == capi.TYN_OK


def floor(context: ty.Context, half: float, **fields: Any) -> ty.Scene:
    """A committed scene of a square in the plane z = 0 that faces +z."""
    scene = context.scene()
    corners = [(-half, -half, 0), (half, -half, 0), (half, half, 0), (-half, half, 0)]
    add_mesh(scene, corners, [(0, 1, 2), (0, 2, 3)], **fields)
    scene.commit()
    return scene


def cube(half: float = 1.0) -> tuple[Any, Any]:
    """Corners and triangles of a cube about the origin, facing outwards."""
    corners = np.array([(x, y, z) for x in (-half, half) for y in (-half, half) for z in (-half, half)])
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return corners, np.array([t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))])
