# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""The batch call: walks light through the inside of meshes."""

from __future__ import annotations

import ctypes
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .. import capi
from .._core.arrays import record_data, records, unmasked
from .._core.context import ContextHandle
from .._core.dtypes import WALK_ENTRY
from .._core.numbers import UINT32, UINT64, integer, number
from .._core.progress import LongCall, Progress
from .._scene.scene import Scene, scene_of
from ..errors import CancelledError, InvalidArgumentError
from .entries import walk_entries
from .exits import Exits, room_for
from .ledger import Ledger


def walk_options(seed: int, first_path: int, max_scatterings: int, roulette_threshold: float, roulette: bool) -> Any:
    """The TynWalkOptions of a call's arguments."""
    return capi.TynWalkOptions(
        seed=integer(seed, "seed", 0, UINT64),
        first_path=integer(first_path, "first_path", 0, UINT64),
        max_scatterings=integer(max_scatterings, "max_scatterings", 0, UINT32),
        roulette_threshold=number(roulette_threshold, "roulette_threshold"),
        roulette_off=0 if roulette else 1,
    )


class WalkCalls(ContextHandle):
    """The walks of a context."""

    def walk(
        self,
        scene: Scene,
        entries: ArrayLike,
        direction: ArrayLike | None = None,
        *,
        kind: ArrayLike | None = None,
        mesh: ArrayLike = 0,
        triangle: ArrayLike | None = None,
        weight: ArrayLike = 1.0,
        albedo: ArrayLike | None = None,
        sigma_t: ArrayLike | None = None,
        medium: ArrayLike | None = None,
        roughness: ArrayLike = 0.0,
        path: ArrayLike = 0,
        seed: int = 0,
        first_path: int = 0,
        max_scatterings: int = 0,
        roulette_threshold: float = 0.1,
        roulette: bool = True,
        progress: Progress = None,
    ) -> Exits:
        """Walks through the media of a committed scene, one for each entry. Returns where they ended, with their ledger.

        One flight serves all three channels: a channel is chosen in proportion to its throughput and the others are weighted by
        the balance heuristic, so a weight never exceeds three times what entered. The same device, entries and seed give the
        same bits, however a batch was split.

        Precision is single: the mean free path should be at least 1e-5 of the mesh's largest coordinate. In a white medium a
        walk has 4 V sigma_s / S scatterings on average (V, S: the mesh's volume and surface), however many that is.

        scene: committed, of this context.
        entries: an array of the type WALK_ENTRY, of any shape; or positions, and then direction, kind, mesh, triangle, weight,
            albedo, sigma_t, medium, roughness and path as for `walk_entries`.
        seed: in [0, 2^64).
        first_path: path number of the first entry; counting it on over parts of a batch gives what the whole batch would.
        max_scatterings: a walk ends there, and the ledger says what was cut; 0: no cap.
        roulette_threshold: walks whose largest channel falls below it play Russian roulette, (0, 1].
        roulette: False: never; such a walk only ends by leaving, or at weight 0.
        progress: see `Progress`. A batch that has begun (2^17 walks) cannot be cancelled.

        Errors: InvalidArgumentError (which entry, which field, its value), InvalidOperationError, OutOfMemoryError,
        DeviceError, KernelBuildError, CancelledError (its result: the walks that were done, with their ledger).
        """
        fields = {
            "direction": direction, "kind": kind, "mesh": mesh, "triangle": triangle, "weight": weight, "albedo": albedo,
            "sigma_t": sigma_t, "medium": medium, "roughness": roughness, "path": path,
        }  # fmt: skip
        given = _entries(entries, fields)
        flat = records(given.reshape(-1), "entries", WALK_ENTRY)
        options = walk_options(seed, first_path, max_scatterings, roulette_threshold, roulette)
        exits = room_for(len(flat))
        ledger = capi.TynLedger()
        with LongCall(progress, "walk") as call:
            options.progress = call.callback
            try:
                scene_of(self, scene)._call(
                    capi.lib.tyn_walk,
                    scene.handle,
                    ctypes.byref(options),
                    record_data(flat, capi.TynWalkEntry),
                    len(flat),
                    record_data(exits, capi.TynWalkExit),
                    ctypes.byref(ledger),
                )
            except CancelledError as error:
                error.result = _with_ledger(exits[: ledger.walks].copy(), ledger)
                raise
        return _with_ledger(exits.reshape(given.shape).view(Exits), ledger)


def _with_ledger(exits: Exits, ledger: Any) -> Exits:
    exits.ledger = Ledger.of(ledger)
    return exits


def _entries(entries: ArrayLike, fields: dict[str, Any]) -> NDArray[Any]:
    given = unmasked(entries, "entries")
    if given.dtype.names is None:
        return walk_entries(entries, **fields)
    usual = walk_entries.__kwdefaults__ or {}
    for name, value in fields.items():
        if value is not None and (np.ndim(value) > 0 or value != usual[name]):
            raise InvalidArgumentError(f"entries are records, which have a {name} of their own: do not give it, too")
    return np.atleast_1d(given)
