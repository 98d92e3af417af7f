# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Simple closed meshes for `Scene.add_mesh`, wound counter-clockwise seen from outside."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._core.arrays import array
from ._core.numbers import integer, number, require
from .errors import InvalidArgumentError

Shape = tuple[NDArray[np.float32], NDArray[np.uint32]]
"""Positions (n x 3) and triangles (m x 3)."""


def box(size: ArrayLike = 1.0) -> Shape:
    """A box around the origin, of 8 vertices and 12 triangles. size: its edges along x, y, z, or one number for all; > 0."""
    edges = array(size, "size", np.float64)
    if edges.shape not in ((), (1,), (3,)) or not np.all((edges > 0) & (edges < np.inf)):
        raise InvalidArgumentError(f"size is {edges}; it must be one number or three, > 0 and finite")
    corners = np.array([[x, y, z] for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)])
    sides = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    triangles = [half for a, b, c, d in sides for half in ((a, b, c), (a, c, d))]
    return (corners * edges).astype(np.float32), np.array(triangles, np.uint32)


def sphere(radius: float = 1.0, subdivisions: int = 3) -> Shape:
    """An icosahedron whose triangles are split `subdivisions` times into four, with its 10 4^subdivisions + 2 vertices on the
    sphere of `radius` > 0 around the origin. subdivisions: 0 to 10."""
    size = number(radius, "radius")
    require(0 < size < np.inf, "radius", size, "> 0 and finite")
    splits = integer(subdivisions, "subdivisions", 0, 10)
    points, triangles = _icosahedron()
    for _ in range(splits):
        points, triangles = _split(points, triangles)
    return (size * points).astype(np.float32), triangles.astype(np.uint32)


def _icosahedron() -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    golden = (1 + 5**0.5) / 2
    rectangle = np.array([[0, y, z] for y in (-1, 1) for z in (-golden, golden)])
    points = np.concatenate([np.roll(rectangle, axis, axis=1) for axis in range(3)])
    points /= np.linalg.norm(points[0])
    near = np.linalg.norm(points[:, None] - points, axis=2) < 1.1
    triangles = []
    for a in range(12):
        for b in range(a + 1, 12):
            for c in range(b + 1, 12):
                if near[a, b] and near[b, c] and near[a, c]:
                    outwards = np.linalg.det(points[[a, b, c]]) > 0
                    triangles.append((a, b, c) if outwards else (a, c, b))
    return points, np.array(triangles)


def _split(points: NDArray[np.float64], triangles: NDArray[np.int64]) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    """Each triangle into four, with the new points, one an edge, moved out to the unit sphere."""
    edges = np.sort(triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    unique, number = np.unique(edges, axis=0, return_inverse=True)
    middle = points[unique].sum(axis=1)
    middle /= np.linalg.norm(middle, axis=1, keepdims=True)
    a, b, c = triangles.T
    ab, bc, ca = number.reshape(-1, 3).T + len(points)
    corners = [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
    return np.concatenate([points, middle]), np.concatenate([np.column_stack(one) for one in corners])
