# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""The records that BSSRDF models take and give, as structured arrays."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .. import capi
from .._core.arrays import array, records, unmasked
from .._core.broadcast import words
from ..errors import InvalidArgumentError

BSSRDF_PATH: np.dtype[Any] = np.dtype(capi.TynBssrdfPath)
"""Light that arrives at a point of a surface and leaves at another: entry_position, entry_normal, entry_direction,
exit_position, exit_normal, exit_direction, three float32 each. Both directions are those in which light travels."""

BSSRDF_ENTRY: np.dtype[Any] = np.dtype(capi.TynBssrdfEntry)
"""Where light gets into a mesh, for Bssrdf.sample_exits."""

BSSRDF_EXIT: np.dtype[Any] = np.dtype(capi.TynBssrdfExit)
"""Where light that got in leaves, of Bssrdf.sample_exits: TynBssrdfExit of tyndall_types.h."""


def structured(
    dtype: np.dtype[Any], name: str, given: Any, vectors: dict[str, ArrayLike | None], numbers: dict[str, ArrayLike]
) -> NDArray[Any]:
    """Records: `given`, or made of their members, which are broadcast against each other. A member called "path" is a number
    of 64 bits in two words."""
    missing = [member for member, value in vectors.items() if value is None]
    if given is not None:
        if len(missing) < len(vectors):
            raise InvalidArgumentError(f"give either {name} or {', '.join(vectors)}, not both")
        found = unmasked(given, name)
        return records(found.reshape(-1), name, dtype).reshape(found.shape)
    if missing:
        raise InvalidArgumentError(f"without {name}, {' and '.join(missing)} must be given")
    parts: dict[str, NDArray[Any]] = {member: _vectors(value, member) for member, value in vectors.items()}
    for member, value in numbers.items():
        parts[member] = words(value, member) if member == "path" else array(value, member, np.uint32)[..., None]
    try:
        shape = np.broadcast_shapes(*(part.shape[:-1] for part in parts.values()))
    except ValueError:
        shapes = ", ".join(f"{member} {part.shape[:-1]}" for member, part in parts.items())
        raise InvalidArgumentError(f"these do not fit each other: {shapes}") from None
    result = np.zeros(shape, dtype)
    for member, part in parts.items():
        result[member] = part[..., 0] if result[member].ndim < part.ndim else part
    return result


def _vectors(value: Any, name: str) -> NDArray[np.float32]:
    result = array(value, name)
    if result.ndim == 0 or result.shape[-1] != 3:
        raise InvalidArgumentError(f"{name} has the shape {result.shape}; its last axis must have 3 elements, x y z")
    return result
