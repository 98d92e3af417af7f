# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Exact transport against published values and closed forms."""

import ctypes

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

import tyndall as ty
from tyndall import capi, exact

InvalidArgumentError = ty.errors.InvalidArgumentError
VAN_DE_HULST = ty.Layer(ty.Medium(10, 90, g=0.75), thickness=0.02)
GIOVANELLI = ty.Medium(1, 9, ior=1.5)


def test_reduced_intensity_is_beers_law():
    tau, mu = np.array([[0.0], [0.5], [np.inf]]), np.array([0.1, 1.0])
    np.testing.assert_allclose(exact.reduced_intensity(tau, mu), np.exp(-tau / mu), rtol=1e-15)
    assert type(exact.reduced_intensity(1, 1)) is float


def test_effective_source_and_seeligers_law():
    assert exact.effective_source(0.5, 0.1, 2, 0.5) == pytest.approx(0.05 * np.exp(-4), rel=1e-15)
    np.testing.assert_allclose(exact.seeliger_brdf(0.8, 0.25, [0.5, 1], 0.3), 0.2 / (np.array([0.5, 1]) + 0.3), rtol=1e-15)


def test_an_index_matched_half_space_of_hanrahan_and_krueger_is_seeligers():
    phase = ty.Phase.henyey_greenstein(0.6)
    azimuth = np.array([0.0, 1.0, np.pi])
    cosine = -np.sqrt(0.75) * 0.6 * np.cos(azimuth) - 0.5 * 0.8
    found = exact.hanrahan_krueger(0.8, 0.5, 0.8, azimuth, phase=phase)
    np.testing.assert_allclose(found.brdf, exact.seeliger_brdf(0.8, phase.value(cosine), 0.5, 0.8), rtol=1e-12)
    np.testing.assert_array_equal(found.btdf, 0)


def test_a_thin_layer_of_hanrahan_and_krueger():
    """W p tau / (mu_i mu_o), both ways, in the limit; interfaces at perpendicular incidence pass 0.96 each way, and radiance
    falls by ior^2."""
    w, tau = np.array([0.2, 0.9]), 1e-6
    thin = w / (4 * np.pi) * tau / (0.5 * 0.25)
    found = exact.hanrahan_krueger(w, 0.5, 0.25, optical_thickness=tau)
    np.testing.assert_allclose(found.brdf, thin, rtol=1e-5)
    np.testing.assert_allclose(found.btdf, thin, rtol=1e-5)
    glass = exact.hanrahan_krueger(1, 1, 1, ior=1.5)
    assert type(glass.brdf) is float
    assert glass.brdf == pytest.approx(0.96**2 / 1.5**2 / (4 * np.pi) / 2, rel=1e-12)


def test_chandrasekhars_table():
    """Chandrasekhar 1950, table XI."""
    found = exact.chandrasekhar_h(1, [[0.1, 0.2], [0.5, 1.0]])
    np.testing.assert_allclose(found, [[1.24735, 1.45035], [2.01278, 2.90781]], atol=5e-6)
    assert exact.chandrasekhar_h(1, 0) == 1
    assert exact.chandrasekhar_h(0, 0.7) == 1


@pytest.mark.parametrize("albedo", [0.1, 0.9, 1.0])
def test_h_has_its_moment_and_the_brdf_its_albedo(albedo):
    """int H = 2 / (1 + sqrt(1 - W)) (Chandrasekhar 1950, chapter V); the albedo is the BRDF's integral."""
    nodes, weights = np.polynomial.legendre.leggauss(40)
    x, w = (nodes + 1) ** 2 / 4, weights * (nodes + 1) / 2  # denser at 0, where H is steep
    assert w @ exact.chandrasekhar_h(albedo, x) == pytest.approx(2 / (1 + np.sqrt(1 - albedo)), abs=1e-7)
    mu = np.array([0.05, 0.4, 1.0])
    brdf = exact.half_space_brdf(albedo, mu[:, None], x)
    np.testing.assert_allclose(exact.half_space_albedo(albedo, mu), 2 * np.pi * brdf @ (w * x), atol=1e-7)


def test_albedos_and_cosines_broadcast():
    w, mu_i, mu_o = np.array([[[0.5]], [[0.9]]]), np.array([[0.2], [0.6], [1.0]]), np.array([0.1, 0.2, 0.6, 0.7])
    brdf = exact.half_space_brdf(w, mu_i, mu_o)
    h = exact.chandrasekhar_h(w, np.array([0.1, 0.2, 0.6, 0.7, 1.0]))
    assert brdf.shape == (2, 3, 4) and h.shape == (2, 1, 5)
    h_i, h_o = h[:, 0, [1, 2, 4]][:, :, None], h[:, :, :4]
    np.testing.assert_allclose(brdf, w / (4 * np.pi) * h_i * h_o / (mu_i + mu_o), rtol=1e-12)
    viewer, raw = (ctypes.c_double * 1)(0.7), (ctypes.c_double * 1)()
    assert capi.lib.tyn_half_space_brdf(0.9, 0.6, viewer, 1, raw) == capi.TYN_OK
    assert brdf[1, 1, 3] == raw[0]


def test_van_de_hulsts_slab():
    """van de Hulst 1980."""
    found = ty.adding_doubling([VAN_DE_HULST])
    assert found.reflectance == pytest.approx([0.09739], abs=1e-5)
    assert found.transmittance == pytest.approx([0.66096], abs=1e-5)
    assert found.absorbed == pytest.approx([1 - 0.09739 - 0.66096], abs=1e-5)
    assert found.direct_transmittance == pytest.approx([np.exp(-2)], rel=1e-12)
    assert found.specular_reflectance == 0
    assert found.accuracy < 1e-6 and found.nodes >= 8
    assert found.cosines is None and found.reflected is None and found.transmitted is None


def test_giovanellis_half_space():
    """Giovanelli 1955; the digits beyond his from an independent solver."""
    assert ty.adding_doubling(GIOVANELLI).reflectance == pytest.approx([0.259919], abs=1e-6)
    assert ty.adding_doubling(GIOVANELLI).specular_reflectance == pytest.approx([0.04], abs=1e-12)
    assert ty.adding_doubling(GIOVANELLI, incidence="diffuse").reflectance == pytest.approx([0.307890], abs=1e-6)


def test_channels_and_cosines():
    """The isotropic half-space is Chandrasekhar's."""
    albedos, mu = np.array([0.3, 0.9, 0.999]), np.array([0.05, 0.5, 1.0, 0.8])
    found = ty.adding_doubling(ty.Medium.from_albedo(albedos), angle=1.0, cosines=mu)
    np.testing.assert_allclose(found.reflectance, exact.half_space_albedo(albedos, np.cos(1.0)), atol=1e-6)
    np.testing.assert_allclose(
        found.reflected, mu[:, None] * exact.half_space_brdf(albedos, np.cos(1.0), mu[:, None]), atol=1e-6
    )
    np.testing.assert_array_equal(found.transmitted, np.zeros((4, 3)))
    np.testing.assert_array_equal(found.cosines, mu)


def test_adding_doubling_is_the_raw_call():
    layers = [ty.Layer(ty.Medium(1, [4, 9], g=0.3, ior=1.4), 0.5), ty.Layer(ty.Medium(0.1, 2, phase=ty.Phase.rayleigh()), 1)]
    found = ty.adding_doubling(layers, ior_below=1.2, angle=0.4, tolerance=1e-4, max_nodes=64, cosines=[0.2, 1])
    values = [(ctypes.c_double * 1)(number) for number in (1, 9, 0.1, 2)]
    rayleigh = capi.TynPhase(kind=capi.TYN_PHASE_RAYLEIGH)
    records = (capi.TynSlabLayer * 2)(
        capi.TynSlabLayer(sigma_a=values[0], sigma_s=values[1], g=0.3, ior=1.4, thickness=0.5),
        capi.TynSlabLayer(sigma_a=values[2], sigma_s=values[3], phase=ctypes.pointer(rayleigh), thickness=1.0),
    )
    slab = capi.TynSlab(layer_count=2, layers=records, ior_below=1.2)
    cosines, back, through = (ctypes.c_double * 2)(0.2, 1), (ctypes.c_double * 2)(), (ctypes.c_double * 2)()
    options = capi.TynAddingDoublingOptions(angle=0.4, tolerance=1e-4, max_nodes=64, cosines=cosines, cosine_count=2)
    result = capi.TynAddingDoublingResult()
    status = capi.lib.tyn_adding_doubling(
        ctypes.byref(slab), ctypes.byref(options), ctypes.byref(result), back, through, None, 0
    )
    assert status == capi.TYN_OK
    for name in (
        "reflectance",
        "transmittance",
        "absorbed",
        "specular_reflectance",
        "direct_transmittance",
        "accuracy",
        "nodes",
    ):
        assert getattr(found, name)[1] == getattr(result, name)
    np.testing.assert_array_equal(found.reflected[:, 1], np.array(back))
    np.testing.assert_array_equal(found.transmitted[:, 1], np.array(through))


@settings(max_examples=30, deadline=None)
@given(
    hnp.arrays(
        st.sampled_from([np.float32, np.float64]), hnp.array_shapes(min_dims=0, min_side=0, max_dims=3),
        elements=st.floats(0.0625, 1, width=32),
    ),
    st.data(),
)  # fmt: skip
def test_arrays_of_any_shape_stride_and_type(mu, data):
    mu = mu[data.draw(hnp.basic_indices(mu.shape))].T
    exponential = np.asarray(exact.reduced_intensity(1, mu))
    assert exponential.shape == mu.shape
    np.testing.assert_allclose(exponential, np.exp(-1 / mu.astype(np.float64)), rtol=1e-14)
    # the albedo is the closed form of H
    found = np.asarray(exact.half_space_albedo(0.75, mu))
    np.testing.assert_allclose(found, 1 - np.asarray(exact.chandrasekhar_h(0.75, mu)) / 2, rtol=1e-14)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: exact.reduced_intensity([1, -1], 0.5), "tau is -1, mu is 0.5: tau must be >= 0"),
        (lambda: exact.reduced_intensity(1, np.nan), "mu is nan"),
        (lambda: exact.reduced_intensity("x", 1), "tau must be numbers"),
        (lambda: exact.reduced_intensity([1, 2], [1, 1, 1]), "do not broadcast"),
        (lambda: exact.effective_source(2, 1, 1, 1), "albedo is 2"),
        (lambda: exact.seeliger_brdf(0.5, 0.1, 0, 1), "mu_i is 0"),
        (lambda: exact.hanrahan_krueger(0.5, 1.5, 1), r"mu_i is 1.5; it must be in \(0, 1\]"),
        (lambda: exact.hanrahan_krueger(0.5, 1, 1, np.inf), "azimuth is inf"),
        (lambda: exact.hanrahan_krueger(0.5, 1, 1, optical_thickness=0), "optical_thickness is 0"),
        (lambda: exact.hanrahan_krueger(0.5, 1, 1, ior=5), "ior is 5"),
        (lambda: exact.chandrasekhar_h(-0.1, 1), "albedo is -0.1"),
        (lambda: exact.chandrasekhar_h(0.5, [0, 1.1]), "mu is 1.1"),
        (lambda: exact.half_space_brdf(0.5, 0, 1), "mu_i is 0"),
        (lambda: exact.half_space_brdf(0.5, 1, np.nan), "mu_o is nan"),
        (lambda: exact.half_space_albedo(0.5, 0), "mu is 0"),
        (lambda: ty.adding_doubling([]), "layers must be"),
        (lambda: ty.adding_doubling([ty.Layer(GIOVANELLI, -1)]), "thickness is -1"),
        (lambda: ty.adding_doubling(GIOVANELLI, incidence="up"), '"collimated", "diffuse"'),
        (lambda: ty.adding_doubling(GIOVANELLI, angle=2), r"angle is 2; it must be in \[0, pi/2\)"),
        (lambda: ty.adding_doubling(GIOVANELLI, tolerance=1), "tolerance is 1"),
        (lambda: ty.adding_doubling(GIOVANELLI, max_nodes=7), "max_nodes is 7"),
        (lambda: ty.adding_doubling(GIOVANELLI, ior_above=0.5), "ior_above is 0.5"),
        (lambda: ty.adding_doubling(GIOVANELLI, ior_above=None), "ior_above must be numbers"),
        (lambda: ty.adding_doubling(GIOVANELLI, cosines=[0.5, 0]), r"cosines\[1\] is 0"),
        (lambda: ty.adding_doubling(GIOVANELLI, cosines=0.5), "cosines has the shape"),
    ],
)
def test_bad_arguments_are_named(call, message):
    with pytest.raises(InvalidArgumentError, match=message):
        call()
