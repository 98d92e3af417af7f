# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""What scenes hold."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from .. import capi

_Self = TypeVar("_Self", bound="_Info")


class _Info:
    @classmethod
    def of(cls: type[_Self], record: Any) -> _Self:
        """What a C record says."""
        return cls(**{field.name: _value(field.name, getattr(record, field.name)) for field in fields(cls)})  # type: ignore[arg-type]


def _value(name: str, value: Any) -> Any:
    if name in ("lower", "upper"):
        return np.array(value, np.float32)
    if name in ("closed", "has_environment"):
        return bool(value)
    if name in ("medium", "material"):
        return None if value == capi.TYN_NONE else value
    return value.decode(errors="replace") if isinstance(value, bytes) else value


@dataclass(frozen=True, eq=False)
class SceneInfo(_Info):
    """What a scene holds."""

    mesh_count: int
    medium_count: int
    material_count: int
    image_count: int
    light_count: int
    camera_count: int
    emissive_triangle_count: int
    has_environment: bool
    """Whether the environment is not black."""
    triangle_count: int
    metres_per_unit: float
    lower: NDArray[np.float32]
    """Bounds of all meshes, x, y, z; lower > upper if there is none."""
    upper: NDArray[np.float32]


@dataclass(frozen=True, eq=False)
class MeshInfo(_Info):
    """What a mesh is. The checks are done when it is added: vertices of exactly equal position count as one.

    Only the triangles of a mesh with a medium are turned: first those that disagree with most of their component, then, in
    whole, each closed component whose signed volume is negative and that does not lie inside another one. One that faces
    inwards inside another is a cavity and stays.
    """

    name: str
    """Empty if it has none."""
    vertex_count: int
    triangle_count: int
    welded_vertex_count: int
    closed: bool
    """No boundary and no non-manifold edge."""
    boundary_edges: int
    """Edges with one triangle."""
    nonmanifold_edges: int
    """Edges with more than two triangles."""
    degenerate_triangles: int
    """Of zero area or with a repeated vertex."""
    duplicate_triangles: int
    components: int
    """Connected over shared edges."""
    inverted_components: int
    """Closed components whose triangles faced the wrong way and were turned; 0 without a medium."""
    turned_triangles: int
    """Triangles whose winding disagreed with their neighbours' and was turned; 0 without a medium."""
    medium: int | None
    material: int | None
    area: float
    """Scene units squared."""
    volume: float
    """Scene units cubed; meaningful if closed and, without a medium, wound consistently."""
    lower: NDArray[np.float32]
    """Bounds, x, y, z."""
    upper: NDArray[np.float32]
    overlapping_components: int
    """Closed components that were seen to reach into others or to touch them, in a few places of each, so 0 is no proof; 0 if
    the mesh is not closed or has no medium."""
