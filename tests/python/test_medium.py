# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Media: what they are made from, and what they are described by."""

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


def kulla_conty(color, g):
    s = 4.09712 + 4.20863 * color - np.sqrt(9.59217 + 41.6808 * color + 17.7126 * color**2)
    return (1 - s * s) / (1 - g * s * s)


def test_albedo_and_colour_by_their_formulas():
    color, g = np.array([[0.1], [0.5], [0.9]]), np.array([-0.5, 0.0, 0.8])
    np.testing.assert_allclose(ty.albedo_from_color(color, g), kulla_conty(color, g), rtol=1e-6)
    # by hand: W = 0.75, g = 0, s = 0.5
    assert ty.color_from_albedo(0.75) == pytest.approx(0.5 * 0.9305 / 1.585, rel=1e-6)
    assert type(ty.albedo_from_color(0.5)) is float
    np.testing.assert_array_equal(ty.albedo_from_color([-1, 2]), ty.albedo_from_color([0, 1]))


def test_conversions_are_the_raw_calls():
    for value in (0.0, 0.3, 0.77, 1.0):
        assert ty.albedo_from_color(value, 0.4) == capi.lib.tyn_albedo_from_color(value, 0.4)
        assert ty.color_from_albedo(value, 0.4) == capi.lib.tyn_color_from_albedo(value, 0.4)


@settings(max_examples=30, deadline=None)
@given(
    hnp.arrays(
        st.sampled_from([np.float32, np.float64, np.uint8]), hnp.array_shapes(min_dims=0, min_side=0, max_dims=3),
        elements=st.integers(0, 1),
    ),
    st.data(),
)  # fmt: skip
def test_colours_of_any_shape_stride_and_type(color, data):
    color = color[data.draw(hnp.basic_indices(color.shape))].T
    found = np.asarray(ty.albedo_from_color(color, 0.3))
    assert found.shape == color.shape
    np.testing.assert_allclose(found, kulla_conty(color.astype(np.float64), 0.3), atol=3e-5)


def test_media_by_colour():
    color = np.array([0.2, 0.5, 0.8])
    medium = ty.Medium.from_color(color, 0.25, g=0.5, ior=1.4, name="paint", metres_per_unit=1e-3)
    np.testing.assert_allclose(medium.albedo, kulla_conty(color, 0.5), rtol=1e-6)
    np.testing.assert_allclose(medium.mean_free_path, 0.25, rtol=1e-12)
    assert (medium.g, medium.ior, medium.name, medium.metres_per_unit) == (0.5, 1.4, "paint", 1e-3)
    phase = ty.Phase.two_lobe(0.9, -0.1, 0.6)  # its mean cosine counts: 0.5
    np.testing.assert_allclose(ty.Medium.from_color(color, phase=phase).albedo, medium.albedo, rtol=1e-6)
    assert ty.Medium.from_color(1, 2).sigma_s == pytest.approx([0.5], rel=1e-6)


def test_descriptions_by_their_definitions():
    """sigma_a 2, sigma_s 8, g 0.75 per cm: sigma_t 10, transport 4, effective sqrt(24)."""
    for medium in (ty.Medium(2, 8, g=0.75), ty.Medium(2, 8, phase=ty.Phase.henyey_greenstein(0.75))):
        found = medium.describe(5.0, metres_per_unit=0.01)
        assert found.albedo == pytest.approx([0.8], rel=1e-7)
        assert found.diffuse_albedo == pytest.approx([ty.color_from_albedo(0.8, 0.75)], rel=1e-6)
        assert found.mean_free_path_mm == pytest.approx([1.0])
        assert found.transport_mean_free_path_mm == pytest.approx([2.5])
        assert found.diffusion_length_mm == pytest.approx([10 / np.sqrt(24)])
        assert found.mean_free_path_fraction == pytest.approx([0.02])
        assert found.transport_mean_free_path_fraction == pytest.approx([0.05])
        assert found.diffusion_length_fraction == pytest.approx([0.2 / np.sqrt(24)])


def test_descriptions_of_any_number_of_channels():
    sigma_s = np.array([0.0, 1.0, 3.0, 7.0, 15.0])
    found = ty.Medium([0, 1, 1, 1, 1], sigma_s, metres_per_unit=1e-3).describe()
    np.testing.assert_allclose(found.mean_free_path_mm, [np.inf, 0.5, 0.25, 0.125, 0.0625])
    assert found.albedo[0] == 0 and found.diffusion_length_mm[0] == np.inf


def test_descriptions_are_the_raw_call():
    medium = ty.Medium.preset("skin1")
    raw = capi.TynMediumDescription()
    record = medium.record()
    assert capi.lib.tyn_medium_describe(ctypes.byref(record), 1e-3, 7.0, ctypes.byref(raw)) == capi.TYN_OK
    found = medium.describe(7)
    for name in ("albedo", "diffuse_albedo", "diffusion_length_mm", "transport_mean_free_path_fraction"):
        np.testing.assert_array_equal(getattr(found, name), np.array(getattr(raw, name)))


def test_media_travel():
    medium = ty.Medium([1, 2], [3, 4], phase=ty.Phase.draine(0.1, 1), ior=1.3, name="x", metres_per_unit=1)
    again = pickle.loads(pickle.dumps(medium))
    np.testing.assert_array_equal(again.sigma_s, medium.sigma_s)
    assert again.phase == medium.phase
    assert repr(again) == repr(medium)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: ty.albedo_from_color([0.5, np.nan]), "color is nan"),
        (lambda: ty.albedo_from_color(0.5, 1), r"g is 1; it must be in \(-1, 1\)"),
        (lambda: ty.color_from_albedo(0.5, np.nan), "g is nan"),
        (lambda: ty.color_from_albedo("x"), "albedo must be numbers"),
        (lambda: ty.color_from_albedo([0, 1], [0, 0, 0]), "do not broadcast"),
        (lambda: ty.Medium.from_color(1.5), "color is 1.5"),
        (lambda: ty.Medium.from_color(np.nan), "color is nan"),
        (lambda: ty.Medium.from_color([]), "must be a number or one a channel"),
        (lambda: ty.Medium.from_color(0.5, 0), "mean_free_path"),
        (lambda: ty.Medium.from_color(0.5, g=1), "g is 1"),
        (lambda: ty.Medium(1, 1).describe(), "does not say its unit"),
        (lambda: ty.Medium(1, 1).describe(metres_per_unit=0), "metres_per_unit is 0"),
        (lambda: ty.Medium(1, 1, metres_per_unit=1).describe(metres_per_unit=2), "the medium's own is 1"),
        (lambda: ty.Medium(1, 1, metres_per_unit=1).describe(-1), "reference_length is -1"),
        (lambda: ty.Medium(1, 1, metres_per_unit=1).describe(np.nan), "reference_length is nan"),
        (lambda: ty.Medium(1e39, 1, metres_per_unit=1).describe(), "single precision"),
    ],
)
def test_bad_arguments_are_named(call, message):
    with pytest.raises(InvalidArgumentError, match=message):
        call()


def test_a_medium_never_changes() -> None:
    medium = ty.Medium([1.0, 2.0], 3.0)
    for name, value in (("ior", 3.0), ("sigma_a", np.zeros(2)), ("sigma_t", 1.0), ("sigma", 1.0)):
        with pytest.raises(AttributeError, match=f"never changes.*{name}"):
            setattr(medium, name, value)
    with pytest.raises(ValueError, match="read-only"):
        medium.sigma_a[0] = 5.0
    again = pickle.loads(pickle.dumps(medium))
    assert np.array_equal(again.sigma_a, medium.sigma_a)
    with pytest.raises(AttributeError, match="never changes"):
        again.g = 0.5
