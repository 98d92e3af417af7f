# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""What a slab run gives. All arrays are Estimates whose last axis is the spectral channel; what was not asked for is None.

Values are fractions of the light that arrived. What is resolved (by radius, angle, order or path) is diffuse light, scattered
at least once, unless said otherwise. Bins are equal steps: `edges` has one entry more than there are bins, `centers` one a bin.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, fields
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .estimate import Estimate

_SHOWN_CHANNELS = 4


@dataclass(frozen=True, eq=False)
class SlabRun:
    """What a run was."""

    photons: int
    """Walked to their ends, a channel."""
    events: int
    """Scattering events, all channels."""
    seconds: float
    """Wall-clock, compiling kernels excluded."""
    build_seconds: float
    """Spent on getting the kernel ready."""
    seed: int


@dataclass(frozen=True, eq=False)
class SlabReflectance:
    """Light that comes back; one value a channel."""

    total: Estimate
    specular: Estimate
    """Without having been scattered, from whichever interface."""
    diffuse: Estimate
    """Scattered."""


@dataclass(frozen=True, eq=False)
class SlabTransmittance:
    """Light that goes through; one value a channel."""

    total: Estimate
    direct: Estimate
    """Without having been scattered."""
    diffuse: Estimate
    """Scattered."""


@dataclass(frozen=True, eq=False)
class SlabRadial:
    """R(r) and T(r): means over rings around the origin."""

    edges: NDArray[np.float64]
    """Radius, length."""
    centers: NDArray[np.float64]
    reflectance: Estimate
    """1/length^2; bins x channels."""
    transmittance: Estimate


@dataclass(frozen=True, eq=False)
class SlabAngular:
    """Light by its angle from the normal, in the medium above or below."""

    edges: NDArray[np.float64]
    """Angle, radians, 0 to pi/2."""
    centers: NDArray[np.float64]
    reflectance: Estimate
    """Per solid angle, 1/sr: BRDF times cosine; bins x channels."""
    transmittance: Estimate
    """The same with the BTDF."""


@dataclass(frozen=True, eq=False)
class SlabRadialAngular:
    """R(r, angle) and T(r, angle), over the bins of `SlabResult.radial` and `SlabResult.angular`."""

    reflectance: Estimate
    """1/(length^2 sr); radii x angles x channels."""
    transmittance: Estimate


@dataclass(frozen=True, eq=False)
class SlabDepth:
    """What light does by depth, unscattered light included; with max_order, light of the orders allowed."""

    edges: NDArray[np.float64]
    """Depth, length."""
    centers: NDArray[np.float64]
    absorbed: Estimate
    """Fraction absorbed per depth, 1/length; bins x channels. Another estimate than SlabResult.layer_absorbed, which keeps the
    energy in balance: their sums agree within their errors."""
    fluence: Estimate
    """Fluence integrated over the plane, which is the path length per depth, no unit; bins x channels."""


@dataclass(frozen=True, eq=False)
class SlabOrders:
    """Light that leaves after 0, 1, ... scattering events."""

    orders: NDArray[np.int64]
    reflectance: Estimate
    """Fraction; orders x channels."""
    transmittance: Estimate


@dataclass(frozen=True, eq=False)
class SlabPath:
    """Light by the length of its path inside the slab."""

    edges: NDArray[np.float64]
    """Length."""
    centers: NDArray[np.float64]
    reflectance: Estimate
    """Fraction per path length, 1/length; bins x channels."""
    transmittance: Estimate


@dataclass(frozen=True, eq=False)
class SlabSweep:
    """What slabs of other media give, of the same photons: all light, not diffuse light alone."""

    sigma_a: NDArray[np.float64]
    """Absorption of each layer, 1/length; rows x layers."""
    sigma_s: NDArray[np.float64]
    reflectance: Estimate
    """Rows x channels."""
    transmittance: Estimate
    absorbed: Estimate


@dataclass(frozen=True, eq=False, repr=False)
class SlabResult:
    """The results of a slab run. Its reflectance, transmittance, absorbed and cut light add up to 1 within rounding."""

    reflectance: SlabReflectance
    transmittance: SlabTransmittance
    absorbed: Estimate
    """In all layers; one value a channel."""
    layer_absorbed: Estimate
    """In each layer; layers x channels."""
    cut: Estimate
    """Left in walks that max_order ended, or that are trapped between interfaces; one value a channel."""
    run: SlabRun
    radial: SlabRadial | None = None
    angular: SlabAngular | None = None
    radial_angular: SlabRadialAngular | None = None
    depth: SlabDepth | None = None
    orders: SlabOrders | None = None
    path: SlabPath | None = None
    sweep: SlabSweep | None = None

    def __repr__(self) -> str:
        run = self.run
        head = f"<tyndall.SlabResult: {run.photons:,} photons a channel, {run.seconds:.3g} s, seed {run.seed}"
        return "\n".join([head, *_totals_shown(self), *_parts_shown(self)]) + ">"


def _totals_shown(result: SlabResult) -> Iterator[str]:
    back, through = result.reflectance, result.transmittance
    for name, values in (
        ("reflectance", back.total), ("  specular", back.specular), ("  diffuse", back.diffuse),
        ("transmittance", through.total), ("  direct", through.direct), ("  diffuse", through.diffuse),
        ("absorbed", result.absorbed), ("cut", result.cut),
    ):  # fmt: skip
        shown = "".join(f"{_shown(one):24}" for one in values[:_SHOWN_CHANNELS])
        more = f"... of {len(values)} channels" if len(values) > _SHOWN_CHANNELS else ""
        yield f"  {name:15}{shown}{more}".rstrip()


def _shown(one: Estimate) -> str:
    """The value to the second digit of its standard error."""
    value, error = float(one), float(one.stderr)
    if not error > 0:
        return f"{value:.6g} ± {error:g}"
    digits = min(max(1 - math.floor(math.log10(error)), 2), 12)
    return f"{value:.{digits}f} ± {error:.{digits}f}"


def _parts_shown(result: SlabResult) -> Iterator[str]:
    """What was resolved, with how many values."""
    parts: list[str] = []
    for field in fields(result):
        part: Any = getattr(result, field.name)
        if field.default is None and part is not None:
            size = " x ".join(map(str, part.reflectance.shape[:-1] if field.name != "depth" else part.fluence.shape[:-1]))
            parts.append(f"{field.name} ({size})")
    if parts:
        yield f"  and {', '.join(parts)}"
