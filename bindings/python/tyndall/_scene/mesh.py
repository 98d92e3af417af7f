# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""The TynMesh of arrays."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .. import capi
from .._core.arrays import array, data, unmasked
from .._core.broadcast import indices
from ..errors import InvalidArgumentError


def vertices(value: ArrayLike, name: str, width: int) -> NDArray[np.float32]:
    """n x width float32, each row without gaps; a view whose rows are apart is not copied."""
    given = unmasked(value, name)
    in_rows = given.dtype == np.float32 and given.ndim == 2 and given.shape[1] == width
    if in_rows and given.strides[1] == 4 and given.strides[0] >= 4 * width:
        return given
    return array(given, name, np.float32, (None, width))


def mesh_record(
    positions: ArrayLike,
    triangles: ArrayLike,
    normals: ArrayLike | None,
    uvs: ArrayLike | None,
    triangle_materials: ArrayLike | None,
    **fields: Any,
) -> Any:
    """A TynMesh. It keeps alive what it points to."""
    points = vertices(positions, "positions", 3)
    corners = np.ascontiguousarray(indices(triangles, "triangles"))
    if corners.ndim != 2 or corners.shape[1] != 3:
        raise InvalidArgumentError(f"triangles has the shape {corners.shape}; it must be n x 3")
    mesh = capi.TynMesh(
        positions=data(points), position_stride=_stride(points, 3), vertex_count=len(points), indices=data(corners),
        triangle_count=len(corners), **fields,
    )  # fmt: skip
    mesh.keep = [points, corners]
    for name, value, width in (("normal", normals, 3), ("uv", uvs, 2)):
        if value is not None:
            rows = _one_a_vertex(vertices(value, f"{name}s", width), f"{name}s", len(points))
            mesh.keep.append(rows)
            setattr(mesh, f"{name}s", data(rows))
            setattr(mesh, f"{name}_stride", _stride(rows, width))
    if triangle_materials is not None:
        materials = np.ascontiguousarray(indices(triangle_materials, "triangle_materials"))
        if materials.shape != (len(corners),):
            raise InvalidArgumentError(
                f"triangle_materials has the shape {materials.shape}; there are {len(corners)} triangles, each with one"
            )
        mesh.keep.append(materials)
        mesh.triangle_materials = data(materials)
    return mesh


def _stride(rows: NDArray[np.float32], width: int) -> int:
    return rows.strides[0] if len(rows) > 1 else 4 * width


def _one_a_vertex(rows: NDArray[np.float32], name: str, count: int) -> NDArray[np.float32]:
    if len(rows) != count:
        raise InvalidArgumentError(f"{name} has {len(rows)} rows; there are {count} vertices, each with one")
    return rows
