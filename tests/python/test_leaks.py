# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Resident memory stays flat over many lives of every object.

PoCL and the allocator settle during the first cycles. From there on to the end the process may grow by a tolerance that is a
half or less of what the objects would take if they stayed: a context 1.7 kB, a committed scene of the test 760 kB, an open one
30 kB, a batch of its walks 7 kB (measured by keeping them). What was seen is growth by less than 0.1 MB, and 1.6 MB where the
garbage collector decides when contexts go. Committing a scene takes 40 ms, so there are fewer of those."""

import gc
import os
from typing import Any

import numpy as np
import pytest

import tyndall as ty
from tyndall.errors import CancelledError, InvalidArgumentError

MB = 1 << 20

SPHERE = ty.shapes.sphere(1.0, 2)
MEDIUM = ty.Medium(0.1, 2.0)
RADII = np.linspace(0.1, 5, 100, dtype=np.float32)
COSINES = np.linspace(-1, 1, 1000)
ENTRIES = ty.walk_entries(np.zeros((50, 3)), [0, 0, 1])


def resident() -> int:
    gc.collect()
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def scene_of(context: ty.Context) -> ty.Scene:
    scene = context.scene()
    scene.add_image(np.zeros((8, 8, 4), np.uint8))
    scene.add_mesh(*SPHERE, medium=ty.Medium(0.1, 2), material=ty.Material(name="skin", base_color_texture=0))
    scene.set_environment(ty.Environment(radiance=1.0))
    scene.commit()
    return scene


def contexts(_: ty.Context, __: ty.Scene) -> None:
    ty.Context().close()


def contexts_without_close(_: ty.Context, __: ty.Scene) -> None:
    ty.Context().scene().add_mesh(*SPHERE)


def scenes(context: ty.Context, _: ty.Scene) -> None:
    scene_of(context).close()


def open_scenes(context: ty.Context, _: ty.Scene) -> None:
    with context.scene() as scene:
        scene.add_mesh(*SPHERE, medium=ty.Medium(0.1, 2, phase=ty.Phase.tabulated([-1, 1], [1, 2])), name="ball")
        scene.add_light(ty.Light())


def callers_contexts(context: ty.Context, _: ty.Scene) -> None:
    ty.Context.from_cl(context.cl_context, context.cl_queue).close()


def slabs(context: ty.Context, _: ty.Scene) -> None:
    context.slab(ty.Layer(ty.Medium([0.1, 1], 2, g=0.5), 1.0), photons=1, radial=(1, 50), progress=lambda fraction: None)


def models(context: ty.Context, _: ty.Scene) -> None:
    with context.bssrdf("normalized-diffusion", MEDIUM) as model:
        model.profile(RADII)
        model.sample(100)


def renderers(context: ty.Context, scene: ty.Scene) -> None:
    with context.renderer(scene, width=4, height=4) as renderer:
        renderer.run(1)
        ty.Image(renderer)


def phases(_: ty.Context, __: ty.Scene) -> None:
    ty.Phase.tabulated(COSINES, np.ones(1000)).value(COSINES)


def walks(context: ty.Context, scene: ty.Scene) -> None:
    context.walk(scene, ENTRIES, progress=lambda fraction: None)
    context.intersect(scene, [0, 0, 3], [0, 0, -1])
    context.occluded(scene, [0, 0, 3], [0, 0, -1])


def failures(context: ty.Context, scene: ty.Scene) -> None:
    with pytest.raises(InvalidArgumentError):
        context.walk(scene, [0, 0, 0], [0, 0, 2])
    with pytest.raises(CancelledError):
        context.walk(scene, ENTRIES, progress=lambda fraction: True)


@pytest.mark.skipif(not os.path.exists("/proc/self/statm"), reason="resident memory is read from /proc")
@pytest.mark.parametrize(
    ("cycle", "warm_up", "cycles", "tolerance"),
    [
        (contexts, 500, 2000, 1 * MB),
        (contexts_without_close, 300, 1000, 4 * MB),
        (scenes, 20, 60, 4 * MB),
        (open_scenes, 300, 1000, 1 * MB),
        (callers_contexts, 300, 1000, 1 * MB),
        (slabs, 300, 1000, 1 * MB),
        (models, 300, 1000, 1 * MB),
        (renderers, 100, 1000, 1 * MB),
        (phases, 300, 1000, 1 * MB),
        (walks, 300, 1000, 1 * MB),
        (failures, 300, 1000, 1 * MB),
    ],
)
def test_memory_stays_flat(context: ty.Context, cycle: Any, warm_up: int, cycles: int, tolerance: int) -> None:
    with scene_of(context) as scene:
        for _ in range(warm_up):
            cycle(context, scene)
        before = resident()
        for _ in range(cycles):
            cycle(context, scene)
        assert resident() - before < tolerance
