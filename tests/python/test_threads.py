# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""One context a thread, one context for all threads, and one that goes while others wait for it."""

import threading
import time
from concurrent.futures import ThreadPoolExecutor
from typing import Any, Callable

import numpy as np
import pytest

import tyndall as ty
from tyndall.errors import ClosedError, InvalidOperationError

THREADS = 8


def scene_of(context: ty.Context) -> ty.Scene:
    scene = context.scene()
    scene.add_mesh(*ty.shapes.sphere(1.0, 2), medium=ty.Medium(0.1, 4, g=0.5, ior=1.3))
    scene.commit()
    return scene


def entries() -> Any:
    return ty.walk_entries(np.random.default_rng(1).uniform(-0.5, 0.5, (2000, 3)), [0, 0, 1])


def own_context(seed: int) -> bytes:
    with ty.Context() as context, scene_of(context) as scene:
        return bytes(context.walk(scene, entries(), seed=seed).tobytes())


def test_a_context_a_thread() -> None:
    alone = [own_context(seed) for seed in range(THREADS)]
    assert len(set(alone)) == THREADS
    with ThreadPoolExecutor(THREADS) as pool:
        assert list(pool.map(own_context, range(THREADS))) == alone


def test_a_context_for_all_threads(context: ty.Context) -> None:
    start = threading.Barrier(THREADS)
    rays = ty.rays([(x, 0.1, 3) for x in np.linspace(-1.5, 1.5, 100)], [0, 0, -1])

    def work(scene: ty.Scene, seed: int) -> tuple[bytes, bytes, str]:
        walks = context.walk(scene, entries(), seed=seed).tobytes()
        hits = context.intersect(scene, rays).tobytes()
        with pytest.raises(ValueError, match="entry 0: direction") as caught:
            context.walk(scene, [0, 0, 0], [0, 0, 2 + seed])
        return walks, hits, str(caught.value)

    def together(scene: ty.Scene, seed: int) -> tuple[bytes, bytes, str]:
        start.wait()
        return work(scene, seed)

    with scene_of(context) as scene:
        alone = [work(scene, seed) for seed in range(THREADS)]
        assert "(0, 0, 9)" in alone[7][2]  # the message of the thread's own call
        with ThreadPoolExecutor(THREADS) as pool:
            assert list(pool.map(lambda seed: together(scene, seed), range(THREADS))) == alone


def test_scenes_are_made_and_closed_by_all_threads(context: ty.Context) -> None:
    with scene_of(context) as scene:
        expected = context.walk(scene, entries()).tobytes()

    def work(_: int) -> bool:
        with scene_of(context) as scene:
            return bool(context.walk(scene, entries()).tobytes() == expected)

    with ThreadPoolExecutor(THREADS) as pool:
        assert all(pool.map(work, range(3 * THREADS)))


def test_calls_release_the_interpreter(context: ty.Context) -> None:
    """While a call of half a second, which has no progress function of the caller's, is under way in a thread, this one counts.
    (Between launches, 0.05 s and longer, the call takes the interpreter for its own look at progress: fewer than 40 times.)"""
    layer = ty.Layer(ty.Medium(0.5, 1.0), 0.1)
    context.slab(layer, photons=1000)  # compiles
    with ThreadPoolExecutor(1) as pool:
        future = pool.submit(context.slab, layer, photons=0, seconds=0.5)
        count = 0
        while not future.done():
            count += 1
            time.sleep(1e-4)
    assert count > 200
    assert future.result().run.seconds > 0.4


def test_a_context_cannot_be_used_from_its_own_call(context: ty.Context) -> None:
    with scene_of(context) as scene:
        uses: list[Any] = [
            lambda: context.walk(scene, entries()),
            lambda: context.device,
            lambda: scene.info,
            context.scene,
        ]
        for use in uses:
            with pytest.raises(InvalidOperationError, match="progress callback of its own call"):
                context.walk(scene, entries(), progress=lambda fraction, use=use: use())
        assert context.walk(scene, entries()).shape == (2000,)
        with ty.Context() as other, scene_of(other) as another:
            seen: list[bytes] = []
            context.walk(scene, entries(), progress=lambda _: seen.append(other.walk(another, entries()).tobytes()))
            assert seen[0] == context.walk(scene, entries()).tobytes()


def exits(model: ty.Bssrdf, scene: ty.Scene) -> Any:
    return model.sample_exits(scene, position=[0, 0, 1], normal=[0, 0, 1])


NO_BUFFER = 64  # an address that is not looked at
USES: dict[str, Callable[[ty.Context, ty.Scene, ty.Bssrdf], object]] = {
    "walk": lambda context, scene, model: context.walk(scene, entries()),
    "exits": lambda context, scene, model: exits(model, scene),
    "exits_cl": lambda context, scene, model: model.sample_exits_cl(scene, NO_BUFFER, 0, NO_BUFFER),
}


@pytest.mark.parametrize(
    ("what", "use"),
    [*((one, "walk") for one in ("scene", "context")), *((one, "exits") for one in ("scene", "model")), ("scene", "exits_cl")],
)
def test_what_is_closed_while_a_thread_waits_for_it_is_refused(what: str, use: str) -> None:
    """The first thread is inside a call; the second waits for the context; then it goes. The first call ends as always."""
    context = ty.Context()
    scene = scene_of(context)
    model = context.bssrdf("better-dipole", ty.Medium(0.1, 4))
    expected = context.walk(scene, entries()).tobytes()
    inside, closed = threading.Event(), threading.Event()
    waiting: list[threading.Thread] = []
    found: list[BaseException] = []

    def second() -> None:
        try:
            USES[use](context, scene, model)
        except BaseException as error:
            found.append(error)

    def first(fraction: float) -> bool:
        if not inside.is_set():
            waiting.append(threading.Thread(target=second))
            waiting[0].start()
            waiting[0].join(0.2)  # it is at the guard by then
            inside.set()
        return not closed.wait(20)

    with ThreadPoolExecutor(1) as pool:
        future = pool.submit(context.walk, scene, entries(), progress=first)
        assert inside.wait(20)
        {"scene": scene, "context": context, "model": model}[what].close()
        closed.set()
        assert future.result(20).tobytes() == expected
    waiting[0].join(20)
    assert [type(error) for error in found] == [ClosedError]
    context.close()


def test_what_a_scene_says_is_copied_before_it_may_be_closed(context: ty.Context, monkeypatch: pytest.MonkeyPatch) -> None:
    """A record points into the scene: while it is read, no thread may use it otherwise."""
    refused: list[type] = []

    def watch(kind: Any, method: str) -> None:
        own = getattr(kind, method)

        def read(*arguments: Any, **keywords: Any) -> Any:
            with pytest.raises(InvalidOperationError):
                _ = context.device
            refused.append(kind)
            return own(*arguments, **keywords)

        monkeypatch.setattr(kind, method, read)

    with scene_of(context) as scene:
        watch(ty.MeshInfo, "of")
        watch(ty.Medium, "__init__")
        assert scene.mesh_info(0).triangle_count == 320
        assert scene.medium(0).sigma_s.tolist() == [4, 4, 4]
    assert refused == [ty.MeshInfo, ty.Medium]
