# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Measures of meshes, apart from the package."""

from typing import Any

import numpy as np


def volume(positions: Any, triangles: Any) -> float:
    """By the divergence theorem; > 0 if wound counter-clockwise seen from outside."""
    a, b, c = np.asarray(positions, np.float64)[np.asarray(triangles)].transpose(1, 0, 2)
    return float(np.einsum("ij,ij->", a, np.cross(b, c)) / 6)


def area(positions: Any, triangles: Any) -> float:
    a, b, c = np.asarray(positions, np.float64)[np.asarray(triangles)].transpose(1, 0, 2)
    return float(np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2)


def edges_twice(triangles: Any) -> bool:
    """Whether every edge is there once in each direction: closed, and wound consistently."""
    directed = np.concatenate([np.asarray(triangles)[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]]).tolist()
    there = {tuple(edge) for edge in directed}
    return len(there) == len(directed) and all((b, a) in there for a, b in there)
