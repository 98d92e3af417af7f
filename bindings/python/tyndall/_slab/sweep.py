# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Other media that the photons of a slab answer for."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .._core.arrays import array
from .._media.medium import Medium
from ..errors import InvalidArgumentError
from .layers import Layer, Layers

Sweep = Union[Sequence[Layers], "tuple[ArrayLike, ArrayLike]"]
"""Stacks that differ from the slab in sigma_a and sigma_s alone, or a pair of arrays of these, rows x layers (for a slab of one
layer one-dimensional, too)."""

_Coefficients = tuple[NDArray[np.float64], NDArray[np.float64]]


def sweep_coefficients(sweep: Sweep, layers: list[Layer]) -> _Coefficients:
    """sigma_a and sigma_s, rows x layers, of a sweep of the slab `layers`."""
    rows = list(sweep) if isinstance(sweep, Iterable) else []
    if rows and all(_is_stack(row) for row in rows):
        return _of_stacks(rows, layers)
    if len(rows) != 2:
        raise InvalidArgumentError("sweep must be stacks of layers, or a pair of arrays: sigma_a and sigma_s, rows x layers")
    absorbed, scattered = (_of_array(values, name, len(layers)) for values, name in zip(rows, ("sigma_a", "sigma_s")))
    if len(absorbed) != len(scattered):
        raise InvalidArgumentError(
            f"sigma_a and sigma_s of the sweep must have as many rows; they have {len(absorbed)} and {len(scattered)}"
        )
    return absorbed, scattered


def _is_stack(row: Any) -> bool:
    if isinstance(row, (Medium, Layer)):
        return True
    return isinstance(row, (list, tuple)) and len(row) > 0 and all(isinstance(one, (Medium, Layer)) for one in row)


def _of_array(values: Any, name: str, layers: int) -> NDArray[np.float64]:
    given = array(values, f"{name} of the sweep", np.float64)
    if given.ndim == 1 and layers == 1:
        given = given[:, np.newaxis]
    if given.ndim != 2 or given.shape[1] != layers or len(given) == 0:
        raise InvalidArgumentError(f"{name} of the sweep has the shape {given.shape}; it must be n x {layers}")
    return np.array(given, order="C")


def _of_stacks(rows: list[Any], layers: list[Layer]) -> _Coefficients:
    absorbed, scattered = np.empty((len(rows), len(layers))), np.empty((len(rows), len(layers)))
    for number, row in enumerate(rows):
        stack = [row] if isinstance(row, (Medium, Layer)) else row
        if len(stack) != len(layers):
            raise InvalidArgumentError(f"sweep row {number} has {len(stack)} layers; the slab has {len(layers)}")
        for index, (own, other) in enumerate(zip(layers, stack)):
            medium = other if isinstance(other, Medium) else other.medium
            thickness = own.thickness if isinstance(other, Medium) else other.thickness
            _check_same(f"sweep row {number}, layer {index}", own, medium, thickness)
            absorbed[number, index], scattered[number, index] = medium.sigma_a[0], medium.sigma_s[0]
    return absorbed, scattered


def _check_same(where: str, own: Layer, medium: Medium, thickness: float) -> None:
    """A sweep changes coefficients alone, those of all channels alike."""
    if medium.channels != 1:
        raise InvalidArgumentError(f"{where}: its medium has {medium.channels} channels; a sweep's have 1, which is for all")
    for name, mine, given in (
        ("thickness", own.thickness, thickness),
        ("ior", own.medium.ior, medium.ior),
        ("g", own.medium.g, medium.g),
        ("phase", own.medium.phase, medium.phase),
        ("metres_per_unit", own.medium.metres_per_unit, medium.metres_per_unit),
    ):
        if given != mine:
            raise InvalidArgumentError(f"{where}: {name} is {given}; it must be the slab's, {mine}")
