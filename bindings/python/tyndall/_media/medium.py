# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Homogeneous participating media."""

from __future__ import annotations

import ctypes
from dataclasses import dataclass, fields
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .. import capi
from .._core.arrays import array, shown
from .._core.numbers import decimal, number, require
from .._core.status import error_of
from .._core.text import optional_name
from ..errors import InvalidArgumentError
from .colors import albedo_from_color
from .phase import Phase

MILLIMETRE = 1e-3
"""metres_per_unit of media whose coefficients are in 1/mm."""


@dataclass(frozen=True, eq=False)
class MediumDescription:
    """Characteristic lengths of a medium, one a channel; inf where there is none. In single precision. Fractions are relative
    to a length of reference."""

    albedo: NDArray[np.float64]
    """sigma_s / sigma_t; 0 for an empty medium."""
    diffuse_albedo: NDArray[np.float64]
    """The colour of an index-matched half-space, `color_from_albedo`."""
    mean_free_path_mm: NDArray[np.float64]
    """1 / sigma_t."""
    transport_mean_free_path_mm: NDArray[np.float64]
    """1 / (sigma_a + sigma_s (1 - g))."""
    diffusion_length_mm: NDArray[np.float64]
    """1 / sqrt(3 sigma_a (sigma_a + sigma_s (1 - g)))."""
    mean_free_path_fraction: NDArray[np.float64]
    transport_mean_free_path_fraction: NDArray[np.float64]
    diffusion_length_fraction: NDArray[np.float64]


class Medium:
    """What light travels through: absorption, scattering, a phase function and an index of refraction. It never changes.

    Coefficients are per unit of length. Which unit that is, is the caller's choice, unless `metres_per_unit` says it: then a
    scene, whose unit is known too, gets them converted. Slabs and BSSRDF models take 1 to 1024 spectral channels; scenes take
    1 or 3 (linear RGB, Rec.709).
    """

    def __init__(
        self,
        sigma_a: ArrayLike,
        sigma_s: ArrayLike,
        *,
        g: float = 0.0,
        ior: float = 1.0,
        phase: Phase | None = None,
        name: str | None = None,
        metres_per_unit: float | None = None,
    ) -> None:
        """A medium by its coefficients.

        sigma_a: absorption, 1/length, >= 0, a number or one a channel.
        sigma_s: scattering, 1/length, >= 0, a number or one a channel.
        g: mean cosine of the Henyey-Greenstein phase function, in (-1, 1); ignored if there is a `phase`.
        ior: index of refraction, relative to what is outside for a mesh, [1, 4]; 1: index-matched, light crosses unbent.
        phase: another phase function; None: Henyey-Greenstein with g.
        name: for messages and files; may be None.
        metres_per_unit: what the length of the coefficients is, > 0 (1e-3: they are in 1/mm); None: not known.

        Errors: InvalidArgumentError.
        """
        absorbed = np.atleast_1d(array(sigma_a, "sigma_a", np.float64))
        scattered = np.atleast_1d(array(sigma_s, "sigma_s", np.float64))
        try:
            absorbed, scattered = np.broadcast_arrays(absorbed, scattered)
        except ValueError:
            raise InvalidArgumentError(
                f"sigma_a and sigma_s must have one value, or the same number of them; they have {absorbed.size} and"
                f" {scattered.size}"
            ) from None
        self.sigma_a: NDArray[np.float64] = _coefficients(absorbed, "sigma_a")
        self.sigma_s: NDArray[np.float64] = _coefficients(scattered, "sigma_s")
        if phase is not None and not isinstance(phase, Phase):
            raise InvalidArgumentError(f"phase is {shown(phase)}; it must be a tyndall.Phase, or None")
        cosine, index = number(g, "g"), number(ior, "ior")
        require(-1 < cosine < 1, "g", cosine, "in (-1, 1)")
        require(1 <= index <= 4, "ior", index, "in [1, 4]")
        self.phase = phase
        self.g = cosine if phase is None else phase.mean_cosine
        """Mean cosine of the phase function."""
        self.ior = index
        self.name = optional_name(name)
        self.metres_per_unit = None if metres_per_unit is None else _positive(metres_per_unit, "metres_per_unit")
        self._made = True

    def __setattr__(self, name: str, value: object) -> None:
        # Scenes know a medium that was added before by the object.
        if "_made" in self.__dict__:
            raise AttributeError(f"a Medium never changes: make another one to have a different {name}")
        object.__setattr__(self, name, value)

    @classmethod
    def preset(cls, name: str, metres_per_unit: float = MILLIMETRE) -> Medium:
        """A measured medium (Jensen, Marschner, Levoy, Hanrahan 2001), RGB; `presets()` lists the names. The table holds
        reduced coefficients, which are given back with g = 0. metres_per_unit: unit of the result, > 0; by default 1/mm."""
        record = capi.TynMedium()
        if name not in cls.presets():
            raise InvalidArgumentError(f'there is no preset "{name}"; there are: {", ".join(cls.presets())}')
        unit = _positive(metres_per_unit, "metres_per_unit")
        if capi.lib.tyn_medium_preset(name.encode(), unit, ctypes.byref(record)) != capi.TYN_OK:
            raise InvalidArgumentError(f"metres_per_unit is {unit:g}, with which the coefficients are not finite")
        return cls(
            [decimal(one) for one in record.sigma_a],
            [decimal(one) for one in record.sigma_s],
            g=record.g,
            ior=decimal(record.ior),
            name=name,
            metres_per_unit=metres_per_unit,
        )

    @staticmethod
    def presets() -> list[str]:
        """The names of the measured media."""
        return [capi.lib.tyn_medium_preset_name(index).decode() for index in range(capi.lib.tyn_medium_preset_count())]

    @classmethod
    def from_albedo(
        cls,
        albedo: ArrayLike,
        mean_free_path: ArrayLike = 1.0,
        *,
        g: float = 0.0,
        ior: float = 1.0,
        phase: Phase | None = None,
        name: str | None = None,
        metres_per_unit: float | None = None,
    ) -> Medium:
        """A medium by its single-scattering albedo sigma_s / sigma_t, in [0, 1], and its mean free path 1 / sigma_t, length,
        > 0; each a number or one a channel. The rest as for Medium()."""
        w = np.atleast_1d(array(albedo, "albedo", np.float64))
        length = np.atleast_1d(array(mean_free_path, "mean_free_path", np.float64))
        if not np.all((w >= 0) & (w <= 1)):
            raise InvalidArgumentError(f"albedo is {w}; it must be in [0, 1]")
        if not np.all((length > 0) & (length < np.inf)):
            raise InvalidArgumentError(f"mean_free_path is {length}; it must be > 0 and finite")
        return cls(
            (1 - w) / length, w / length, g=g, ior=ior, phase=phase, name=name, metres_per_unit=metres_per_unit
        )  # fmt: skip

    @classmethod
    def from_color(
        cls,
        color: ArrayLike,
        mean_free_path: ArrayLike = 1.0,
        *,
        g: float = 0.0,
        ior: float = 1.0,
        phase: Phase | None = None,
        name: str | None = None,
        metres_per_unit: float | None = None,
    ) -> Medium:
        """A medium by its multiple-scattering colour, which is the diffuse albedo of an index-matched half-space of it, in
        [0, 1], and its mean free path 1 / sigma_t, length, > 0; each a number or one a channel. The albedo is
        `albedo_from_color` of the colour: with a boundary (ior above 1) or g far from 0 what comes out is darker. The rest as
        for Medium()."""
        given = array(color, "color", np.float64)
        require((given >= 0) & (given <= 1), "color", given, "in [0, 1]")
        albedo = albedo_from_color(given, g if phase is None else phase.mean_cosine)
        return cls.from_albedo(
            albedo, mean_free_path, g=g, ior=ior, phase=phase, name=name, metres_per_unit=metres_per_unit
        )  # fmt: skip

    @property
    def channels(self) -> int:
        """The number of spectral channels."""
        return len(self.sigma_a)

    @property
    def sigma_t(self) -> NDArray[np.float64]:
        """Extinction, sigma_a + sigma_s, 1/length."""
        return self.sigma_a + self.sigma_s

    @property
    def albedo(self) -> NDArray[np.float64]:
        """Single-scattering albedo, sigma_s / sigma_t; 0 for an empty medium."""
        total = self.sigma_t
        return np.divide(self.sigma_s, total, out=np.zeros_like(total), where=total > 0)

    @property
    def mean_free_path(self) -> NDArray[np.float64]:
        """1 / sigma_t, length; inf in an empty medium."""
        with np.errstate(divide="ignore"):
            return 1 / self.sigma_t

    def converted(self, metres_per_unit: float) -> Medium:
        """The same medium in another unit of length. InvalidArgumentError if this one's unit is not known."""
        if self.metres_per_unit is None:
            raise InvalidArgumentError("the medium does not say its unit; make it with metres_per_unit")
        factor = _positive(metres_per_unit, "metres_per_unit") / self.metres_per_unit
        return Medium(
            self.sigma_a * factor, self.sigma_s * factor, g=self.g, ior=self.ior, phase=self.phase, name=self.name,
            metres_per_unit=metres_per_unit,
        )  # fmt: skip

    def describe(self, reference_length: float = 1.0, metres_per_unit: float | None = None) -> MediumDescription:
        """The medium's characteristic lengths, in mm and as fractions of `reference_length` (such as a mesh's diagonal, in the
        unit of the coefficients, > 0). metres_per_unit: that unit, > 0, for a medium that does not say it itself.

        Errors: InvalidArgumentError, also if the unit is not known or is said twice, differently."""
        unit = self._unit(metres_per_unit)
        length = _positive(reference_length, "reference_length")
        columns = [self._described(channel, unit, length) for channel in range(self.channels)]
        names = [field.name for field in fields(MediumDescription)]
        return MediumDescription(*(np.array([getattr(one, name)[0] for one in columns], np.float64) for name in names))

    def _unit(self, metres_per_unit: float | None) -> float:
        """The unit of the coefficients: its own, else the caller's."""
        if metres_per_unit is None:
            if self.metres_per_unit is None:
                raise InvalidArgumentError("the medium does not say its unit; give metres_per_unit")
            return self.metres_per_unit
        given = _positive(metres_per_unit, "metres_per_unit")
        if self.metres_per_unit not in (None, given):
            raise InvalidArgumentError(f"metres_per_unit is {given:g}, but the medium's own is {self.metres_per_unit:g}")
        return given

    def _described(self, channel: int, metres_per_unit: float, reference_length: float) -> Any:
        """The TynMediumDescription of one channel, three times."""
        one = Medium(self.sigma_a[channel], self.sigma_s[channel], g=self.g, ior=self.ior, phase=self.phase)
        result = capi.TynMediumDescription()
        status = capi.lib.tyn_medium_describe(
            ctypes.byref(one.record()), metres_per_unit, reference_length, ctypes.byref(result)
        )
        if status != capi.TYN_OK:
            raise error_of(status, f"the coefficients of channel {channel} are out of the range of single precision")
        return result

    def record(self, metres_per_unit: float | None = None) -> Any:
        """The TynMedium for calls of `tyndall.capi`, valid as long as this object, with coefficients in 1/unit of
        `metres_per_unit` if both units are known. InvalidArgumentError unless there are 1 or 3 channels."""
        if self.channels not in (1, 3):
            raise InvalidArgumentError(f"a scene's media have 1 or 3 channels; this one has {self.channels}")
        factor = 1.0
        if metres_per_unit is not None and self.metres_per_unit is not None:
            factor = metres_per_unit / self.metres_per_unit
        one = capi.TynMedium(
            sigma_a=np.broadcast_to(self.sigma_a * factor, 3), sigma_s=np.broadcast_to(self.sigma_s * factor, 3),
            g=self.g, ior=self.ior, name=self.name,
        )  # fmt: skip
        if self.phase is not None:
            one.g = 0.0
            one.phase = ctypes.pointer(self.phase.record)
        return one

    def __repr__(self) -> str:
        name = "" if self.name is None else f' "{self.name}"'
        unit = "" if self.metres_per_unit is None else f", metres_per_unit={self.metres_per_unit:g}"
        return f"<tyndall.Medium{name} sigma_a={self.sigma_a} sigma_s={self.sigma_s} g={self.g:.4g} ior={self.ior:g}{unit}>"


def _positive(value: float, name: str) -> float:
    given = number(value, name)
    require(0 < given < np.inf, name, given, "> 0 and finite")
    return given


def _coefficients(values: NDArray[np.float64], name: str) -> NDArray[np.float64]:
    if values.ndim != 1 or values.size == 0:
        raise InvalidArgumentError(f"{name} has the shape {values.shape}; it must be a number or one a channel")
    if not np.all((values >= 0) & (values < np.inf)):
        raise InvalidArgumentError(f"{name} is {values}; it must be >= 0 and finite")
    own = np.array(values)
    own.flags.writeable = False
    return own
