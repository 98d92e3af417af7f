# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Models of the BSSRDF behind one interface: profiles, albedos, sampling, and the BSSRDF of directions."""

from __future__ import annotations

import ctypes
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .. import capi
from .._core.arrays import array, data, record_data, room
from .._core.choices import choice
from .._core.context import ContextHandle
from .._core.handles import Handle
from .._core.numbers import UINT64, integer
from .._core.opencl import cl_buffer
from .._core.progress import LongCall, Progress
from .._scene.scene import Scene, scene_of
from .._slab.layers import Layers, slab_record, stack
from ..errors import InvalidArgumentError
from .records import BSSRDF_ENTRY, BSSRDF_EXIT, BSSRDF_PATH, structured

_FITS = {
    "searchlight": capi.TYN_NORMALIZED_SEARCHLIGHT,
    "diffuse": capi.TYN_NORMALIZED_DIFFUSE,
    "dmfp": capi.TYN_NORMALIZED_DMFP,
}
_EXACT_EVENTS = int(capi.TynBssrdfOptions().exact_events)


def bssrdf_models() -> list[str]:
    """The names of the models: "standard-dipole", "better-dipole", "photon-beam-diffusion", "multipole",
    "normalized-diffusion", "gaussians", "single-scattering", "quantized-diffusion", "directional-dipole", "exact"."""
    return [capi.lib.tyn_bssrdf_model_name(model).decode() for model in range(capi.TYN_BSSRDF_MODEL_COUNT)]


def model_choice(model: str, name: str = "model") -> int:
    """TYN_BSSRDF_* of a model's name."""
    return choice(model, name, {known: number for number, known in enumerate(bssrdf_models())})


class BssrdfSamples(NamedTuple):
    """What Bssrdf.sample draws."""

    radii: NDArray[np.float32]
    """Length, > 0; n."""
    pdf: NDArray[np.float32]
    """Density per area of the plane, 1/length^2, over all channels; n."""
    weights: NDArray[np.float32]
    """R / pdf, which add up to the albedos on average; n x channels."""


class BssrdfExits(NamedTuple):
    """What Bssrdf.sample_exits finds."""

    exits: NDArray[Any]
    """Of the dtype BSSRDF_EXIT, in the shape of the entries; `status` is capi.TYN_BSSRDF_EXIT_FOUND or _NONE."""
    weights: NDArray[np.float32]
    """R / pdf, 0 where nothing was found; entries x channels."""


class Bssrdf(Handle):
    """A BSSRDF model of a medium, made by `Context.bssrdf`. It never changes.

    Its profile R(r) is the radiant exitance at distance r from a point where light gets in perpendicularly, per unit of power
    that gets in, 1/length^2; the integral of 2 pi r R(r) is the albedo. Lengths are in the unit of the medium's coefficients.
    Models are approximations for a flat surface; only the totals of "exact" and "normalized-diffusion" are exact.
    """

    _kind = "BSSRDF model"

    def __init__(self, context: ContextHandle, model: str, layers: Layers, pointer: Any) -> None:
        """`Context.bssrdf` is how one is made."""
        super().__init__(pointer, capi.lib.tyn_bssrdf_release, context)
        self.context = context
        self.model = model
        """The name of the model."""
        self.layers = stack(layers)
        """What it is a model of, from the top."""
        self.channels = max(layer.medium.channels for layer in self.layers)
        """The number of spectral channels."""
        self.metres_per_unit = self.layers[0].medium.metres_per_unit
        """The unit of length, as the media say it; None: not known."""

    @property
    def albedo(self) -> NDArray[np.float64]:
        """The fraction of the light that gets in that comes back scattered, int 2 pi r R(r) dr; one a channel."""
        result = np.empty(self.channels)
        self._call(capi.lib.tyn_bssrdf_albedo, self.handle, data(result), self.channels)
        return result

    def profile(self, radii: ArrayLike) -> NDArray[np.float32]:
        """R(r), 1/length^2.

        radii: length, > 0 and finite; of any shape. Returns an array of that shape x channels, accurate to 1e-5: in single
        precision. (So derivatives by finite differences, as in fits, need steps of 1e-3 or so.) Of light that gets in: of
        what arrives, the surface reflects a part (specular reflectance), which is not in R.
        """
        return self._of_radii(capi.lib.tyn_bssrdf_profile, radii)

    def profile_error(self, radii: ArrayLike) -> NDArray[np.float32]:
        """Standard errors of `profile`, 1/length^2, in the same shape: of "exact", whose tables are estimates; 0 for all other
        models, which are wrong in other ways."""
        return self._of_radii(capi.lib.tyn_bssrdf_profile_error, radii)

    def pdf(self, radii: ArrayLike) -> NDArray[np.float32]:
        """The density per area, 1/length^2, with which `sample` draws radii: int 2 pi r pdf(r) dr = 1. radii: as for
        `profile`. Returns an array of their shape."""
        given = array(radii, "radii")
        result = np.empty(given.shape, np.float32)
        self._call(capi.lib.tyn_bssrdf_pdf, self.handle, data(given), given.size, data(result))
        return result

    def sample(self, count: int, *, seed: int = 0, first: int = 0) -> BssrdfSamples:
        """Draws radii with a density like R's, of a channel that is chosen in proportion to its albedo.

        count: how many, >= 0. seed, first: >= 0, < 2^64; radius i is a function of seed and first + i alone.
        Where no channel has an albedo, all results are 0.
        """
        n = integer(count, "count", 0, UINT64)
        radii, pdf, weights = room((n,), "count"), room((n,), "count"), room((self.channels, n), "count")
        self._call(
            capi.lib.tyn_bssrdf_sample, self.handle, integer(seed, "seed", 0, UINT64),
            integer(first, "first", 0, UINT64), n, data(radii), data(pdf), data(weights),
        )  # fmt: skip
        return BssrdfSamples(radii, pdf, _by_point(weights, (n,)))

    def evaluate(
        self,
        paths: Any = None,
        *,
        entry_position: ArrayLike | None = None,
        entry_normal: ArrayLike | None = None,
        entry_direction: ArrayLike | None = None,
        exit_position: ArrayLike | None = None,
        exit_normal: ArrayLike | None = None,
        exit_direction: ArrayLike | None = None,
    ) -> NDArray[np.float32]:
        """The BSSRDF S(x_i, w_i; x_o, w_o): the radiance that leaves at x_o along w_o per unit of power that arrives at x_i
        along w_i, 1/(length^2 sr), >= 0. See tyn_bssrdf_evaluate of tyndall_bssrdf.h.

        paths: structured array of the dtype BSSRDF_PATH, of any shape; or none, and instead all six of
        entry_position, exit_position: length, finite; ... x 3.
        entry_normal, exit_normal: unit, outside; ... x 3.
        entry_direction: unit, in which light arrives, against the normal; ... x 3.
        exit_direction: unit, in which light leaves, on the normal's side; ... x 3.
        These are broadcast against each other. Returns an array of the shape of the paths x channels.
        """
        members = {
            "entry_position": entry_position, "entry_normal": entry_normal, "entry_direction": entry_direction,
            "exit_position": exit_position, "exit_normal": exit_normal, "exit_direction": exit_direction,
        }  # fmt: skip
        given = structured(BSSRDF_PATH, "paths", paths, members, {})
        flat = given.reshape(-1)
        values = np.empty((self.channels, flat.size), np.float32)
        self._call(
            capi.lib.tyn_bssrdf_evaluate, self.handle, record_data(flat, capi.TynBssrdfPath), flat.size, data(values)
        )  # fmt: skip
        return _by_point(values, given.shape)

    def sample_exits(
        self,
        scene: Scene,
        entries: Any = None,
        *,
        position: ArrayLike | None = None,
        normal: ArrayLike | None = None,
        mesh: ArrayLike = 0,
        path: ArrayLike = 0,
        seed: int = 0,
        first: int = 0,
    ) -> BssrdfExits:
        """Draws the points of a mesh's surface where the light of each entry leaves, by the profile: the integral over the
        surface int f(x_o) R(|x_o - x_i|) dA is estimated by f times the weights (after King, Kulla, Conty, Fajardo 2013). See
        tyn_bssrdf_sample_exits of tyndall.h.

        scene: committed, of the same context; in the model's unit of length.
        entries: structured array of the dtype BSSRDF_ENTRY; or none, and instead
        position: on the surface of the mesh, length; ... x 3.
        normal: unit, of the surface there, outside; ... x 3.
        mesh: index of the mesh.
        path: added to first + i to choose the random numbers, >= 0, < 2^64.
        These are broadcast against each other; exits have the shape of the entries, at least one-dimensional.
        seed, first: >= 0, < 2^64; exit i is a function of seed, first + i + path, and the entry.
        """
        self._require_scene(scene)
        members, numbers = {"position": position, "normal": normal}, {"mesh": mesh, "path": path}
        given = np.atleast_1d(structured(BSSRDF_ENTRY, "entries", entries, members, numbers))
        exits = np.zeros(given.shape, BSSRDF_EXIT)
        weights = np.empty((self.channels, given.size), np.float32)
        self._call_with(
            scene, capi.lib.tyn_bssrdf_sample_exits, integer(seed, "seed", 0, UINT64),
            integer(first, "first", 0, UINT64), record_data(given, capi.TynBssrdfEntry), given.size,
            record_data(exits, capi.TynBssrdfExit), data(weights),
        )  # fmt: skip
        return BssrdfExits(exits, _by_point(weights, given.shape))

    def profile_cl(self, radii: Any, count: int, profile: Any) -> None:
        """`profile` on OpenCL buffers of float32, each a pyopencl Buffer or the address of a cl_mem: `count` radii, and
        channels x count values, channel by channel. Enqueued on the context's queue; does not wait. A radius that is not
        finite and > 0 gives 0."""
        self._of_buffers(capi.lib.tyn_bssrdf_profile_cl, radii, count, profile, "profile")

    def pdf_cl(self, radii: Any, count: int, pdf: Any) -> None:
        """`pdf` on OpenCL buffers of `count` float32 each; as profile_cl."""
        self._of_buffers(capi.lib.tyn_bssrdf_pdf_cl, radii, count, pdf, "pdf")

    def sample_cl(self, count: int, radii: Any, pdf: Any, weights: Any = None, *, seed: int = 0, first: int = 0) -> None:
        """`sample` into OpenCL buffers of float32: `count` radii and densities, and channels x count weights, channel by
        channel, or None. Enqueued on the context's queue; does not wait."""
        self._call(
            capi.lib.tyn_bssrdf_sample_cl, self.handle, integer(seed, "seed", 0, UINT64),
            integer(first, "first", 0, UINT64), integer(count, "count", 0, UINT64), cl_buffer(radii, "radii"),
            cl_buffer(pdf, "pdf"), _optional_buffer(weights, "weights"),
        )  # fmt: skip

    def evaluate_cl(self, paths: Any, count: int, values: Any) -> None:
        """`evaluate` on OpenCL buffers: `count` records BSSRDF_PATH, and channels x count float32, channel by channel.
        Enqueued on the context's queue; does not wait. The contents are not checked."""
        self._call(
            capi.lib.tyn_bssrdf_evaluate_cl, self.handle, cl_buffer(paths, "paths"), integer(count, "count", 0, UINT64),
            cl_buffer(values, "values"),
        )  # fmt: skip

    def sample_exits_cl(
        self, scene: Scene, entries: Any, count: int, exits: Any, weights: Any = None, *, seed: int = 0, first: int = 0
    ) -> None:
        """`sample_exits` on OpenCL buffers: `count` records BSSRDF_ENTRY, at most 2^32 - 1, and BSSRDF_EXIT, and channels x
        count float32 weights, channel by channel, or None. Enqueued on the context's queue; does not wait. What is bad in an
        entry ends as TYN_BSSRDF_EXIT_LOST."""
        self._require_scene(scene)
        self._call_with(
            scene, capi.lib.tyn_bssrdf_sample_exits_cl, integer(seed, "seed", 0, UINT64),
            integer(first, "first", 0, UINT64), cl_buffer(entries, "entries"), integer(count, "count", 0, UINT64),
            cl_buffer(exits, "exits"), _optional_buffer(weights, "weights"),
        )  # fmt: skip

    def _of_radii(self, function: Any, radii: ArrayLike) -> NDArray[np.float32]:
        given = array(radii, "radii")
        values = np.empty((self.channels, given.size), np.float32)
        self._call(function, self.handle, data(given), given.size, data(values))
        return _by_point(values, given.shape)

    def _of_buffers(self, function: Any, radii: Any, count: int, values: Any, name: str) -> None:
        n = integer(count, "count", 0, UINT64)
        self._call(function, self.handle, cl_buffer(radii, "radii"), n, cl_buffer(values, name))

    def _call_with(self, scene: Scene, function: Any, *arguments: Any) -> None:
        """Calls `function(model, scene, *arguments)`. Another thread may close either while this one waits for the guard, so
        both are asked for inside."""
        self._call(lambda: function(self.handle, scene.handle, *arguments))

    def _require_scene(self, scene: Scene) -> None:
        """A medium may be in millimetres and a scene in metres, and no call could tell."""
        scene_of(self.context, scene)
        own = self.metres_per_unit
        if own is not None and not np.isclose(own, scene.metres_per_unit, rtol=1e-6, atol=0):
            raise InvalidArgumentError(
                f"the scene's unit is {scene.metres_per_unit:g} m, the model's medium is in {own:g} m; make the model of"
                f" medium.converted({scene.metres_per_unit:g})"
            )

    def __repr__(self) -> str:
        state = ", closed" if self.closed else ""
        return f'<tyndall.Bssrdf "{self.model}", {self.channels} channel{"s" if self.channels > 1 else ""}{state}>'


class BssrdfCalls(ContextHandle):
    """Making models."""

    def bssrdf(
        self,
        model: str,
        layers: Layers,
        *,
        ior_above: float = 1.0,
        ior_below: float = 1.0,
        fit: str = "searchlight",
        transmitted: bool = False,
        gaussian_weights: ArrayLike | None = None,
        gaussian_variances: ArrayLike | None = None,
        exact_events: int = _EXACT_EVENTS,
        progress: Progress = None,
    ) -> Bssrdf:
        """Prepares a BSSRDF model of a medium: some milliseconds a channel, seconds where "exact" has to make a table. Papers,
        equations and errors are in tyndall_bssrdf.h and docs/bssrdf-models.md.

        model: one of `bssrdf_models()`.
        layers: a Medium (a half-space), a Layer, or several for "multipole"; the last may be infinite.
        ior_above, ior_below: indices of refraction outside, [1, 4]; below without effect for a half-space.
        fit: "normalized-diffusion": "searchlight" (light that arrives perpendicularly, radii in mean free paths), "diffuse"
            (diffuse light), "dmfp" (perpendicular light, radii in diffuse mean free paths) (Christensen & Burley 2015).
        transmitted: "multipole": True for what leaves below, False for what comes back.
        gaussian_weights: "gaussians": gaussians (x channels), 1 to 64 of them, >= 0; a channel's sum, its albedo, at most 1.
        gaussian_variances: "gaussians": as many, > 0, length^2: of x and of y.
        exact_events: "exact": scattering events that a table is made of, 1 to 1e15.
        progress: "exact": what hears of a table being made.

        Errors: InvalidArgumentError, OutOfMemoryError, DeviceError, KernelBuildError, CancelledError.
        """
        found = stack(layers)  # once: they may come from a generator
        slab = slab_record(found, ior_above, ior_below)
        weights, variances = _gaussians(gaussian_weights, gaussian_variances, slab.channel_count)
        options = capi.TynBssrdfOptions(
            model=model_choice(model), fit=choice(fit, "fit", _FITS), transmitted=int(bool(transmitted)),
            gaussian_count=0 if weights is None else weights.shape[1], gaussian_weights=data(weights),
            gaussian_variances=data(variances), exact_events=integer(exact_events, "exact_events", 1, UINT64),
        )  # fmt: skip
        pointer = ctypes.POINTER(capi.TynBssrdf)()
        with LongCall(progress, "tables") as call:
            options.progress = call.callback
            self._call(
                capi.lib.tyn_bssrdf_create, self.handle, ctypes.byref(slab), ctypes.byref(options), ctypes.byref(pointer)
            )  # fmt: skip
        return Bssrdf(self, model, found, pointer)


def _by_point(values: NDArray[np.float32], shape: tuple[int, ...]) -> NDArray[np.float32]:
    """What the library stores channel by channel, as an array of its own of `shape` x channels."""
    channels = len(values)
    result = np.empty((*shape, channels), np.float32)
    result.reshape(values.shape[1], channels)[...] = values.T
    return result


def _gaussians(
    weights: ArrayLike | None, variances: ArrayLike | None, channels: int
) -> tuple[NDArray[np.float64] | None, NDArray[np.float64] | None]:
    """Weights and variances as the C API has them: channels x gaussians."""
    if weights is None or variances is None:
        if weights is not variances:
            raise InvalidArgumentError("gaussian_weights and gaussian_variances belong together; one of them is missing")
        return None, None
    first, second = (
        _columns(array(value, name, np.float64), name, channels)
        for value, name in ((weights, "gaussian_weights"), (variances, "gaussian_variances"))
    )
    if len(first) != len(second):
        raise InvalidArgumentError(f"there are {len(first)} gaussian_weights and {len(second)} gaussian_variances")
    return np.ascontiguousarray(first.T), np.ascontiguousarray(second.T)


def _columns(values: NDArray[np.float64], name: str, channels: int) -> NDArray[np.float64]:
    table = values[:, None] if values.ndim == 1 else values
    if table.ndim != 2 or len(table) == 0 or table.shape[1] not in (1, channels):
        raise InvalidArgumentError(
            f"{name} has the shape {values.shape}; it must be gaussians or gaussians x channels ({channels})"
        )
    return np.broadcast_to(table, (len(table), channels))


def _optional_buffer(value: Any, name: str) -> int | None:
    return None if value is None else cl_buffer(value, name)
