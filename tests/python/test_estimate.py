# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Estimates: values and standard errors stay together, and no error outlives its values."""

import copy
import pickle

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

import tyndall as ty

VALUES = np.array([[1.0, 2.0], [3.0, 4.0], [5.0, 6.0]])
ERRORS = VALUES / 10


@pytest.fixture
def estimate() -> ty.Estimate:
    return ty.Estimate(VALUES, ERRORS)


def same(found, values, errors):
    assert type(found) is ty.Estimate
    np.testing.assert_array_equal(np.array(found), values)
    np.testing.assert_array_equal(found.stderr, errors)
    assert found.shape == found.stderr.shape


@pytest.mark.parametrize(
    "change",
    [
        lambda one: one[1],
        lambda one: one[1, 0],
        lambda one: one[...],
        lambda one: one[::-2, 1:],
        lambda one: one[:, np.newaxis],
        lambda one: one[[2, 0]],
        lambda one: one[VALUES > 2],
        lambda one: one.T,
        lambda one: one.transpose(1, 0),
        lambda one: one.reshape(2, 3),
        lambda one: one.reshape(-1, order="F"),
        lambda one: one.ravel(),
        lambda one: one.flatten("F"),
        lambda one: one[:1].squeeze(),
        lambda one: one.swapaxes(0, 1),
        lambda one: one.take([1, 2], axis=0),
        lambda one: one.repeat(2, axis=1),
        lambda one: one.diagonal(),
        lambda one: one.compress([True, False, True], axis=0),
        lambda one: one.copy(),
        lambda one: np.moveaxis(one, 0, 1),
        lambda one: np.reshape(one, 6),
        lambda one: np.expand_dims(one, 0),
        lambda one: one[()][0][1],
    ],
)
def test_what_moves_values_moves_errors_with_them(estimate, change):
    same(change(estimate), change(VALUES), change(ERRORS))


@pytest.mark.parametrize(
    "again",
    [copy.copy, copy.deepcopy, *(lambda one, p=p: pickle.loads(pickle.dumps(one, p)) for p in range(2, 6))],
)
def test_copies_and_pickles_keep_errors(estimate, again):
    same(again(estimate), VALUES, ERRORS)
    same(again(estimate[1:, 1]), VALUES[1:, 1], ERRORS[1:, 1])
    same(again(estimate[1, 1]), VALUES[1, 1], ERRORS[1, 1])


@pytest.mark.parametrize(
    "calculate",
    [
        lambda one: one + 1,
        lambda one: 1 - one,
        lambda one: one * one,
        lambda one: VALUES / one,
        lambda one: -one,
        lambda one: one > 2,
        lambda one: one == one,
        np.sqrt,
        lambda one: one @ VALUES.T,
        lambda one: one.sum(),
        lambda one: one.sum(axis=0),
        lambda one: one.mean(axis=1),
        lambda one: one.std(axis=1),
        lambda one: one.max(axis=0),
        lambda one: one.argmax(axis=0),
        lambda one: one.argsort(axis=0),
        lambda one: one.cumsum(),
        lambda one: one.round(1),
        lambda one: one.clip(2, 3),
        lambda one: one.dot(VALUES.T),
        lambda one: one.astype(np.float32),
        lambda one: one[0, 0] * 2,
        lambda one: np.add(one, 1, where=one > 2, out=np.zeros_like(VALUES)),
        lambda one: np.sum(one, axis=1),
        lambda one: np.sort(one, axis=1),
        lambda one: np.concatenate([one, one]),
        lambda one: np.where(one > 2, one, 0),
        lambda one: np.trapezoid(one[:, 0]) if hasattr(np, "trapezoid") else np.trapz(one[:, 0]),
        lambda one: np.interp(2.5, [1, 2, 3], one[:, 0]),
        np.array,
        np.asarray,
    ],
)
def test_what_is_calculated_is_plain(estimate, calculate):
    found = calculate(estimate)
    assert not isinstance(found, ty.Estimate)
    np.testing.assert_array_equal(found, calculate(VALUES))


def test_a_single_value_is_a_number(estimate):
    one = estimate[1, 0]
    assert float(one) == 3
    assert float(one.stderr) == 3 / 10
    assert f"{one:.2f}" == "3.00"
    assert one > 2.5
    assert [float(each) for each in estimate[:, 1]] == [2, 4, 6]


def test_errors_that_are_lost_say_so(estimate):
    for lost in (estimate.view(), estimate.view(np.int64)):
        with pytest.raises(AttributeError, match="does not keep standard errors"):
            _ = lost.stderr
    assert type(copy.copy(estimate.view())) is np.ndarray
    assert repr(estimate.view()) == repr(VALUES)


def test_values_and_errors_are_read_only(estimate):
    with pytest.raises(ValueError, match="read-only"):
        estimate[0] = 1
    with pytest.raises(ValueError, match="read-only"):
        estimate += 1
    with pytest.raises(ValueError, match="read-only"):
        estimate.stderr[0] = 1
    with pytest.raises(ValueError, match="read-only"):
        estimate.sort()
    writable = np.array(estimate)
    writable[0] = 9
    assert estimate[0, 0] == 1


def test_it_owns_its_memory():
    values, errors = VALUES.copy(), ERRORS.copy()
    one = ty.Estimate(values, errors)
    values[:] = errors[:] = 7
    same(one, VALUES, ERRORS)
    assert one.flags.owndata


def test_repr_shows_both(estimate):
    assert repr(estimate[0]) == "Estimate([1., 2.], stderr=[0.1, 0.2])"
    assert repr(estimate[0, 1]) == "Estimate(2., stderr=0.2)"
    assert repr(estimate).splitlines()[3] == "         stderr=[[0.1, 0.2],"


def test_shapes_must_agree():
    with pytest.raises(ty.errors.InvalidArgumentError, match=r"\(2,\) and stderr \(3,\)"):
        ty.Estimate([1, 2], [1, 2, 3])


@settings(max_examples=40, deadline=None)
@given(hnp.arrays(np.float64, hnp.array_shapes(min_dims=0, min_side=0, max_dims=3), elements=st.floats(-9, 9)), st.data())
def test_any_basic_index_of_any_shape(values, data):
    index = data.draw(hnp.basic_indices(values.shape, allow_newaxis=True))
    same(ty.Estimate(values, 2 * values)[index], values[index], 2 * values[index])


def test_what_goes_into_an_array_of_the_caller_is_values(estimate):
    room = np.empty((2, 2))
    for call in (
        lambda: estimate.take([0, 2], 0, room),
        lambda: estimate.take([0, 2], axis=0, out=room),
        lambda: estimate.compress([True, False, True], 0, room),
        lambda: estimate.compress([True, False, True], axis=0, out=room),
    ):
        room[...] = 0
        assert call() is room
        np.testing.assert_array_equal(room, VALUES[[0, 2]])
    same(estimate.take([0, 2], 0, None, "clip"), VALUES[[0, 2]], ERRORS[[0, 2]])
    same(estimate.reshape(1, 3, 2), VALUES[None], ERRORS[None])
