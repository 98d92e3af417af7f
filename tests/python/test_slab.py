# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Slabs by Monte Carlo: against published and exact values, within 4 standard errors at fixed seeds."""

import ctypes
import os
import pickle
import signal
import threading
import time

import numpy as np
import pytest

import tyndall as ty
from tyndall import capi

InvalidArgumentError = ty.errors.InvalidArgumentError
MEDIUM = ty.Medium(10, 90, g=0.75)  # van de Hulst's, in 1/cm
VAN_DE_HULST = [ty.Layer(MEDIUM, thickness=0.02)]
ENDLESS = 10**14  # photons


def agrees(estimate, exact, errors=4.0):
    assert np.all(np.abs(np.asarray(estimate) - exact) <= errors * estimate.stderr + 1e-9), (estimate, exact)


@pytest.fixture(scope="module")
def resolved(context):
    """A slab of two channels and two layers with all that can be asked for."""
    layers = [ty.Layer(ty.Medium(1, [4, 9], g=0.3, ior=1.4), 0.5), ty.Layer(ty.Medium(0.5, 2, ior=1.4), 1.0)]
    bins = {"radial": (4.0, 8), "angular": 6, "depth": (1.5, 30), "orders": 20, "path": (10.0, 5)}
    return context.slab(layers, photons=50000, seed=5, ior_below=1.2, radial_angular=True, **bins)


def test_van_de_hulsts_slab(context):
    """van de Hulst 1980."""
    found = context.slab(VAN_DE_HULST, photons=1e6, radial=(10.0, 200))
    agrees(found.reflectance.total, 0.097395)
    agrees(found.transmittance.total, 0.660958)
    agrees(found.transmittance.direct, np.exp(-2))
    assert 1e-5 < found.reflectance.total.stderr < 5e-4
    assert found.run.photons == 10**6
    assert found.radial.reflectance.shape == (200, 1)
    assert found.angular is None and found.sweep is None


def test_giovanellis_half_space(context):
    """Giovanelli 1955."""
    medium = ty.Medium(1, 9, ior=1.5)
    agrees(context.slab(medium, photons=300000).reflectance.total, 0.259919)
    assert context.slab(medium, photons=1000).reflectance.specular == pytest.approx([0.04], abs=1e-6)
    agrees(context.slab(medium, photons=300000, incidence="diffuse").reflectance.total, 0.307890)


def test_energy_is_in_balance(resolved):
    for part in (resolved.reflectance, resolved.transmittance):
        parts = [value for name, value in vars(part).items() if name != "total"]
        np.testing.assert_allclose(np.sum(parts, axis=0), part.total, atol=1e-9)
    total = resolved.reflectance.total + resolved.transmittance.total + resolved.absorbed + resolved.cut
    np.testing.assert_allclose(total, 1, atol=1e-6)
    np.testing.assert_allclose(resolved.layer_absorbed.sum(axis=0), resolved.absorbed, atol=1e-6)


def test_shapes_and_axes(resolved):
    assert resolved.reflectance.total.shape == (2,)
    assert resolved.layer_absorbed.shape == (2, 2)
    assert resolved.radial.transmittance.shape == (8, 2)
    assert resolved.angular.reflectance.shape == (6, 2)
    assert resolved.radial_angular.reflectance.shape == (8, 6, 2)
    assert resolved.depth.fluence.shape == (30, 2)
    assert resolved.orders.reflectance.shape == (20, 2)
    assert resolved.path.transmittance.shape == (5, 2)
    np.testing.assert_allclose(resolved.radial.edges, np.arange(9) / 2)
    np.testing.assert_allclose(resolved.radial.centers, np.arange(8) / 2 + 0.25)
    np.testing.assert_allclose(resolved.angular.edges[[0, -1]], [0, np.pi / 2])
    np.testing.assert_allclose(resolved.path.edges, np.arange(6) * 2)
    np.testing.assert_array_equal(resolved.orders.orders, np.arange(20))


def test_what_is_resolved_adds_up(resolved):
    """Integrals over radius and angle are at most the diffuse totals, and nearly them: 4 units are 10 mean free paths."""
    diffuse = resolved.reflectance.diffuse
    rings = np.pi * np.diff(resolved.radial.edges**2)[:, None]
    sides = 2 * np.pi * -np.diff(np.cos(resolved.angular.edges))[:, None]
    np.testing.assert_allclose((resolved.angular.reflectance * sides).sum(axis=0), diffuse, rtol=1e-5)
    np.testing.assert_allclose((resolved.radial.reflectance * rings).sum(axis=0), diffuse, rtol=0.02)
    per_ring = (resolved.radial_angular.reflectance * sides).sum(axis=1)
    np.testing.assert_allclose(per_ring, resolved.radial.reflectance, rtol=1e-5, atol=1e-9)
    np.testing.assert_allclose(resolved.orders.reflectance[0], resolved.reflectance.specular, atol=1e-9)
    np.testing.assert_allclose(resolved.orders.transmittance[0], resolved.transmittance.direct, atol=1e-9)


def test_absorption_by_depth_is_that_of_the_layers(resolved):
    """Two estimates of it; 10 bins are in the first layer, 20 in the second."""
    absorbed = resolved.depth.absorbed
    for layer, bins in enumerate((slice(0, 10), slice(10, 30))):
        difference = absorbed[bins].sum(axis=0) * 0.05 - resolved.layer_absorbed[layer]
        error = np.hypot(absorbed[bins].stderr.sum(axis=0) * 0.05, resolved.layer_absorbed[layer].stderr)
        assert np.all(np.abs(difference) < 2 * error)
        assert np.all(error < 0.03 * resolved.layer_absorbed[layer])


def test_depth_against_beers_law(context):
    """Without scattering, exp(-sigma_a z): what is absorbed per depth is sigma_a times the fluence."""
    found = context.slab(ty.Layer(ty.Medium(2, 0), 1.0), photons=100000, depth=(1.0, 4)).depth
    mean = -np.diff(np.exp(-2 * found.edges)) / (2 * 0.25)
    agrees(found.fluence[:, 0], mean)
    agrees(found.absorbed[:, 0], 2 * mean)


def test_a_disc_lights_its_radius_alone(context):
    """An optically thin layer scatters where the light is."""
    layer = ty.Layer(ty.Medium(0, 10, g=0.0), 1e-3)
    found = context.slab(layer, photons=100000, beam="disc", beam_radius=1.0, radial=(2.0, 2)).radial
    total = np.pi * found.reflectance[0, 0]
    assert found.reflectance[1, 0] * 3 * np.pi < 0.05 * total
    wide = context.slab(layer, photons=100000, beam="gaussian", beam_radius=1.0, radial=(2.0, 2)).radial
    inside = wide.reflectance[0, 0] / (wide.reflectance[0, 0] + 3 * wide.reflectance[1, 0])
    assert inside == pytest.approx((1 - np.exp(-2)) / (1 - np.exp(-8)), abs=0.05)  # within the 1/e^2 radius


def test_first_order_by_beers_law(context):
    """Walks that end at their first event leave unscattered only."""
    found = context.slab(VAN_DE_HULST, photons=20000, max_order=1, angle=0.5)
    agrees(found.transmittance.direct, np.exp(-2 / np.cos(0.5)))
    assert found.cut > 0.05


def test_a_sweep_is_as_many_slabs(context):
    slab = ty.Layer(ty.Medium(0.1, 9.9, g=0.5), 0.3)
    stacks = [ty.Medium(a, s, g=0.5) for a, s in ((0.1, 9.9), (1, 9), (5, 9.9))]
    forms = [
        stacks,
        [ty.Layer(one, 0.3) for one in stacks],
        [[one] for one in stacks],
        ([0.1, 1, 5], np.array([9.9, 0, 9, 0, 9.9])[::2]),
        np.array([[[0.1], [1], [5]], [[9.9], [9], [9.9]]]),
    ]
    runs = [context.slab(slab, photons=100000, sweep=form).sweep for form in forms]
    for row, medium in enumerate(stacks):
        exact = ty.adding_doubling(ty.Layer(medium, 0.3))
        agrees(runs[0].reflectance[row], exact.reflectance)
        agrees(runs[0].transmittance[row], exact.transmittance)
        agrees(runs[0].absorbed[row], exact.absorbed)
    for run in runs:
        assert run.absorbed.shape == (3, 1)
        np.testing.assert_allclose(run.sigma_a, [[0.1], [1], [5]])
        np.testing.assert_allclose(run.reflectance, runs[0].reflectance, rtol=1e-6)


def test_a_sweep_of_layers_takes_rows_of_them(context):
    layers = [ty.Layer(ty.Medium(0, 3), 0.4), ty.Layer(ty.Medium(0.1, 5), 0.5)]
    other = [ty.Layer(ty.Medium(1, 3), 0.4), ty.Medium(2, 4)]
    found = context.slab(layers, photons=50000, sweep=[other]).sweep
    np.testing.assert_array_equal(found.sigma_a, [[1, 2]])
    np.testing.assert_array_equal(found.sigma_s, [[3, 4]])
    agrees(found.reflectance[0], ty.adding_doubling([other[0], ty.Layer(other[1], 0.5)]).reflectance)


def raw_run(context, seed):
    """As `resolved`, by calls of the C API."""
    numbers = [(ctypes.c_double * 2)(*pair) for pair in ((1, 1), (4, 9), (0.5, 0.5), (2, 2))]
    layers = (capi.TynSlabLayer * 2)(
        capi.TynSlabLayer(sigma_a=numbers[0], sigma_s=numbers[1], g=0.3, ior=1.4, thickness=0.5),
        capi.TynSlabLayer(sigma_a=numbers[2], sigma_s=numbers[3], ior=1.4, thickness=1.0),
    )
    slab = capi.TynSlab(channel_count=2, layer_count=2, layers=layers, ior_below=1.2)
    options = capi.TynSlabOptions(
        photons=50000, seed=seed, radial_max=4.0, radial_bins=8, angular_bins=6, radial_angular=1, depth_max=1.5,
        depth_bins=30, order_bins=20, path_max=10.0, path_bins=5,
    )  # fmt: skip
    result = ctypes.POINTER(capi.TynSlabResult)()
    status = capi.lib.tyn_slab_simulate(context.handle, ctypes.byref(slab), ctypes.byref(options), ctypes.byref(result))
    assert status == capi.TYN_OK
    return result


def test_results_are_the_raw_calls_bit_for_bit(context, resolved):
    result = raw_run(context, 5)
    places = {
        capi.TYN_SLAB_LAYER_ABSORBED: resolved.layer_absorbed,
        capi.TYN_SLAB_RADIAL_REFLECTANCE: resolved.radial.reflectance,
        capi.TYN_SLAB_RADIAL_TRANSMITTANCE: resolved.radial.transmittance,
        capi.TYN_SLAB_ANGULAR_REFLECTANCE: resolved.angular.reflectance,
        capi.TYN_SLAB_ANGULAR_TRANSMITTANCE: resolved.angular.transmittance,
        capi.TYN_SLAB_RADIAL_ANGULAR_REFLECTANCE: resolved.radial_angular.reflectance,
        capi.TYN_SLAB_RADIAL_ANGULAR_TRANSMITTANCE: resolved.radial_angular.transmittance,
        capi.TYN_SLAB_DEPTH_ABSORBED: resolved.depth.absorbed,
        capi.TYN_SLAB_DEPTH_FLUENCE: resolved.depth.fluence,
        capi.TYN_SLAB_ORDER_REFLECTANCE: resolved.orders.reflectance,
        capi.TYN_SLAB_ORDER_TRANSMITTANCE: resolved.orders.transmittance,
        capi.TYN_SLAB_PATH_REFLECTANCE: resolved.path.reflectance,
        capi.TYN_SLAB_PATH_TRANSMITTANCE: resolved.path.transmittance,
    }
    for quantity, found in places.items():
        count = capi.lib.tyn_slab_result_count(result, quantity)
        for channel in range(2):
            values, errors = (ctypes.c_double * count)(), (ctypes.c_double * count)()
            assert capi.lib.tyn_slab_result_read(result, quantity, channel, values, errors, count) == capi.TYN_OK
            np.testing.assert_array_equal(found[..., channel].ravel(), np.array(values))
            np.testing.assert_array_equal(found.stderr[..., channel].ravel(), np.array(errors))
    totals = capi.TynSlabTotals()
    assert capi.lib.tyn_slab_result_totals(result, 1, ctypes.byref(totals)) == capi.TYN_OK
    for found, raw in (
        (resolved.reflectance.total, totals.reflectance),
        (resolved.reflectance.specular, totals.specular_reflectance),
        (resolved.reflectance.diffuse, totals.diffuse_reflectance),
        (resolved.transmittance.total, totals.transmittance),
        (resolved.transmittance.direct, totals.direct_transmittance),
        (resolved.transmittance.diffuse, totals.diffuse_transmittance),
        (resolved.absorbed, totals.absorbed),
        (resolved.cut, totals.cut),
    ):
        assert found[1] == raw.value and found.stderr[1] == raw.standard_error
    run = capi.TynSlabRun()
    assert capi.lib.tyn_slab_result_run(result, ctypes.byref(run)) == capi.TYN_OK
    assert (resolved.run.photons, resolved.run.events, resolved.run.seed) == (run.photons, run.events, run.seed)
    capi.lib.tyn_slab_result_release(result)


def test_limits(context):
    assert context.slab(MEDIUM, photons=np.int64(1000)).run.photons == 1000
    assert context.slab(MEDIUM, photons=2e3).run.photons == 2000
    found = context.slab(MEDIUM, target_error=2e-3)  # no limit of photons then
    assert found.reflectance.total.stderr <= 2e-3
    assert found.run.photons < 10**6
    assert context.slab(MEDIUM, photons=1000, target_error=1e-9).run.photons == 1000
    assert context.slab(MEDIUM, seconds=0.01).run.seconds >= 0.01
    single = context.slab(MEDIUM, photons=1)
    assert np.isnan(single.reflectance.total.stderr)
    assert "± nan" in repr(single)


def test_seeds_are_reproducible(context):
    runs = [context.slab(MEDIUM, photons=1000, seed=seed).reflectance.total for seed in (0, 2**64 - 1, 0)]
    assert runs[0] == runs[2] != runs[1]


def test_results_travel_and_show(resolved):
    again = pickle.loads(pickle.dumps(resolved))
    np.testing.assert_array_equal(again.radial.reflectance.stderr, resolved.radial.reflectance.stderr)
    assert repr(again) == repr(resolved)
    lines = repr(resolved).splitlines()
    assert lines[0].startswith("<tyndall.SlabResult: 50,000 photons a channel, ")
    assert lines[1].split()[0] == "reflectance" and lines[1].count("±") == 2
    assert lines[-1] == "  and radial (8), angular (6), radial_angular (8 x 6), depth (30), orders (20), path (5)>"


def test_units_of_layers_must_agree(context):
    layers = [ty.Layer(ty.Medium(1, 9, metres_per_unit=1e-3), 1), ty.Layer(ty.Medium(1, 9, metres_per_unit=1e-2), 1)]
    with pytest.raises(InvalidArgumentError, match=r"metres_per_unit; theirs are \['0.001', '0.01'\]"):
        context.slab(layers)
    with pytest.raises(InvalidArgumentError, match=r"metres_per_unit is 1\.0"):
        context.slab(MEDIUM, sweep=[ty.Medium(10, 90, g=0.75, metres_per_unit=1)])


def test_progress_is_told_and_cancels(context):
    heard = []
    found = context.slab(MEDIUM, photons=200000, progress=heard.append)
    assert heard and heard == sorted(heard) and 0 < heard[0] and heard[-1] == 1
    assert found.run.photons == 200000
    with pytest.raises(ty.errors.CancelledError) as raised:
        context.slab(MEDIUM, photons=ENDLESS, radial=(1.0, 3), progress=lambda fraction: True)
    done = raised.value.result
    assert isinstance(done, ty.SlabResult)
    assert 0 < done.run.photons < ENDLESS and done.radial.reflectance.shape == (3, 1)
    total = done.reflectance.total + done.transmittance.total + done.absorbed
    assert total == pytest.approx([1], abs=1e-6)


def test_what_progress_raises_is_raised(context):
    def fail(fraction):
        raise KeyError("mine")

    with pytest.raises(KeyError, match="mine"):
        context.slab(MEDIUM, photons=ENDLESS, progress=fail)
    with pytest.raises(ty.errors.InvalidOperationError, match="progress callback"):
        context.slab(MEDIUM, photons=ENDLESS, progress=lambda fraction: context.slab(MEDIUM, photons=10))
    assert context.slab(MEDIUM, photons=100).run.photons == 100


def test_ctrl_c_ends_a_run_and_leaves_the_context_usable(context):
    """The signal of another thread, once the run has begun; and one from within a report, which ends the run at the next."""
    begun = threading.Event()

    def interrupt():
        begun.wait()
        os.kill(os.getpid(), signal.SIGINT)

    thread = threading.Thread(target=interrupt)
    thread.start()
    start = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        context.slab(MEDIUM, photons=ENDLESS, progress=lambda fraction: begun.set())
    assert time.monotonic() - start < 30
    thread.join()
    with pytest.raises(KeyboardInterrupt):
        context.slab(MEDIUM, photons=ENDLESS, progress=lambda fraction: signal.raise_signal(signal.SIGINT))
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
    agrees(context.slab(VAN_DE_HULST, photons=10000).reflectance.total, 0.097395)


def test_results_are_released_at_once(context, monkeypatch):
    release, released = capi.lib.tyn_slab_result_release, []

    def note(pointer):
        released.append(bool(pointer))
        release(pointer)

    monkeypatch.setattr(capi.lib, "tyn_slab_result_release", note)
    context.slab(MEDIUM, photons=100)
    with pytest.raises(ty.errors.CancelledError):
        context.slab(MEDIUM, photons=ENDLESS, progress=lambda fraction: True)
    with pytest.raises(KeyboardInterrupt):
        context.slab(MEDIUM, photons=ENDLESS, progress=lambda fraction: signal.raise_signal(signal.SIGINT))
    assert released == [True, True, True]


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"photons": 0}, "photons, seconds and target_error are all 0"),
        ({"photons": 1.5}, "photons is 1.5; it must be an integer"),
        ({"photons": -1}, "photons is -1"),
        ({"photons": "many"}, "photons is 'many'"),
        ({"photons": np.nan}, "photons is nan"),
        ({"photons": np.inf}, "photons is inf"),
        ({"photons": 1e16}, "photons is 10000000000000000"),
        ({"seed": -1}, "seed is -1"),
        ({"seed": 2**64}, "seed is 18446744073709551616"),
        ({"seconds": -1}, "seconds is -1"),
        ({"target_error": np.nan}, "target_error is nan"),
        ({"incidence": "up"}, 'incidence is \'up\'; it must be one of "collimated", "diffuse"'),
        ({"beam": 0}, '"pencil", "disc", "gaussian"'),
        ({"beam": "disc"}, "beam_radius is 0"),
        ({"angle": 1.6}, "angle is 1.6"),
        ({"angle": [0.1]}, "angle has the shape"),
        ({"ior_above": 0.9}, "ior_above is 0.9"),
        ({"ior_below": "glass"}, "ior_below must be numbers"),
        ({"max_order": 0}, "max_order is 0"),
        ({"roulette_threshold": 2}, "roulette_threshold is 2"),
        ({"radial": 5}, "radial is 5; it must be a pair"),
        ({"radial": (5, 0)}, "the number of bins of radial is 0"),
        ({"radial": (np.inf, 3)}, "radial_max is inf"),
        ({"depth": (0, 3)}, "depth_max is 0"),
        ({"path": ("far", 3)}, "the end of path must be numbers"),
        ({"angular": 2.5}, "angular is 2.5"),
        ({"orders": 10**7}, "orders is 10000000"),
        ({"radial_angular": True}, "radial_angular"),
        ({"radial": (1, 3000), "angular": 3000, "radial_angular": True}, "ask for fewer bins"),
        ({"sweep": []}, "sweep must be"),
        ({"sweep": 3}, "sweep must be"),
        ({"sweep": [ty.Medium(10, 90)]}, "sweep row 0, layer 0: g is 0.0; it must be the slab's, 0.75"),
        ({"sweep": [MEDIUM, ty.Layer(MEDIUM, 5)]}, "sweep row 1, layer 0: thickness is 5"),
        ({"sweep": [[MEDIUM, MEDIUM]]}, "sweep row 0 has 2 layers; the slab has 1"),
        ({"sweep": [ty.Medium([10, 10], 90, g=0.75)]}, "its medium has 2 channels"),
        ({"sweep": ([10], [90, 80])}, "as many rows; they have 1 and 2"),
        ({"sweep": ([[10, 10]], [[90, 90]])}, r"shape \(1, 2\); it must be n x 1"),
        ({"sweep": ([np.nan], [90])}, "sweep_sigma_a is nan"),
        ({"sweep": ([1], [90])}, "at least the slab's own, 100"),
        ({"sweep": [MEDIUM], "max_order": 3}, "max_order 0"),
    ],
)
def test_bad_options_are_named(context, options, message):
    with pytest.raises(InvalidArgumentError, match=message):
        context.slab(MEDIUM, **{"photons": 10, **options})


@pytest.mark.parametrize(
    ("layers", "message"),
    [
        ([], "layers must be"),
        (None, "layers must be"),
        ("glass", "layers must be"),
        ([MEDIUM, 3], "layers must be"),
        (ty.Layer(MEDIUM, 0), r"layers\[0\].thickness is 0"),
        (ty.Layer(MEDIUM, float("nan")), r"layers\[0\].thickness is nan"),
        (ty.Layer(MEDIUM, None), "thickness must be numbers"),
        ([MEDIUM, MEDIUM], r"layers\[0\].thickness is inf"),
        ([ty.Layer(ty.Medium([1, 2], 3), 1), ty.Medium([1, 2, 3], 3)], "1 channel or the same number"),
        (ty.Medium(0, 1), "give it a thickness or more sigma_a, or set max_order"),
    ],
)
def test_bad_layers_are_named(context, layers, message):
    with pytest.raises(InvalidArgumentError, match=message):
        context.slab(layers, photons=10)


def test_a_closed_context_says_so():
    with ty.Context() as one:
        pass
    with pytest.raises(ty.errors.ClosedError):
        one.slab(MEDIUM, photons=10)
    with pytest.raises(TypeError, match="progress is 3"):
        ty.default_context().slab(MEDIUM, photons=10, progress=3)
