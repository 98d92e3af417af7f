# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Scattering by spheres against published values, sums in 40 digits of an independent program (mpmath), and limits."""

import ctypes

import numpy as np
import pytest

import tyndall as ty
from tyndall import capi

InvalidArgumentError = ty.errors.InvalidArgumentError


def test_bohren_and_huffmans_example():
    """Bohren & Huffman 1983, appendix A."""
    found = ty.mie(2 * np.pi * 0.525 / 0.6328, 1.55)
    assert found.q_ext == pytest.approx(3.10543, abs=5e-6)
    assert found.q_sca == pytest.approx(3.10543, abs=5e-6)
    assert found.q_back == pytest.approx(2.92534, abs=5e-6)
    assert found.q_abs == 0
    assert found.cosines is None and found.values is None


def test_an_absorbing_sphere():
    """Of 40 digits: the imaginary part of the index absorbs."""
    cosines = [[-1, -0.5, 0], [0.5, 0.9, 1]]
    found = ty.mie(10, 1.5 + 1j, cosines)
    assert found.q_ext == pytest.approx(2.417294528490904, rel=1e-9)
    assert found.q_sca == pytest.approx(1.346957826094464, rel=1e-9)
    assert found.q_abs == pytest.approx(2.417294528490904 - 1.346957826094464, rel=1e-9)
    assert found.q_back == pytest.approx(0.1729262018798157, rel=1e-9)
    assert found.mean_cosine == pytest.approx(0.8346946423125499, rel=1e-9)
    expected = [
        [0.01021637770912269, 0.01009234035529485, 0.01213529894521624],
        [0.01819423131491477, 0.1482027710001579, 8.767915378074179],
    ]
    np.testing.assert_allclose(found.values, expected, rtol=1e-9)
    np.testing.assert_array_equal(found.cosines, cosines)


def test_calls_are_the_raw_ones():
    index = (ctypes.c_double * 2)(1.4, 0.01)
    record, cosines, values = capi.TynMie(), (ctypes.c_double * 2)(0.25, 0.5), (ctypes.c_double * 2)()
    assert capi.lib.tyn_mie(3.5, index, ctypes.byref(record), cosines, 2, values) == capi.TYN_OK
    found = ty.mie(3.5, 1.4 + 0.01j, np.array([0.5, 0.25])[::-1])
    assert (found.q_ext, found.q_sca, found.q_abs, found.q_back, found.mean_cosine) == (
        record.q_ext, record.q_sca, record.q_abs, record.q_back, record.mean_cosine,
    )  # fmt: skip
    np.testing.assert_array_equal(found.values, np.array(values))

    given = capi.TynMieDistribution(median_radius=0.1, geometric_deviation=1.2, wavelength=0.5, relative_index=index)
    means = capi.TynMieCrossSections()
    status = capi.lib.tyn_mie_lognormal(ctypes.byref(given), ctypes.byref(means), cosines, 2, values)
    assert status == capi.TYN_OK
    spheres = ty.mie_lognormal(0.1, 1.2, 0.5, 1.4 + 0.01j, [0.25, 0.5])
    assert (spheres.extinction, spheres.scattering, spheres.absorption, spheres.mean_cosine) == (
        means.extinction, means.scattering, means.absorption, means.mean_cosine,
    )  # fmt: skip
    np.testing.assert_array_equal(spheres.values, np.array(values))


def test_small_spheres_follow_rayleigh():
    """Their radius to the sixth: the mean over a log-normal distribution is median^6 exp(18 log(deviation)^2)."""
    one = ty.rayleigh_cross_section(1e-3, 0.6, 1.33)
    spheres = ty.mie_lognormal(1e-3, 1.2, 0.6, 1.33)
    assert spheres.scattering == pytest.approx(one * np.exp(18 * np.log(1.2) ** 2), rel=2e-3)
    assert spheres.values is None
    efficiency = ty.mie(2 * np.pi * 1e-3 / 0.6, 1.33).q_sca
    assert efficiency * np.pi * 1e-6 == pytest.approx(one, rel=2e-4)


def test_rayleigh_by_its_formula():
    radii, waves = np.array([[0.01], [0.02]]), np.array([0.4, 0.5, 0.8])
    m = 1.5 + 0.2j
    factor = abs((m**2 - 1) / (m**2 + 2)) ** 2
    expected = 8 * np.pi / 3 * (2 * np.pi / waves) ** 4 * radii**6 * factor
    np.testing.assert_allclose(ty.rayleigh_cross_section(radii, waves, m), expected, rtol=1e-12)
    assert ty.rayleigh_cross_section(0, 1, m) == 0
    assert type(ty.rayleigh_cross_section(1, 1, m)) is float
    assert ty.rayleigh_cross_section(np.empty((0, 1)), waves, m).shape == (0, 3)


def test_cosines_of_tables():
    found = ty.mie_cosines(100, 1001)
    assert found[0] == -1 and found[-1] == 1 and np.all(np.diff(found) > 0)
    assert np.sum(np.arccos(found) < 0.05) > 150  # the peak's five widths get more than their share


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: ty.mie(-1, 1.5), r"size_parameter is -1; it must be in \(0, 100000\]"),
        (lambda: ty.mie(np.nan, 1.5), "size_parameter is nan"),
        (lambda: ty.mie([1, 2], 1.5), "size_parameter has the shape"),
        (lambda: ty.mie(1, 1.5 - 0.1j), r"relative_index is \(1.5-0.1j\); it must be n \+ ik"),
        (lambda: ty.mie(1, 0), "relative_index is 0j"),
        (lambda: ty.mie(1, 2000), "relative_index"),
        (lambda: ty.mie(1, complex(1, np.nan)), "relative_index"),
        (lambda: ty.mie(1, "a"), "relative_index is 'a'"),
        (lambda: ty.mie(1, (1.5, 0)), "relative_index"),
        (lambda: ty.mie(1, 1.5, 2), "cosines is 2"),
        (lambda: ty.mie_lognormal(0, 1, 1, 1.5), "median_radius is 0"),
        (lambda: ty.mie_lognormal(1, 0.9, 1, 1.5), "geometric_deviation is 0.9"),
        (lambda: ty.mie_lognormal(1, 1, np.inf, 1.5), "wavelength is inf"),
        (lambda: ty.mie_lognormal(1e4, 3, 1, 1.5), "size parameters above 100000"),
        (lambda: ty.mie_cosines(1, 1), "count is 1"),
        (lambda: ty.mie_cosines(1, 65537), "count is 65537"),
        (lambda: ty.rayleigh_cross_section(-1, 1, 1.5), "radius is -1"),
        (lambda: ty.rayleigh_cross_section(1, 0, 1.5), "wavelength is 0"),
        (lambda: ty.rayleigh_cross_section([1, 2], [1, 2, 3], 1.5), "do not broadcast"),
        (lambda: ty.rayleigh_cross_section(1e200, 1, 1.5), "not finite"),
    ],
)
def test_bad_arguments_are_named(call, message):
    with pytest.raises(InvalidArgumentError, match=message):
        call()
