# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""BSSRDF models, against closed forms and the C API in its raw form."""

from __future__ import annotations

import ctypes
import signal
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from scenes import floor

import tyndall as ty
from tyndall import capi, errors

SIGMA_A, SIGMA_S, IOR = np.array([0.032, 0.17, 0.48]), np.array([0.74, 0.88, 1.01]), 1.3
RADII = np.geomspace(0.01, 20, 60)
GAUSS_WEIGHTS, GAUSS_VARIANCES = np.array([[0.3, 0.1], [0.2, 0.05]]), np.array([[0.25, 1.0], [4.0, 9.0]])


def skin() -> ty.Medium:
    return ty.Medium(SIGMA_A, SIGMA_S, ior=IOR)


@pytest.fixture(scope="module")
def dipole(context: ty.Context) -> ty.Bssrdf:
    return context.bssrdf("standard-dipole", skin())


@pytest.fixture(scope="module")
def gaussians(context: ty.Context) -> ty.Bssrdf:
    medium = ty.Medium([1, 1], [1, 1])
    return context.bssrdf("gaussians", medium, gaussian_weights=GAUSS_WEIGHTS, gaussian_variances=GAUSS_VARIANCES)


def pointer(values: Any, kind: Any = ctypes.c_float) -> Any:
    return values.ctypes.data_as(ctypes.POINTER(kind))


def dipole_constants() -> tuple[Any, ...]:
    """Reduced albedo, depth of the source, transport coefficient and A of Jensen et al. 2001."""
    sigma_t = SIGMA_A + SIGMA_S
    fresnel = -1.440 / IOR**2 + 0.710 / IOR + 0.668 + 0.0636 * IOR
    return SIGMA_S / sigma_t, 1 / sigma_t, np.sqrt(3 * SIGMA_A * sigma_t), (1 + fresnel) / (1 - fresnel)


def test_standard_dipole_is_equation_4_of_jensen_2001(dipole: ty.Bssrdf) -> None:
    albedo, z_r, sigma_tr, a = dipole_constants()
    z_v = z_r * (1 + 4 / 3 * a)
    expected = 0.0
    for z in (z_r, z_v):
        d = np.sqrt(RADII[:, None] ** 2 + z**2)
        expected = expected + albedo / (4 * np.pi) * z * (sigma_tr + 1 / d) * np.exp(-sigma_tr * d) / d**2
    np.testing.assert_allclose(dipole.profile(RADII), expected, rtol=3e-5)


def test_albedo_of_the_standard_dipole_is_equation_15_of_jensen_2002(dipole: ty.Bssrdf) -> None:
    albedo, _, _, a = dipole_constants()
    root = np.sqrt(3 * (1 - albedo))
    np.testing.assert_allclose(dipole.albedo, albedo / 2 * (1 + np.exp(-4 / 3 * a * root)) * np.exp(-root), rtol=1e-9)


def test_gaussians_are_gaussians_of_their_column(gaussians: ty.Bssrdf) -> None:
    square = RADII[:, None, None] ** 2
    expected = (GAUSS_WEIGHTS / (2 * np.pi * GAUSS_VARIANCES) * np.exp(-square / (2 * GAUSS_VARIANCES))).sum(axis=1)
    near = RADII < 5
    np.testing.assert_allclose(gaussians.profile(RADII)[near], expected[near], rtol=3e-5)
    np.testing.assert_allclose(gaussians.albedo, GAUSS_WEIGHTS.sum(axis=0), rtol=1e-12)


def test_gaussians_of_one_column_are_those_of_all_channels(context: ty.Context) -> None:
    model = context.bssrdf("gaussians", skin(), gaussian_weights=[0.25, 0.5], gaussian_variances=[1.0, 2.0])
    np.testing.assert_allclose(model.albedo, [0.75] * 3, rtol=1e-12)


@pytest.mark.parametrize("name", [name for name in ty.bssrdf_models() if name not in ("gaussians", "exact")])
def test_profile_integrates_to_the_albedo(context: ty.Context, name: str) -> None:
    model = context.bssrdf(name, skin())
    r = np.geomspace(1e-7, 300, 20000)
    integrand = 2 * np.pi * r[:, None] ** 2 * model.profile(r).astype(float)
    integral = ((integrand[1:] + integrand[:-1]) / 2 * np.diff(np.log(r))[:, None]).sum(axis=0)
    np.testing.assert_allclose(integral, model.albedo, rtol=2e-3)


def test_fits_of_normalized_diffusion_are_christensen_and_burley_2015(context: ty.Context) -> None:
    medium = ty.Medium.from_albedo(0.9, 2.0)
    for fit, shape in (
        ("searchlight", lambda a: 1.85 - a + 7 * abs(a - 0.8) ** 3),
        ("diffuse", lambda a: 1.9 - a + 3.5 * (a - 0.8) ** 2),
    ):
        model = context.bssrdf("normalized-diffusion", medium, fit=fit)
        albedo = model.albedo
        d = 2.0 / shape(albedo)
        r = RADII[:, None]
        expected = albedo * (np.exp(-r / d) + np.exp(-r / (3 * d))) / (8 * np.pi * d * r)
        np.testing.assert_allclose(model.profile(RADII), expected, rtol=3e-5)


def test_samples_follow_the_gaussians(gaussians: ty.Bssrdf) -> None:
    """Chi-square over 20 bins that are equally likely, 40000 samples: above 75.8 once in 10^8 (19 degrees of freedom)."""
    radii = gaussians.sample(40000, seed=7).radii.astype(float)
    chance = GAUSS_WEIGHTS / GAUSS_WEIGHTS.sum()  # a channel in proportion to its albedo, a Gaussian to its weight
    below = 1 - (chance * np.exp(-(radii[:, None, None] ** 2) / (2 * GAUSS_VARIANCES))).sum(axis=(1, 2))
    counts = np.histogram(below, bins=20, range=(0, 1))[0]
    assert ((counts - 2000.0) ** 2 / 2000).sum() < 75.8


def test_weights_are_profile_over_pdf_and_add_up_to_the_albedo(dipole: ty.Bssrdf) -> None:
    samples = dipole.sample(40000, seed=3)
    np.testing.assert_array_equal(samples.pdf, dipole.pdf(samples.radii))
    np.testing.assert_allclose(samples.weights, dipole.profile(samples.radii) / samples.pdf[:, None], rtol=1e-4, atol=1e-6)
    error = samples.weights.std(axis=0, dtype=float) / np.sqrt(40000)
    assert np.all(np.abs(samples.weights.mean(axis=0, dtype=float) - dipole.albedo) < 5.5 * error)  # 1e-7 in all


def test_samples_are_functions_of_seed_and_number(dipole: ty.Bssrdf) -> None:
    whole, part = dipole.sample(64, seed=5, first=100), dipole.sample(24, seed=5, first=140)
    for one, other in zip(part, whole):
        np.testing.assert_array_equal(one, other[40:])
    assert not np.array_equal(dipole.sample(64, seed=6, first=100).radii, whole.radii)


@pytest.mark.parametrize("name", ["standard-dipole", "directional-dipole", "multipole"])
def test_batch_calls_give_the_bits_of_the_raw_calls(context: ty.Context, name: str) -> None:
    model = context.bssrdf(name, skin())
    radii = np.geomspace(0.1, 10, 7).astype(np.float32)
    raw = np.empty((3, 7), np.float32)
    assert capi.lib.tyn_bssrdf_profile(model.handle, pointer(radii), 7, pointer(raw)) == capi.TYN_OK
    np.testing.assert_array_equal(model.profile(radii), raw.T)
    pdf, drawn = np.empty(7, np.float32), np.empty(7, np.float32)
    assert capi.lib.tyn_bssrdf_sample(model.handle, 9, 4, 7, pointer(drawn), pointer(pdf), pointer(raw)) == capi.TYN_OK
    samples = model.sample(7, seed=9, first=4)
    for one, other in zip(samples, (drawn, pdf, raw.T)):
        np.testing.assert_array_equal(one, other)
    assert capi.lib.tyn_bssrdf_pdf(model.handle, pointer(radii), 7, pointer(pdf)) == capi.TYN_OK
    np.testing.assert_array_equal(model.pdf(radii), pdf)
    paths = some_paths(7)
    record = paths.ctypes.data_as(ctypes.POINTER(capi.TynBssrdfPath))
    assert capi.lib.tyn_bssrdf_evaluate(model.handle, record, 7, pointer(raw)) == capi.TYN_OK
    np.testing.assert_array_equal(model.evaluate(paths), raw.T)
    np.testing.assert_array_equal(model.evaluate(**{member: paths[member] for member in paths.dtype.names or ()}), raw.T)


def some_paths(count: int) -> Any:
    paths = np.zeros(count, ty.BSSRDF_PATH)
    angles = np.linspace(0, 1.4, count)
    paths["entry_normal"] = paths["exit_normal"] = (0, 0, 1)
    paths["entry_direction"] = np.stack([np.sin(angles), 0 * angles, -np.cos(angles)], axis=1)
    paths["exit_direction"] = np.stack([0 * angles, np.sin(angles), np.cos(angles)], axis=1)
    paths["exit_position"][:, 0] = np.geomspace(0.1, 5, count)
    return paths


def test_evaluate_of_an_index_matched_separable_model_is_its_profile_over_pi(context: ty.Context) -> None:
    model = context.bssrdf("standard-dipole", ty.Medium(SIGMA_A, SIGMA_S))
    x = np.geomspace(0.1, 5, 5)
    values = model.evaluate(
        entry_position=(1, 2, 3), entry_normal=(0, 0, 1), entry_direction=(0.6, 0, -0.8), exit_normal=(0, 0, 1),
        exit_direction=np.array([(0, 0, 1), (0, 0.8, 0.6)])[:, None], exit_position=np.stack([1 + x, 2 + 0 * x, 3 + 0 * x], 1),
    )  # fmt: skip
    assert values.shape == (2, 5, 3)
    np.testing.assert_allclose(values, np.broadcast_to(model.profile(x) / np.pi, values.shape), rtol=1e-4)


def test_shapes(context: ty.Context, dipole: ty.Bssrdf) -> None:
    grey = context.bssrdf("standard-dipole", ty.Medium(1, 1))
    for model, channels in ((dipole, 3), (grey, 1)):
        assert model.channels == channels and model.albedo.shape == (channels,)
        assert model.profile(1.0).shape == model.profile_error(1.0).shape == (channels,)
        assert model.pdf(1.0).shape == ()
        assert model.profile(np.ones((2, 3))).shape == (2, 3, channels) and model.pdf(np.ones((2, 3))).shape == (2, 3)
        assert model.profile([]).shape == (0, channels) and model.sample(0).weights.shape == (0, channels)
        assert model.sample(5).weights.shape == (5, channels)
        assert model.evaluate(some_paths(6).reshape(2, 3)).shape == (2, 3, channels)
        assert model.evaluate(some_paths(1)[0]).shape == (channels,)
        assert model.profile(np.ones(3)).flags.owndata


@settings(max_examples=25, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(
    kind=st.sampled_from(["f4", "f8", "i4", "u1", ">f4", "f2"]),
    shape=st.sampled_from([(), (1,), (5,), (2, 3), (0,), (2, 0, 3), (1, 2, 2)]),
    step=st.sampled_from([1, 2, -1]),
    transposed=st.booleans(),
)
def test_radii_of_any_type_shape_and_stride(
    dipole: ty.Bssrdf, kind: str, shape: tuple[int, ...], step: int, transposed: bool
) -> None:
    radii = np.arange(1, 1 + np.prod(shape, dtype=int)).reshape(shape).astype(kind)
    if radii.ndim:
        radii = radii[::step]
    if transposed:
        radii = radii.T
    single = [dipole.profile(np.float32(r)) for r in radii.ravel()]
    np.testing.assert_array_equal(dipole.profile(radii), np.reshape(single, (*radii.shape, 3)))


def test_multipole_takes_layers_and_what_they_transmit(context: ty.Context) -> None:
    layers = [ty.Layer(skin(), 8.0), ty.Layer(ty.Medium(0.01, 1.0), 12.0)]
    above = context.bssrdf("multipole", layers)
    below = context.bssrdf("multipole", layers, transmitted=True)
    assert above.channels == 3 and np.all(below.albedo < above.albedo) and np.all(below.albedo > 0)
    with pytest.raises(errors.InvalidArgumentError, match="layer"):
        context.bssrdf("standard-dipole", layers)


def test_default_context_makes_models_too() -> None:
    model = ty.bssrdf("gaussians", ty.Medium(1, 1), gaussian_weights=[0.5], gaussian_variances=[1.0])
    assert model.context is ty.default_context()
    np.testing.assert_allclose(model.profile(1e-3), 0.5 / (2 * np.pi), rtol=1e-5)


# ---- exit points ----


def test_exits_on_a_plane_add_up_to_the_albedo(context: ty.Context, dipole: ty.Bssrdf) -> None:
    scene = floor(context, 1000.0)
    exits, weights = dipole.sample_exits(scene, position=np.zeros((20000, 3)), normal=(0, 0, 1), seed=2)
    assert exits.shape == (20000,) and weights.shape == (20000, 3)
    found = exits["status"] == capi.TYN_BSSRDF_EXIT_FOUND
    assert found.mean() > 0.99
    assert np.all(exits["position"][found, 2] == 0)
    distance = np.hypot(*exits["position"][found, :2].T)
    np.testing.assert_allclose(exits["distance"][found], distance, rtol=1e-5)
    error = weights.std(axis=0, dtype=float) / np.sqrt(20000)
    assert np.all(np.abs(weights.mean(axis=0, dtype=float) - dipole.albedo) < 5.5 * error + 1e-3)  # the floor ends


def test_exits_are_those_of_the_raw_call(context: ty.Context, dipole: ty.Bssrdf) -> None:
    scene = floor(context, 10.0)
    entries = np.zeros(5, ty.BSSRDF_ENTRY)
    entries["position"][:, 0] = np.linspace(-3, 3, 5)
    entries["normal"] = (0, 0, 1)
    entries["path"] = (7, 1)
    exits, weights = np.zeros(5, ty.BSSRDF_EXIT), np.empty((3, 5), np.float32)
    status = capi.lib.tyn_bssrdf_sample_exits(
        dipole.handle, scene.handle, 11, 3, entries.ctypes.data_as(ctypes.POINTER(capi.TynBssrdfEntry)), 5,
        exits.ctypes.data_as(ctypes.POINTER(capi.TynBssrdfExit)), pointer(weights),
    )  # fmt: skip
    assert status == capi.TYN_OK
    path = (1 << 32) + 7
    for found in (
        dipole.sample_exits(scene, entries, seed=11, first=3),
        dipole.sample_exits(scene, position=entries["position"], normal=(0, 0, 1), path=path, seed=11, first=3),
        dipole.sample_exits(scene, position=entries["position"], normal=(0, 0, 1), path=[path + 3] * 5, seed=11),
    ):
        assert found.exits.tobytes() == exits.tobytes()
        np.testing.assert_array_equal(found.weights, weights.T)


def test_bad_exits(context: ty.Context, dipole: ty.Bssrdf) -> None:
    scene = floor(context, 10.0)
    some = {"position": np.zeros((2, 3)), "normal": (0, 0, 1)}
    for options, message in (
        ({}, "without entries, position and normal must be given"),
        ({"position": (0, 0, 0)}, "without entries, normal must"),
        ({"entries": np.zeros(2, ty.BSSRDF_ENTRY), **some}, "not both"),
        ({"entries": np.zeros(2)}, "structured array"),
        ({**some, "normal": (0, 0, 2)}, r"normal"),
        ({**some, "normal": (0, 1)}, "last axis"),
        ({**some, "mesh": 1}, "mesh"),
        ({**some, "mesh": -1}, "mesh must be numbers that fit uint32"),
        ({**some, "mesh": [0, 0, 0]}, "do not fit each other"),
        ({**some, "position": np.full((2, 3), np.nan)}, "position"),
    ):
        with pytest.raises(errors.InvalidArgumentError, match=message):
            dipole.sample_exits(scene, **options)
    with pytest.raises(errors.InvalidArgumentError, match="scene is None"):
        dipole.sample_exits(None, **some)
    with pytest.raises(errors.InvalidOperationError, match="commit"):
        dipole.sample_exits(context.scene(), **some)
    with ty.Context() as other, pytest.raises(errors.InvalidArgumentError, match="another context"):
        dipole.sample_exits(floor(other, 10.0), **some)


def test_units_of_scene_and_medium_must_agree(context: ty.Context) -> None:
    medium = ty.Medium.preset("skin1")
    scene = floor(context, 10.0)
    some = {"position": np.zeros((2, 3)), "normal": (0, 0, 1)}
    with pytest.raises(errors.InvalidArgumentError, match=r"medium\.converted\(1\)"):
        context.bssrdf("standard-dipole", medium).sample_exits(scene, **some)
    assert context.bssrdf("standard-dipole", medium.converted(1.0)).sample_exits(scene, **some).exits.shape == (2,)


# ---- buffers ----


def test_calls_on_buffers_give_the_bits_of_those_on_arrays(context: ty.Context, dipole: ty.Bssrdf) -> None:
    cl = pytest.importorskip("pyopencl")
    addresses = [ctypes.c_void_p() for _ in range(3)]
    assert capi.lib.tyn_context_cl(context.handle, *map(ctypes.byref, addresses)) == capi.TYN_OK
    device_context, queue = (
        kind.from_int_ptr(address.value, retain=True) for kind, address in zip((cl.Context, cl.CommandQueue), addresses)
    )

    def buffer(values: Any) -> Any:
        return cl.Buffer(device_context, cl.mem_flags.READ_WRITE | cl.mem_flags.COPY_HOST_PTR, hostbuf=values)

    def contents(held: Any, dtype: Any, shape: tuple[int, ...]) -> Any:
        values = np.empty(shape, dtype)
        cl.enqueue_copy(queue, values, held)
        return values

    n = 6
    radii = np.geomspace(0.1, 10, n).astype(np.float32)
    given, values, pdf = buffer(radii), buffer(np.empty((3, n), np.float32)), buffer(radii)
    dipole.profile_cl(given, n, values)
    np.testing.assert_array_equal(contents(values, np.float32, (3, n)).T, dipole.profile(radii))
    dipole.pdf_cl(given, n, pdf.int_ptr)
    np.testing.assert_array_equal(contents(pdf, np.float32, (n,)), dipole.pdf(radii))
    dipole.sample_cl(n, given, pdf, values, seed=3, first=1)
    samples = dipole.sample(n, seed=3, first=1)
    np.testing.assert_array_equal(contents(given, np.float32, (n,)), samples.radii)
    np.testing.assert_array_equal(contents(values, np.float32, (3, n)).T, samples.weights)
    dipole.sample_cl(n, given, pdf, seed=3, first=1)
    np.testing.assert_array_equal(contents(pdf, np.float32, (n,)), samples.pdf)
    paths = some_paths(n)
    dipole.evaluate_cl(buffer(paths), n, values)
    np.testing.assert_array_equal(contents(values, np.float32, (3, n)).T, dipole.evaluate(paths))
    scene = floor(context, 10.0)
    entries = np.zeros(n, ty.BSSRDF_ENTRY)
    entries["normal"] = (0, 0, 1)
    exits = buffer(np.zeros(n, ty.BSSRDF_EXIT))
    dipole.sample_exits_cl(scene, buffer(entries), n, exits, values, seed=8)
    found = dipole.sample_exits(scene, entries, seed=8)
    assert contents(exits, ty.BSSRDF_EXIT, (n,)).tobytes() == found.exits.tobytes()
    np.testing.assert_array_equal(contents(values, np.float32, (3, n)).T, found.weights)
    with pytest.raises(errors.InvalidArgumentError, match="radii"):
        dipole.profile_cl(None, n, values)
    with pytest.raises(errors.InvalidArgumentError, match="profile"):
        dipole.profile_cl(given, n, buffer(radii))  # room for one channel


# ---- exact, and what goes wrong ----


def half_space_albedo(albedo: float) -> float:
    """What an index-matched, isotropic half-space sends back of perpendicular light: 1 - H(1) sqrt(1 - albedo), with
    Chandrasekhar's H function by the iteration 1 / H(mu) = sqrt(1 - albedo) + albedo / 2 int x H(x) / (x + mu) dx."""
    x, weight = np.polynomial.legendre.leggauss(64)
    x, weight, root = (x + 1) / 2, weight / 2, np.sqrt(1 - albedo)
    h = np.ones(64)
    for _ in range(200):
        h = 1 / (root + albedo / 2 * (weight * x * h / (x + x[:, None])).sum(axis=1))
    return float(1 - root / (root + albedo / 2 * (weight * x * h / (x + 1)).sum()))


def test_exact_says_its_error_and_its_progress() -> None:
    heard: list[float] = []
    with ty.Context(cache_directory="") as own:
        model = own.bssrdf("exact", ty.Medium(0.1, 0.9), exact_events=1_000_000, progress=heard.append)
        assert heard and all(0 <= fraction <= 1 for fraction in heard)
        error, profile = model.profile_error([0.1, 1.0]), model.profile([0.1, 1.0])
        assert np.all(error > 0) and np.all(error < 0.3 * profile)
        np.testing.assert_allclose(model.albedo, half_space_albedo(0.9), rtol=1e-4)


def test_ctrl_c_and_callbacks_end_the_making_of_a_table() -> None:
    with ty.Context(cache_directory="") as own:
        medium = ty.Medium(0.1, 0.9)

        def interrupt(fraction: float) -> None:
            signal.raise_signal(signal.SIGINT)

        with pytest.raises(KeyboardInterrupt):
            own.bssrdf("exact", medium, progress=interrupt)
        with pytest.raises(errors.CancelledError):
            own.bssrdf("exact", medium, progress=lambda fraction: True)
        with pytest.raises(ZeroDivisionError):
            own.bssrdf("exact", medium, progress=lambda fraction: 1 / 0)


def test_bad_arguments(context: ty.Context, dipole: ty.Bssrdf) -> None:
    for call, message in (
        (lambda: context.bssrdf("dipole", skin()), 'model is .dipole.; it must be one of "standard-dipole"'),
        (lambda: context.bssrdf(3, skin()), "model is 3"),  # type: ignore[arg-type]
        (lambda: context.bssrdf("standard-dipole", "skin1"), "layers must be"),  # type: ignore[arg-type]
        (lambda: context.bssrdf("normalized-diffusion", skin(), fit="best"), 'fit is .best.; .*"searchlight"'),
        (lambda: context.bssrdf("standard-dipole", skin(), ior_above=0.5), "ior_above"),
        (lambda: context.bssrdf("gaussians", skin()), "gaussian"),
        (lambda: context.bssrdf("gaussians", skin(), gaussian_weights=[1.0]), "belong together"),
        (lambda: context.bssrdf("gaussians", skin(), gaussian_weights=[0.5], gaussian_variances=[1, 2]), "are 1 gauss"),
        (lambda: context.bssrdf("gaussians", skin(), gaussian_weights=np.ones((2, 2)), gaussian_variances=[1, 2]), "shape"),
        (lambda: context.bssrdf("gaussians", skin(), gaussian_weights=[2.0], gaussian_variances=[1.0]), "gaussian_weights"),
        (lambda: context.bssrdf("exact", skin(), exact_events=0), "exact_events"),
        (lambda: dipole.profile([1.0, np.nan]), r"radii\[1\] is nan"),
        (lambda: dipole.profile([1.0, 0.0]), r"radii\[1\] is 0"),
        (lambda: dipole.pdf(1e300), r"radii\[0\] is inf"),
        (lambda: dipole.profile("wide"), "radii must be numbers"),
        (lambda: dipole.profile(1j), "radii must be numbers"),
        (lambda: dipole.evaluate(), "must be given"),
        (lambda: dipole.evaluate(np.zeros(3)), "paths must be"),
        (lambda: dipole.evaluate(np.zeros(3, ty.BSSRDF_PATH)), r"paths\[0\].*normal"),
    ):  # fmt: skip
        with pytest.raises(errors.InvalidArgumentError, match=message):
            call()
    for call, message in ((lambda: dipole.sample(-1), "count is -1"), (lambda: dipole.sample(1, seed=-1), "seed is -1")):
        with pytest.raises(ValueError, match=message):
            call()
    with pytest.raises(errors.InvalidArgumentError, match=r"count is 1\.5"):
        dipole.sample(1.5)  # type: ignore[arg-type]


def test_closed_models_and_contexts() -> None:
    with ty.Context() as own:
        model, other = (own.bssrdf("standard-dipole", skin()) for _ in range(2))
        model.close()
        model.close()
        assert model.closed and "closed" in repr(model)
        for call in (lambda: model.albedo, lambda: model.profile(1.0), lambda: model.sample(3)):
            with pytest.raises(errors.ClosedError, match="BSSRDF model was closed"):
                call()
        assert other.profile(1.0).shape == (3,)
    with pytest.raises(errors.ClosedError):
        other.profile(1.0)
    with pytest.raises(errors.ClosedError):
        own.bssrdf("standard-dipole", skin())


def test_layers_of_a_generator(context):
    medium = ty.Medium(0.1, 2)
    layers = [ty.Layer(medium, 1.0), ty.Layer(medium)]
    with context.bssrdf("multipole", iter(layers[:1])) as one, context.bssrdf("multipole", layers[:1]) as same:
        assert one.layers == same.layers
        np.testing.assert_array_equal(one.profile([0.5, 1]), same.profile([0.5, 1]))
    with pytest.raises(errors.InvalidArgumentError, match="layers"):
        context.bssrdf("multipole", iter([]))


def test_path_numbers_keep_all_bits(context):
    numbers = [1, 2**63 + 1, 2**64 - 4]  # numpy makes float64 of such a list
    words = [[1, 0], [1, 2**31], [2**32 - 4, 2**32 - 1]]
    assert ty.walk_entries([0, 0, 0], kind="cosine", path=numbers)["path"].tolist() == words
    given = np.zeros(3, ty.BSSRDF_ENTRY)
    given["position"], given["normal"], given["path"] = [0, 0, 1], [0, 0, 1], words
    with context.scene() as scene, context.bssrdf("better-dipole", ty.Medium(0.1, 4)) as model:
        scene.add_mesh(*ty.shapes.sphere(1.0, 2))
        scene.commit()
        found = model.sample_exits(scene, position=[0, 0, 1], normal=[0, 0, 1], path=numbers)
        same = model.sample_exits(scene, given)
    assert len(np.unique(same.exits)) == 3
    assert found.exits.tobytes() == same.exits.tobytes()


@pytest.mark.parametrize("path", [-1, 0.5, [1, 2**64], [0.0, 2.0**64], [1, "a"], [1, None], np.nan, [[1], [2, 3]]])
def test_what_is_no_path_number(context, path):
    with pytest.raises(errors.InvalidArgumentError, match="path"):
        ty.walk_entries([0, 0, 0], kind="cosine", path=path)
    with context.scene() as scene, context.bssrdf("better-dipole", ty.Medium(0.1, 4)) as model:
        with pytest.raises(errors.InvalidArgumentError, match="path"):
            model.sample_exits(scene, position=[0, 0, 1], normal=[0, 0, 1], path=path)
