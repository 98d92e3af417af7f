# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Phase functions against their formulas."""

import copy
import ctypes
import pickle

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

import tyndall as ty
from tyndall import capi

InvalidArgumentError = ty.errors.InvalidArgumentError


def henyey_greenstein(g, cosines):
    return (1 - g * g) / (4 * np.pi * (1 + g * g - 2 * g * cosines) ** 1.5)


X = np.linspace(-1, 1, 41)
FORMULAS = [
    (ty.Phase.isotropic(), np.full(41, 1 / (4 * np.pi)), 0),
    (ty.Phase.rayleigh(), 3 / (16 * np.pi) * (1 + X**2), 0),
    (ty.Phase.henyey_greenstein(0.7), henyey_greenstein(0.7, X), 0.7),
    (ty.Phase.two_lobe(0.8, -0.3, 0.9), 0.9 * henyey_greenstein(0.8, X) + 0.1 * henyey_greenstein(-0.3, X), 0.69),
    (
        ty.Phase.draine(0.4, 0.5),
        henyey_greenstein(0.4, X) * (1 + 0.5 * X**2) / (1 + 0.5 * (1 + 2 * 0.4**2) / 3),
        0.4 * (1 + 0.5 * (3 + 2 * 0.4**2) / 5) / (1 + 0.5 * (1 + 2 * 0.4**2) / 3),  # Draine 2003, eq. 5
    ),
    (ty.Phase.tabulated([-1, 1], [0, 7]), (1 + X) / (4 * np.pi), 1 / 3),
]
NAMES = [phase.name for phase, _, _ in FORMULAS]


@pytest.mark.parametrize(("phase", "expected", "mean"), FORMULAS, ids=NAMES)
def test_values_are_those_of_the_formulas(phase, expected, mean):
    np.testing.assert_allclose(phase.value(X), expected, rtol=1e-12)
    np.testing.assert_allclose(phase.pdf(X), 2 * np.pi * expected, rtol=1e-12)
    assert phase.mean_cosine == pytest.approx(mean, abs=1e-12)


@pytest.mark.parametrize("phase", [row[0] for row in FORMULAS], ids=NAMES)
def test_moments_are_integrals_of_legendre_polynomials(phase):
    nodes, weights = np.polynomial.legendre.leggauss(128)
    polynomials = np.polynomial.legendre.legvander(nodes, 5)
    np.testing.assert_allclose(phase.moments(6), (weights * phase.pdf(nodes)) @ polynomials, atol=1e-7)
    assert phase.moments(0).shape == (0,)


@pytest.mark.parametrize("phase", [row[0] for row in FORMULAS], ids=NAMES)
def test_samples_follow_the_pdf(phase):
    """Means of cos and cos^2 within 5 standard errors."""
    drawn = phase.sample(20000, seed=3)
    first, second = phase.moments(3)[1:]
    for power, exact in ((1, first), (2, (1 + 2 * second) / 3)):
        powers = drawn**power
        assert abs(powers.mean() - exact) < 5 * powers.std() / np.sqrt(len(drawn))


def test_samples_depend_on_seed_and_number_alone():
    phase = ty.Phase.henyey_greenstein(0.5)
    whole = phase.sample(100, seed=2**64 - 1, first=7)
    np.testing.assert_array_equal(phase.sample(40, seed=2**64 - 1, first=67), whole[60:])
    assert np.any(phase.sample(100, seed=1, first=7) != whole)
    assert phase.sample(0).shape == (0,)
    assert phase.sample(1e2).shape == (100,)


def test_calls_are_the_raw_ones():
    phase = ty.Phase.draine(0.3, 2.0)
    cosines = np.linspace(-1, 1, 7)
    raw = np.empty(7)
    pointer = ctypes.POINTER(ctypes.c_double)
    record = capi.TynPhase(kind=capi.TYN_PHASE_DRAINE, g=0.3, alpha=2.0)
    found = capi.lib.tyn_phase_value(ctypes.byref(record), cosines.ctypes.data_as(pointer), 7, raw.ctypes.data_as(pointer))
    assert found == capi.TYN_OK
    np.testing.assert_array_equal(phase.value(cosines), raw)
    assert capi.lib.tyn_phase_sample(ctypes.byref(record), 5, 6, 7, raw.ctypes.data_as(pointer)) == capi.TYN_OK
    np.testing.assert_array_equal(phase.sample(7, seed=5, first=6), raw)


@settings(max_examples=30, deadline=None)
@given(
    hnp.arrays(
        st.sampled_from([np.float32, np.float64, np.int8]), hnp.array_shapes(min_dims=0, min_side=0, max_dims=3),
        elements=st.integers(-1, 1),
    ),
    st.data(),
)  # fmt: skip
def test_cosines_of_any_shape_stride_and_type(cosines, data):
    cosines = cosines[data.draw(hnp.basic_indices(cosines.shape))].T
    found = np.asarray(ty.Phase.henyey_greenstein(0.5).value(cosines))
    assert found.shape == cosines.shape
    np.testing.assert_allclose(found, henyey_greenstein(0.5, cosines.astype(np.float64)), rtol=1e-12)


def test_one_cosine_gives_a_float():
    assert type(ty.Phase.isotropic().value(0.5)) is float


def test_phase_functions_compare_and_travel():
    tables = [ty.Phase.tabulated([-1, 0, 1], [1, 2, 3]), ty.Phase.tabulated([-1, 0, 1], [1, 2, 4])]
    phases = [phase for phase, _, _ in FORMULAS] + tables
    for index, phase in enumerate(phases):
        for again in (pickle.loads(pickle.dumps(phase)), copy.deepcopy(phase)):
            assert again == phase and hash(again) == hash(phase)
            np.testing.assert_array_equal(again.value(X), phase.value(X))
        assert all((phase == other) == (index == place) for place, other in enumerate(phases))
    assert phases[0] != "isotropic"


def test_spheres_have_the_mean_cosine_of_mie():
    # Bohren & Huffman's sphere, summed in 40 digits by an independent program
    assert ty.Phase.mie(5.213, 1.55).mean_cosine == pytest.approx(0.6331044159946938, abs=1e-6)
    assert ty.Phase.mie(100, 1.33 + 1e-5j, count=4001).mean_cosine == pytest.approx(0.8689592720023575, abs=1e-6)
    # as many alike are as one
    one = ty.Phase.mie(2 * np.pi * 0.5 / 0.6, 1.33)
    assert ty.Phase.mie_lognormal(0.5, 1.0, 0.6, 1.33) == one
    wide = ty.mie_lognormal(0.1, 1.3, 0.6, 1.33)
    assert ty.Phase.mie_lognormal(0.1, 1.3, 0.6, 1.33).mean_cosine == pytest.approx(wide.mean_cosine, abs=1e-5)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda p: p.value([0, 1.5]), r"cosines is 1.5; it must be in \[-1, 1\]"),
        (lambda p: p.pdf([0, np.nan]), "cosines is nan"),
        (lambda p: p.value("x"), "cosines must be numbers"),
        (lambda p: p.value(None), "cosines must be numbers"),
        (lambda p: p.sample(-1), "count is -1"),
        (lambda p: p.sample(2.5), "count is 2.5"),
        (lambda p: p.sample("3"), "count is '3'"),
        (lambda p: p.sample(3, seed=2**64), "seed is 18446744073709551616"),
        (lambda p: p.sample(3, first=-1), "first is -1"),
        (lambda p: p.moments(-1), "count is -1"),
        (lambda p: p.mie(0, 1.5), "size_parameter is 0"),
        (lambda p: p.mie(1, 1.5, count=1), "count is 1"),
        (lambda p: p.mie_lognormal(1, 6, 1, 1.5), "geometric_deviation is 6"),
        (lambda p: p.henyey_greenstein(1), "not a phase function"),
        (lambda p: p.tabulated([-1, 1], [0, 0]), "not a phase function"),
        (lambda p: p.tabulated([-1, 1], [1, 2, 3]), "values has the shape"),
    ],
)
def test_bad_arguments_are_named(call, message):
    with pytest.raises(InvalidArgumentError, match=message):
        call(ty.Phase.isotropic())
