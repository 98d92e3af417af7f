# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Numbers, integers and names that callers give: what is none is an InvalidArgumentError that names the argument, and what is
an integer for one call is one for all."""

import warnings
from collections.abc import Iterator
from typing import Any, Callable

import numpy as np
import pytest

import tyndall as ty
from tyndall.errors import InvalidArgumentError, OutOfMemoryError

MEDIUM = ty.Medium(0.1, 4)
LIT = ty.Environment(radiance=1.0)


@pytest.fixture(scope="module")
def scene(context: ty.Context) -> Iterator[ty.Scene]:
    with context.scene() as one:
        one.add_mesh(*ty.shapes.sphere(1.0, 1), medium=MEDIUM)
        one.set_environment(LIT)
        one.commit()
        yield one


@pytest.mark.parametrize("value", [None, "x", [0.1, 0.2], np.zeros(3), object()], ids=str)
def test_what_is_no_number(context: ty.Context, scene: ty.Scene, value: Any) -> None:
    calls: dict[str, Callable[[Any], object]] = {
        "g": lambda one: ty.Medium(1, 1, g=one),
        "ior": lambda one: ty.Medium(1, 1, ior=one),
        "alpha": lambda one: ty.Phase.draine(0.5, one),
        "radius": lambda one: ty.shapes.sphere(one),
        "metres_per_unit": context.scene,
        "aspect_ratio": scene.frame,
        "seconds": lambda one: context.render(scene, width=1, height=1, seconds=one),
        "target_error": lambda one: context.render(scene, width=1, height=1, target_error=one),
        "roulette_threshold": lambda one: context.walk(scene, [0, 0, 0], [0, 0, 1], roulette_threshold=one),
        "ior_above": lambda one: context.bssrdf("better-dipole", MEDIUM, ior_above=one),
        "ior_below": lambda one: context.slab(MEDIUM, photons=1, ior_below=one),
        "thickness": lambda one: context.slab(ty.Layer(MEDIUM, one), photons=1),
    }
    for name, call in calls.items():
        with pytest.raises(InvalidArgumentError, match=f"^{name} "):
            call(value)
    if value is not None:
        for call in (
            lambda one: ty.Medium(1, 1, metres_per_unit=one),
            lambda one: ty.Medium.preset("marble", one),
            ty.Medium.preset("marble").converted,
        ):
            with pytest.raises(InvalidArgumentError, match=r"^metres_per_unit "):
                call(value)


def test_numbers_out_of_range_are_shown() -> None:
    for fields, said in (
        ({"g": 1.0}, r"g is 1; it must be in \(-1, 1\)"),
        ({"g": np.nan}, "g is nan"),
        ({"ior": 0.5}, r"ior is 0.5; it must be in \[1, 4\]"),
        ({"metres_per_unit": 0.0}, "metres_per_unit is 0; it must be > 0 and finite"),
        ({"phase": 3}, "phase is 3; it must be a tyndall.Phase"),
    ):
        with pytest.raises(InvalidArgumentError, match=said):
            ty.Medium(1, 1, **fields)  # type: ignore[arg-type]


@pytest.mark.parametrize("layer", [ty.Layer(None, 1), ty.Layer("skin")])  # type: ignore[arg-type]
def test_a_layer_without_a_medium(context: ty.Context, layer: ty.Layer) -> None:
    for call in (lambda one: context.slab(one, photons=1), lambda one: context.bssrdf("better-dipole", one)):
        with pytest.raises(InvalidArgumentError, match=r"medium of layer 0 is .*; it must be a tyndall\.Medium"):
            call(layer)


@pytest.mark.parametrize("name", [7, b"skin", "skin\0", ["skin"]], ids=repr)
def test_what_is_no_name(context: ty.Context, name: Any) -> None:
    with context.scene() as scene:
        for call in (
            lambda: ty.Medium(1, 1, name=name),
            lambda: ty.Material(name=name),
            lambda: ty.Camera(name=name),
            lambda: scene.add_image(np.zeros((1, 1, 4), np.uint8), name=name),
            lambda: scene.add_mesh(*ty.shapes.box(), name=name),
        ):
            with pytest.raises(InvalidArgumentError, match=r"name is .*must be a str without a zero byte"):
                call()


def integers(context: ty.Context, scene: ty.Scene) -> dict[str, Callable[[Any], object]]:
    """Calls that take an integer, by its name; 1 is one for all of them."""
    small = {"width": 1, "height": 1, "spp": 1}
    model = context.bssrdf("better-dipole", MEDIUM)
    entry = ty.walk_entries([0, 0, 0], [0, 0, 1])
    return {
        "seed": lambda one: context.slab(MEDIUM, photons=10, seed=one),
        "seed ": lambda one: context.walk(scene, entry, seed=one),
        "seed  ": lambda one: context.render(scene, **small, seed=one),
        "seed   ": lambda one: model.sample(1, seed=one),
        "first_path": lambda one: context.walk(scene, entry, first_path=one),
        "max_scatterings": lambda one: context.walk(scene, entry, max_scatterings=one),
        "spp": lambda one: context.render(scene, **{**small, "spp": one}),
        "width": lambda one: context.render(scene, **{**small, "width": one}),
        "height": lambda one: context.render(scene, **{**small, "height": one}),
        "max_bounces": lambda one: context.render(scene, **small, max_bounces=one),
        "subdivisions": lambda one: ty.shapes.sphere(1.0, one),
        "memory_limit": lambda one: ty.Context(memory_limit=one).close(),
        "lane_width": lambda one: ty.Context(lane_width=one).close(),
        "count": lambda one: model.sample(one),
    }


def test_integers_are_taken_alike(context: ty.Context, scene: ty.Scene) -> None:
    for call in integers(context, scene).values():
        for value in (1, 1.0, np.float32(1), np.uint8(1), np.int64(1)):
            call(value)


@pytest.mark.parametrize("value", [-1, 1 << 64, 0.5, "1", None, [1], np.nan, np.inf], ids=str)
def test_what_is_no_integer(context: ty.Context, scene: ty.Scene, value: Any) -> None:
    for name, call in integers(context, scene).items():
        with pytest.raises(InvalidArgumentError, match=rf"^{name.strip()} is .*; it must be an integer in \["):
            call(value)


def test_counts_of_buffers_are_those_of_c(context: ty.Context, scene: ty.Scene, monkeypatch: pytest.MonkeyPatch) -> None:
    """size_t, of which more than 2^32 - 2 is for the library to refuse, as it knows the buffers' size."""
    from tyndall import capi

    counts: list[int] = []

    def refuse(scene: Any, options: Any, entries: Any, count: int, *rest: Any) -> int:
        counts.append(count)
        return int(capi.TYN_OK)

    monkeypatch.setattr(capi.lib, "tyn_walk_cl", refuse)
    for count in (1 << 40, 7.0):
        context.walk_cl(scene, 64, count, 64, ledger=False)  # type: ignore[arg-type]
    assert counts == [1 << 40, 7]


def test_counts_without_memory_for_them(context: ty.Context) -> None:
    with context.bssrdf("better-dipole", MEDIUM) as model:
        for count in (1 << 50, 1 << 62, (1 << 64) - 1):
            for call in (model.sample, ty.Phase.rayleigh().sample, ty.Phase.rayleigh().moments):
                with pytest.raises(OutOfMemoryError, match=f"count is {count}; there is no memory for so many"):
                    call(count)


def test_huge_views_of_few_numbers(context: ty.Context) -> None:
    """Their shape is looked at before they are copied, and if it is allowed, that there is no memory is said by us."""
    huge = np.broadcast_to(np.float64(1), (1 << 50,))
    for call in (
        lambda: ty.Phase.tabulated(np.broadcast_to(1.0, (2, 1 << 50)), [1, 1]),
        lambda: ty.Camera.look_at(huge, [0, 0, 0]),
        lambda: ty.Medium(1, 1, g=huge),  # type: ignore[arg-type]
    ):
        with pytest.raises(InvalidArgumentError, match=r"has the shape \(.*1125899906842624,?\); it must be"):
            call()
    with pytest.raises(OutOfMemoryError, match=r"no memory for radii, an array of shape \(1125899906842624,\)"):
        context.bssrdf("better-dipole", MEDIUM).profile(huge)
    with context.scene() as scene, pytest.raises(InvalidArgumentError, match="sides must be 1 to 32768"):
        scene.add_image(np.broadcast_to(np.uint8(1), (1 << 24, 1 << 24, 3)))


def test_masked_elements_are_refused(context: ty.Context, scene: ty.Scene) -> None:
    def masked(values: Any, dtype: Any = np.float32) -> Any:
        result = np.ma.array(np.array(values, dtype))
        result[..., 0] = np.ma.masked
        return result

    entries = ty.walk_entries([[0, 0, 0], [0, 0, 0]], [0, 0, 1])
    calls: dict[str, Callable[[], object]] = {
        "sigma_a": lambda: ty.Medium(masked([1, 2, 3]), 1),
        "position": lambda: ty.walk_entries(masked([0, 0, 0]), [0, 0, 1]),
        "mesh": lambda: ty.walk_entries([0, 0, 0], [0, 0, 1], mesh=masked([0, 0], np.uint32)),
        "path": lambda: ty.walk_entries([0, 0, 0], [0, 0, 1], path=masked([0, 0], np.uint64)),
        "entries": lambda: context.walk(scene, np.ma.array(entries, mask=[True, False])),
        "rays": lambda: context.intersect(scene, np.ma.array(ty.rays([[0, 0, 3]] * 2, [0, 0, -1]), mask=[True, False])),
        "positions": lambda: context.scene().add_mesh(masked(np.eye(3)), [[0, 1, 2]]),
        "triangles": lambda: context.scene().add_mesh(np.eye(3), masked([[0, 1, 2]], np.uint32)),
        "pixels": lambda: context.scene().add_image(masked(np.zeros((1, 1, 4)))),
    }
    for name, call in calls.items():
        with pytest.raises(InvalidArgumentError, match=f"{name} is a masked array with masked elements"):
            call()
    assert ty.Medium(np.ma.array([1.0, 2.0, 3.0]), 1).sigma_a.tolist() == [1, 2, 3]  # nothing is masked


@pytest.mark.parametrize("channels", [3, 4])
def test_pixels_that_float32_cannot_hold(context: ty.Context, channels: int) -> None:
    pixels = np.full((2, 2, channels), 1e300)
    with context.scene() as scene, warnings.catch_warnings():
        warnings.simplefilter("error")
        with pytest.raises(InvalidArgumentError, match="inf"):
            scene.add_image(pixels)
