# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Ray queries against closed forms: a box, a plane, a sphere."""

import ctypes
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import tyndall as ty
from tyndall import capi
from tyndall.errors import InvalidArgumentError, InvalidOperationError


@pytest.fixture(scope="module")
def scene(context: ty.Context) -> Iterator[ty.Scene]:
    """A box of 1 x 2 x 3 around the origin, and a fine sphere of radius 1 around (10, 0, 0)."""
    with context.scene() as one:
        one.add_mesh(*ty.shapes.box((1, 2, 3)))
        positions, triangles = ty.shapes.sphere(1.0, 5)
        one.add_mesh(positions + np.float32([10, 0, 0]), triangles)
        one.commit()
        yield one


def random_rays(count: int, seed: int) -> Any:
    """From a sphere around the box towards points near it; with the directions' lengths 1 in float32."""
    generator = np.random.default_rng(seed)
    origin = generator.normal(size=(count, 3))
    origin *= 4 / np.linalg.norm(origin, axis=1, keepdims=True)
    direction = generator.uniform(-1.2, 1.2, (count, 3)) - origin
    direction /= np.linalg.norm(direction, axis=1, keepdims=True)
    return origin.astype(np.float32), direction.astype(np.float32)


def slabs(origin: Any, direction: Any, half: Any) -> Any:
    """Where rays enter a box and leave it (enter > leave: a miss), and the axis of the side they enter by (Kay & Kajiya
    1986)."""
    with np.errstate(divide="ignore"):
        ends = (np.array([[[-1]], [[1]]]) * half - origin.astype(np.float64)) / direction
    near = ends.min(axis=0)
    return near.max(axis=1), ends.max(axis=0).min(axis=1), near.argmax(axis=1)


def test_hits_of_a_box(context: ty.Context, scene: ty.Scene) -> None:
    origin, direction = random_rays(3000, 1)
    half = np.array([0.5, 1, 1.5])
    enter, leave, axis = slabs(origin, direction, half)
    clear = np.abs(enter - leave) > 1e-4  # apart from rays along an edge
    hits = context.intersect(scene, origin, direction, mesh=0)
    assert hits.dtype == ty.HIT and hits.shape == (3000,)
    hit = hits["mesh"] == 0
    assert 200 < np.count_nonzero(~hit) < 2800
    assert np.array_equal(hit[clear], (enter <= leave)[clear])
    assert np.allclose(hits["t"][hit], enter[hit], atol=1e-5)
    missed = hits[~hit]
    assert np.all(np.isinf(missed["t"])) and np.all(missed["mesh"] == ty.NONE) and np.all(missed["triangle"] == ty.NONE)
    sure = hit & clear & (np.sort(slabs_near(origin, direction, half))[:, 1] < enter - 1e-4)
    outwards = np.zeros((3000, 3))
    outwards[np.arange(3000), axis] = -np.sign(direction[np.arange(3000), axis])
    assert np.array_equal(hits["normal"][sure], outwards[sure])
    assert np.array_equal(context.occluded(scene, origin, direction, mesh=0), hit)


def slabs_near(origin: Any, direction: Any, half: Any) -> Any:
    with np.errstate(divide="ignore"):
        return ((-np.sign(direction) * half - origin) / direction).astype(np.float64)


def test_hits_of_a_sphere_lie_between_those_of_two(context: ty.Context, scene: ty.Scene) -> None:
    """The mesh is inscribed in the unit sphere, and its triangles are nowhere farther than 1e-3 inside it."""
    origin, direction = random_rays(1000, 2)
    hits = context.intersect(scene, origin + np.float32([10, 0, 0]), direction, mesh=1)
    along = -np.einsum("ij,ij->i", origin, direction).astype(np.float64)
    squared = 16 - along**2
    assert np.all(hits["mesh"][squared < 0.998] == 1) and np.all(hits["mesh"][squared > 1] == ty.NONE)
    hit = squared < 0.9
    assert np.count_nonzero(hit) > 200
    first, last = (along[hit] - np.sqrt(radius**2 - squared[hit]) for radius in (1.0, 0.999))
    assert np.all(hits["t"][hit] > first - 1e-5) and np.all(hits["t"][hit] < last + 1e-5)
    point = origin[hit] + hits["t"][hit, None] * direction[hit]
    assert np.all(np.einsum("ij,ij->i", hits["normal"][hit], point) > 0.998)


def test_barycentric_coordinates_and_triangles(context: ty.Context, scene: ty.Scene) -> None:
    positions, triangles = ty.shapes.box((1, 2, 3))
    origin, direction = random_rays(200, 3)
    hits = context.intersect(scene, origin, direction, mesh=0)
    hit = hits["mesh"] == 0
    corners = positions[triangles[hits["triangle"][hit]]]
    u, v = hits["u"][hit, None], hits["v"][hit, None]
    point = (1 - u - v) * corners[:, 0] + u * corners[:, 1] + v * corners[:, 2]
    assert np.allclose(point, (origin + hits["t"][:, None] * direction)[hit], atol=1e-5)


def test_the_part_of_the_ray_that_counts(context: ty.Context, scene: ty.Scene) -> None:
    """Along x through the box's sides at 2.5 and 3.5."""
    t_min = np.array([0, 2.4, 2.6, 2.6, 3.6, 0])
    t_max = np.array([np.inf, 2.6, 3.4, np.inf, 4.0, 2.4])
    hits = context.intersect(scene, [-3, 0, 0.25], [1, 0, 0], t_min=t_min, t_max=t_max)
    assert np.array_equal(hits["t"], np.float32([2.5, 2.5, np.inf, 3.5, np.inf, np.inf]))
    hidden = context.occluded(scene, [-3, 0, 0.25], [1, 0, 0], t_min=t_min, t_max=t_max)
    assert hidden.dtype == bool and hidden.tolist() == [True, True, False, True, False, False]


def test_one_mesh_of_a_scene(context: ty.Context, scene: ty.Scene) -> None:
    ray = ty.rays([-3, 0.125, 0.25], [1, 0, 0])
    assert [context.intersect(scene, ray, mesh=mesh)["mesh"][0] for mesh in (None, 0, 1)] == [0, 0, 1]


def test_the_same_as_raw_calls(context: ty.Context, scene: ty.Scene) -> None:
    origin, direction = random_rays(500, 4)
    rays = ty.rays(origin, direction, t_min=0.125, t_max=7)
    raw_rays, raw_hits, raw_occluded = (capi.TynRay * 500)(), (capi.TynHit * 500)(), (ctypes.c_uint32 * 500)()
    for raw, start, along in zip(raw_rays, origin, direction):
        raw.origin[:], raw.direction[:], raw.t_min, raw.t_max = start.tolist(), along.tolist(), 0.125, 7
    assert bytes(raw_rays) == rays.tobytes()
    assert capi.lib.tyn_intersect(scene.handle, capi.TYN_NONE, raw_rays, 500, raw_hits) == capi.TYN_OK
    assert capi.lib.tyn_occluded(scene.handle, capi.TYN_NONE, raw_rays, 500, raw_occluded) == capi.TYN_OK
    assert context.intersect(scene, rays).tobytes() == bytes(raw_hits)
    assert context.occluded(scene, rays).tolist() == [bool(one) for one in raw_occluded]


def test_results_have_the_rays_shape(context: ty.Context, scene: ty.Scene) -> None:
    y, z = np.meshgrid(np.linspace(-2, 2, 4), np.linspace(-2, 2, 5))
    origin = np.stack([np.full_like(y, -3), y, z], axis=-1)
    rays = ty.rays(origin, [1, 0, 0])
    hits = context.intersect(scene, rays)
    assert rays.shape == hits.shape == context.occluded(scene, rays).shape == (5, 4)
    flat = context.intersect(scene, origin.reshape(-1, 3), [1, 0, 0])
    assert np.array_equal(hits.reshape(-1), flat)
    assert np.array_equal(context.intersect(scene, rays.T), hits.T)
    assert np.array_equal(context.intersect(scene, rays[::2, ::-1]), hits[::2, ::-1])
    assert context.intersect(scene, rays[0, 0]).shape == (1,)


@pytest.mark.parametrize("shape", [(0, 3), (2, 0, 3)])
def test_no_rays(context: ty.Context, scene: ty.Scene, shape: Any) -> None:
    assert context.intersect(scene, np.zeros(shape), [1, 0, 0]).shape == shape[:-1]
    assert context.occluded(scene, np.zeros(shape), [1, 0, 0]).shape == shape[:-1]


RAY = ty.rays([0, 0, 0], [0, 0, 1])


@pytest.mark.parametrize(
    ("rays", "direction", "more", "said"),
    [
        ([0, 0, 0], None, {}, "rays must be an array of the type tyndall.RAY, or origins with a direction"),
        ([0, 0], [0, 0, 1], {}, r"origin has the shape \(2,\)"),
        (5, [0, 0, 1], {}, r"origin has the shape \(\)"),
        ("here", [0, 0, 1], {}, "origin must be numbers"),
        ([0, 0, 0], [0, 0, 2], {}, r"rays\[0\].direction's length is 2; it must be 1"),
        ([0, 0, 0], [0, 0, 0], {}, r"rays\[0\].direction's length is 0"),
        ([[0, 0, 0], [np.nan, 0, 0]], [0, 0, 1], {}, r"rays\[1\].origin\[0\] is -?nan"),
        ([0, 0, 0], [0, np.inf, 1], {}, r"rays\[0\].direction\[1\] is inf"),
        ([0, 0, 0], [0, 0, 1], {"t_min": -1}, r"rays\[0\].t_min is -1"),
        ([0, 0, 0], [0, 0, 1], {"t_min": 2, "t_max": 2}, r"rays\[0\].t_max is 2"),
        ([0, 0, 0], [0, 0, 1], {"t_max": np.nan}, r"rays\[0\].t_max is -?nan"),
        (np.zeros((2, 3)), np.zeros((3, 3)), {}, r"do not broadcast .*origin \(2,\), direction \(3,\)"),
        (np.zeros((2, 3)), [0, 0, 1], {"t_max": np.ones(3)}, r"do not broadcast .*origin \(2,\), t_max \(3,\)"),
        ([0, 0, 0], [0, 0, 1], {"mesh": 2}, "mesh is 2, but the scene has 2"),
        ([0, 0, 0], [0, 0, 1], {"mesh": -1}, "mesh is -1; it must be an index"),
        (RAY, [0, 0, 1], {}, "do not give these, too"),
        (RAY, None, {"t_max": 2}, "do not give these, too"),
        (np.zeros(2, ty.HIT), None, {}, "rays must be a one-dimensional structured array .* origin, t_min"),
    ],
)
def test_bad_rays_are_refused(context: ty.Context, scene: ty.Scene, rays: Any, direction: Any, more: Any, said: str) -> None:
    for call in (context.intersect, context.occluded):
        with pytest.raises(InvalidArgumentError, match=said):
            call(scene, rays, direction, **more)


def test_other_scenes_are_refused(context: ty.Context) -> None:
    with pytest.raises(InvalidArgumentError, match=r"scene is None; it must be a tyndall\.Scene"):
        context.intersect(None, RAY)  # type: ignore[arg-type]
    with context.scene() as scene, pytest.raises(InvalidOperationError, match="not committed"):
        context.intersect(scene, RAY)
    with ty.Context() as other, other.scene() as scene, pytest.raises(InvalidArgumentError, match="another context"):
        context.intersect(scene, RAY)


@settings(max_examples=30, deadline=None, derandomize=True)
@given(
    leading=st.lists(st.integers(0, 3), max_size=3).map(tuple),
    kind=st.sampled_from(["f4", "f8", ">f4", "f2", "i4"]),
    order=st.sampled_from("CF"),
    narrow=st.booleans(),
)
def test_any_array_of_rays(context: ty.Context, scene: ty.Scene, leading: Any, kind: str, order: Any, narrow: bool) -> None:
    """Rays along z from integer points, through the sides at z = +-1.5 of the box where |x| < 0.5, |y| < 1."""
    x = np.arange(np.prod(leading, dtype=int)).reshape(leading) % 4
    origin = np.asarray(np.stack([x, 0 * x, 0 * x - 5], axis=-1), kind, order=order)
    t_max = np.float64(3 if narrow else 4)
    hits = context.intersect(scene, origin, np.array([0, 0, 1], kind), t_max=t_max)
    expected = np.where((x == 0) & (not narrow), 3.5, np.inf)
    assert hits.shape == (leading or (1,)) and np.array_equal(hits["t"].reshape(leading), expected)
