# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Numbers, integers and names that callers give: what is none is an InvalidArgumentError that names the argument, and what is
an integer for one call is one for all."""

from collections.abc import Iterator
from typing import Any, Callable

import numpy as np
import pytest

import tyndall as ty
from tyndall.errors import InvalidArgumentError

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
