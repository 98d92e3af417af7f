# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Walks: laws that any right walk obeys, and the raw call bit for bit."""

import ctypes
import pickle
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from shapes_by_hand import area, volume

import tyndall as ty
from tyndall import capi
from tyndall.errors import CancelledError, InvalidArgumentError, InvalidOperationError

BALL = ty.shapes.sphere(1.0, 2)


def scene_with(context: ty.Context, medium: ty.Medium | None, shape: Any = BALL) -> ty.Scene:
    scene = context.scene()
    scene.add_mesh(*shape, medium=medium)
    scene.commit()
    return scene


@pytest.fixture(scope="module")
def milk(context: ty.Context) -> Iterator[ty.Scene]:
    with scene_with(context, ty.Medium([0.1, 0.2, 0.4], [4, 5, 6], g=0.5, ior=1.3)) as scene:
        yield scene


def entries_of(count: int, seed: int = 0) -> Any:
    """Entries of all kinds on triangles of BALL, with channels of their own."""
    generator = np.random.default_rng(seed)
    positions, triangles = BALL
    triangle = generator.integers(0, len(triangles), count)
    corners = positions[triangles[triangle]].astype(np.float64)
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    return ty.walk_entries(
        corners.mean(axis=1),
        -normal,
        kind=np.array(["inside", "refract", "cosine"])[np.arange(count) % 3],
        triangle=triangle,
        weight=generator.random((count, 3)),
        roughness=generator.choice([0.0, 0.3], count),
    )


# ---- laws


def test_absorption_follows_beer_and_lambert(context: ty.Context) -> None:
    """Without scattering, straight to a side of a box: exp(-sigma_a d) leaves on average, in every channel. False alarms: 4e-5,
    4.5 standard errors in three channels and two distances."""
    sigma_a, count = np.array([0.25, 0.5, 1.0]), 20000
    with scene_with(context, ty.Medium(sigma_a, 0), ty.shapes.box((8, 8, 3))) as scene:
        for height in (-1.0, 0.75):
            exits = context.walk(scene, np.broadcast_to([0.1, 0.2, height], (count, 3)), [0, 0, 1], seed=1)
            out = exits[exits.escaped]
            assert np.all(out["scatterings"] == 0) and np.allclose(out["path_length"], 1.5 - height, atol=1e-5)
            assert np.allclose(out["position"], [0.1, 0.2, 1.5], atol=1e-5) and np.all(out["direction"] == [0, 0, 1])
            weight = np.where(exits.escaped[:, None], exits["weight"], 0).astype(np.float64)
            error = np.abs(weight.mean(axis=0) - np.exp(-sigma_a * (1.5 - height)))
            assert np.all(error < 4.5 * weight.std(axis=0) / np.sqrt(count))


@pytest.mark.parametrize("g", [0.0, 0.7])
def test_the_mean_path_is_four_volumes_over_the_surface(context: ty.Context, g: float) -> None:
    """White, index-matched, cosine-distributed entry, uniform over the surface (Blanco & Fournier 2003). False alarms: 6e-5,
    4 standard errors."""
    positions, triangles = shape = ty.shapes.box((1, 2, 0.5))
    generator = np.random.default_rng(5)
    corners = positions[triangles].astype(np.float64)
    sizes = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    triangle = generator.choice(len(triangles), 20000, p=sizes / sizes.sum())
    u, v = generator.random((2, 20000, 1))
    u, v = np.where(u + v > 1, 1 - u, u), np.where(u + v > 1, 1 - v, v)
    a, b, c = corners[triangle].transpose(1, 0, 2)
    with scene_with(context, ty.Medium(0, 3, g=g), shape) as scene:
        exits = context.walk(scene, (1 - u - v) * a + u * b + v * c, triangle=triangle, seed=7)
    assert np.all(exits.escaped) and np.all(exits["weight"] == 1)
    length = exits["path_length"].astype(np.float64)
    expected = 4 * volume(*shape) / area(*shape)
    assert length.mean() == pytest.approx(expected, abs=4 * length.std() / np.sqrt(len(length)))


def test_the_ledger_adds_up(context: ty.Context, milk: ty.Scene) -> None:
    entries = entries_of(3000)
    exits = context.walk(milk, entries, seed=1, max_scatterings=40)
    ledger = exits.ledger
    assert ledger is not None
    assert np.allclose(ledger.entered, entries["weight"].sum(axis=0, dtype=np.float64), rtol=1e-12)
    assert np.allclose(ledger.escaped, exits["weight"][exits.escaped].sum(axis=0, dtype=np.float64), rtol=1e-12)
    sums = ledger.reflected + ledger.escaped + ledger.absorbed + ledger.balance + ledger.capped + ledger.leaked + ledger.lost
    assert np.allclose(sums, ledger.entered, rtol=1e-5)
    assert np.all(ledger.reflected > 0) and np.all(ledger.absorbed > 0) and np.all(ledger.capped > 0)
    assert ledger.walks == 3000 and ledger.scatterings == int(exits["scatterings"].sum())
    for status in ("escaped", "absorbed", "capped", "leaked", "lost", "reflected"):
        assert getattr(ledger, f"{status}_walks") == np.count_nonzero(exits.ended(status))
    assert ledger.capped_walks > 10 and np.all(exits["scatterings"] <= 40)


def test_roulette_off_ends_no_walk(context: ty.Context, milk: ty.Scene) -> None:
    exits = context.walk(milk, np.zeros((200, 3)), [0, 0, 1], roulette=False)
    assert np.all(exits.escaped)
    assert exits.ledger is not None and exits.ledger.absorbed_walks == 0
    more = context.walk(milk, np.zeros((200, 3)), [0, 0, 1], roulette_threshold=1.0)
    assert np.count_nonzero(more.ended("absorbed")) > 20


def test_the_medium_s_numbers_can_be_the_entry_s(context: ty.Context) -> None:
    """A clear medium with an albedo and extinction of the walk's own is the medium that has them."""
    with scene_with(context, ty.Medium(1, 1)) as scene, scene_with(context, ty.Medium([0.25, 0.5, 1], [0.75, 1.5, 1])) as other:
        own = context.walk(scene, np.zeros((50, 3)), [0, 0, 1], albedo=[0.75, 0.75, 0.5], sigma_t=[1, 2, 2], seed=3)
        assert own.tobytes() == context.walk(other, np.zeros((50, 3)), [0, 0, 1], seed=3).tobytes()


# ---- the same bits


def raw_walk(scene: ty.Scene, entries: Any, **options: Any) -> Any:
    """The bytes of the raw call's exits and ledger."""
    count = len(entries)
    raw_entries, raw_exits = (capi.TynWalkEntry * count).from_buffer_copy(entries.tobytes()), (capi.TynWalkExit * count)()
    ledger, given = capi.TynLedger(), capi.TynWalkOptions(**options)
    status = capi.lib.tyn_walk(scene.handle, ctypes.byref(given), raw_entries, count, raw_exits, ctypes.byref(ledger))
    assert status == capi.TYN_OK
    return bytes(raw_exits), bytes(ledger)


def ledger_bytes(exits: ty.Exits) -> bytes:
    ledger = exits.ledger
    assert ledger is not None
    record = capi.TynLedger()
    for name, _ in record._fields_:
        value = getattr(ledger, name)
        setattr(record, name, value if isinstance(value, int) else (ctypes.c_double * 3)(*value))
    return bytes(record)


def test_the_same_as_raw_calls(context: ty.Context, milk: ty.Scene) -> None:
    entries = entries_of(1000)
    exits = context.walk(milk, entries, seed=1 << 40, first_path=3 << 33, max_scatterings=500, roulette_threshold=0.25)
    raw = raw_walk(milk, entries, seed=1 << 40, first_path=3 << 33, max_scatterings=500, roulette_threshold=0.25)
    assert (exits.tobytes(), ledger_bytes(exits)) == raw
    assert context.walk(milk, entries).tobytes() == raw_walk(milk, entries)[0]
    assert context.walk(milk, entries, seed=1).tobytes() != raw_walk(milk, entries)[0]


def test_records_are_what_was_said() -> None:
    found = ty.walk_entries(
        [[1, 2, 3], [4, 5, 6]], [0, 0, 1], kind=["refract", "inside"], mesh=[7, 8], triangle=9, weight=[[1], [2]],
        albedo=0.5, sigma_t=[1, 2, 3], medium=4, roughness=[0, 0.5], path=[1, (5 << 32) + 6],
    )  # fmt: skip
    expected = (capi.TynWalkEntry * 2)()
    for i, one in enumerate(expected):
        one.position[:], one.direction[:] = ([1, 2, 3], [4, 5, 6])[i], [0, 0, 1]
        one.kind = (capi.TYN_ENTRY_REFRACT, capi.TYN_ENTRY_INSIDE)[i]
        one.mesh, one.triangle, one.medium = 7 + i, 9, 4
        one.weight[:], one.albedo[:], one.sigma_t[:] = [1 + i] * 3, [0.5] * 3, [1, 2, 3]
        one.roughness, one.path[:] = 0.5 * i, ([1, 0], [6, 5])[i]
    assert found.dtype == ty.WALK_ENTRY and found.tobytes() == bytes(expected)


@pytest.mark.parametrize(
    ("more", "kind"),
    [
        ({"direction": [0, 0, 1]}, capi.TYN_ENTRY_INSIDE),
        ({"direction": [0, 0, 1], "triangle": 0}, capi.TYN_ENTRY_REFRACT),
        ({"triangle": 0}, capi.TYN_ENTRY_COSINE),
        ({"direction": [0, 0, 1], "triangle": 0, "kind": "inside"}, capi.TYN_ENTRY_INSIDE),
    ],
)
def test_what_else_an_entry_says(more: Any, kind: int) -> None:
    entry = ty.walk_entries([0, 0, 0], **more)[0]
    assert (entry["kind"], entry["mesh"], entry["medium"]) == (kind, 0, ty.NONE)
    assert entry["weight"].tolist() == [1, 1, 1] and entry["albedo"][0] < 0 and entry["sigma_t"][0] < 0
    assert entry["triangle"] == (0 if "triangle" in more else ty.NONE)


def test_arguments_and_records_walk_alike(context: ty.Context, milk: ty.Scene) -> None:
    position = np.random.default_rng(2).uniform(-0.4, 0.4, (40, 3))
    exits = context.walk(milk, position, [0, 1, 0], weight=[1, 2, 3], seed=4)
    entries = ty.walk_entries(position.astype(np.float32), [0, 1, 0], weight=[1, 2, 3])
    assert exits.tobytes() == context.walk(milk, entries, seed=4).tobytes()


@pytest.mark.parametrize("cuts", [[500], [1, 17, 900]])
def test_splitting_a_batch_changes_nothing(context: ty.Context, milk: ty.Scene, cuts: list[int]) -> None:
    entries = entries_of(1000)
    whole = context.walk(milk, entries, seed=9)
    first, parts = 0, []
    for part in np.split(entries, cuts):
        parts.append(context.walk(milk, part, seed=9, first_path=first).tobytes())
        first += len(part)
    assert b"".join(parts) == whole.tobytes()


def test_paths_choose_the_random_numbers(context: ty.Context, milk: ty.Scene) -> None:
    far = (1 << 33) + 5
    in_order = context.walk(milk, np.zeros((8, 3)), [0, 0, 1], first_path=far)
    place = np.arange(8)
    turned = context.walk(milk, np.zeros((8, 3)), [0, 0, 1], path=(far + 7 - place) - place)
    assert turned[::-1].tobytes() == in_order.tobytes()
    assert len(np.unique(in_order["path_length"])) == 8


@pytest.mark.parametrize("layout", ["strided", "reversed", "two-dimensional", "transposed", "one"])
def test_records_in_any_layout(context: ty.Context, milk: ty.Scene, layout: str) -> None:
    entries = entries_of(24)
    entries["path"] = 0
    changed = {
        "strided": entries[::3], "reversed": entries[::-1], "two-dimensional": entries.reshape(4, 6),
        "transposed": entries.reshape(4, 6).T, "one": entries[5],
    }[layout]  # fmt: skip
    exits = context.walk(milk, changed)
    assert exits.shape == (changed.shape or (1,)) and exits.ledger is not None
    assert exits.tobytes() == raw_walk(milk, np.ascontiguousarray(changed).reshape(-1))[0]


def test_records_are_not_copied(context: ty.Context, milk: ty.Scene, monkeypatch: pytest.MonkeyPatch) -> None:
    entries, addresses = entries_of(10), []

    def note(function: Any, handle: Any, options: Any, first: Any, *rest: Any) -> None:
        addresses.append(ctypes.addressof(first.contents))

    monkeypatch.setattr(milk, "_call", note)
    context.walk(milk, entries)
    assert addresses == [entries.ctypes.data]


# ---- from rays to walks


def test_walks_where_rays_hit(context: ty.Context) -> None:
    """Index-matched and clear: each ray goes on straight, and leaves by the other side."""
    with context.scene() as scene:
        scene.add_mesh(*ty.shapes.box(2), medium=ty.Medium(0, 0))
        scene.add_mesh(ty.shapes.box(1)[0] + np.float32([5, 0, 0]), ty.shapes.box(1)[1])
        scene.commit()
        x, y = np.meshgrid(np.linspace(-3.1, 6.2, 12), np.linspace(-2.3, 2.1, 7))
        rays = ty.rays(np.stack([x, y, np.full_like(x, 4)], axis=-1), [0, 0, -1])
        hits = context.intersect(scene, rays)
        entries, entering = ty.walk_entries_at(rays, hits, mesh=0, weight=[1, 2, 4])
        assert np.array_equal(entering, (np.abs(x) < 1) & (np.abs(y) < 1)) and np.any(entering)
        assert np.all(hits["mesh"][entering] == 0) and np.any(hits["mesh"] == 1)
        exits = context.walk(scene, entries)
        assert np.all(exits.escaped)
        picture = np.zeros((*x.shape, 3))
        picture[entering] = exits["weight"]
        assert np.array_equal(picture, entering[..., None] * np.array([1, 2, 4]))
        assert np.allclose(exits["position"], np.stack([x, y, np.full_like(x, -1)], axis=-1)[entering], atol=1e-5)
        everything, _ = ty.walk_entries_at(rays, hits)
        assert set(everything["mesh"]) == {0, 1} and np.all(everything["kind"] == capi.TYN_ENTRY_REFRACT)


def test_rays_from_inside_do_not_enter(context: ty.Context, milk: ty.Scene) -> None:
    rays = ty.rays([[0, 0, 0], [0, 0, 3], [0, 3, 3]], [0, 0, -1])
    entries, entering = ty.walk_entries_at(rays, context.intersect(milk, rays))
    assert entering.tolist() == [False, True, False] and len(entries) == 1
    assert entries["position"][0] == pytest.approx([0, 0, 1], abs=0.05)
    none, _ = ty.walk_entries_at(rays[:1], context.intersect(milk, rays[:1]))
    assert context.walk(milk, none).shape == (0,)
    with pytest.raises(InvalidArgumentError, match=r"rays has the shape \(3,\) and hits \(2,\)"):
        ty.walk_entries_at(rays, context.intersect(milk, rays[:2]))


# ---- exits


def test_exits_are_an_array_with_a_ledger(context: ty.Context, milk: ty.Scene) -> None:
    exits = context.walk(milk, np.zeros((20, 3)), [0, 0, 1])
    assert isinstance(exits, ty.Exits) and exits.dtype == ty.WALK_EXIT and exits.ledger is not None
    for part in (exits[:10], exits[exits.escaped], exits.copy(), exits.reshape(4, 5), pickle.loads(pickle.dumps(exits))):
        assert isinstance(part, ty.Exits) and part.ledger is None
        assert np.array_equal(part.escaped, part["status"] == capi.TYN_WALK_ESCAPED)
    for name in ty.WALK_EXIT.names or ():
        assert type(exits[name]) is np.ndarray
    assert type(exits[["position", "weight"]]) is np.ndarray and type(exits[3]) is np.void
    assert exits.flags.writeable and exits.ledger is not None
    with pytest.raises(InvalidArgumentError, match='status is \'gone\'; it must be one of "escaped", "absorbed"'):
        exits.ended("gone")


@pytest.mark.parametrize("shape", [(0, 3), (3, 0, 3)])
def test_no_walks(context: ty.Context, milk: ty.Scene, shape: Any) -> None:
    exits = context.walk(milk, np.zeros(shape), [0, 0, 1])
    assert exits.shape == shape[:-1] and exits.ledger is not None
    assert exits.ledger.walks == 0 and np.array_equal(exits.ledger.entered, [0, 0, 0])


def test_cancelling_keeps_what_was_done(context: ty.Context) -> None:
    """Batches of 2^17 walks: one is done, the second is not begun."""
    batch, count = 1 << 17, (1 << 17) + 100
    fractions: list[float] = []

    def stop(fraction: float) -> bool:
        fractions.append(fraction)
        return len(fractions) == 2

    with scene_with(context, ty.Medium(0, 0), ty.shapes.box()) as scene:
        entries = ty.walk_entries(np.zeros((count, 3)), [0, 0, 1])
        with pytest.raises(CancelledError) as caught:
            context.walk(scene, entries, progress=stop)
        assert fractions == [0.0, batch / count]
        result = caught.value.result
        assert isinstance(result, ty.Exits) and result.shape == (batch,) and np.all(result.escaped)
        assert result.ledger is not None and result.ledger.walks == batch
        assert np.array_equal(result, context.walk(scene, entries[:batch]))
        with pytest.raises(CancelledError) as caught:
            context.walk(scene, entries[:5], progress=lambda fraction: True)
        assert caught.value.result.shape == (0,) and caught.value.result.ledger.walks == 0
        seen: list[float] = []
        context.walk(scene, entries[:5], progress=seen.append)
        assert seen == [0.0, 1.0]


def test_what_progress_raises_is_raised(context: ty.Context, milk: ty.Scene) -> None:
    def fail(fraction: float) -> None:
        raise LookupError("enough")

    with pytest.raises(LookupError, match="enough"):
        context.walk(milk, np.zeros((5, 3)), [0, 0, 1], progress=fail)
    assert context.walk(milk, np.zeros((5, 3)), [0, 0, 1]).shape == (5,)


# ---- bad input


@pytest.mark.parametrize(
    ("given_arguments", "said"),
    [
        ({"position": [0, 0]}, r"position has the shape \(2,\)"),
        ({"position": [0, np.nan, 0]}, r"entry 0: position\[1\] is -?nan; it must be finite"),
        ({"position": "middle"}, "position must be numbers"),
        ({"position": np.zeros((2, 3)), "direction": np.zeros((3, 3))}, "do not broadcast against one another"),
        ({"direction": [0, 0, 0.5]}, r"entry 0: direction is \(0, 0, 0.5\) of length 0.5; it must have unit length"),
        ({"direction": None}, "there is no direction: give one, or a triangle"),
        ({"direction": None, "kind": "inside"}, 'direction is needed by walks of a kind other than "cosine"'),
        ({"kind": "sideways"}, 'kind is .*sideways.*; it must be one of "inside", "refract", "cosine"'),
        ({"kind": 1}, 'kind is .*1.*; it must be one of "inside", "refract", "cosine"'),
        ({"mesh": 1}, "entry 0: mesh is 1, but the scene has 1 meshes"),
        ({"mesh": -1}, "mesh holds -1"),
        ({"mesh": 0.5}, "mesh must be integers"),
        ({"mesh": 1 << 32}, "mesh holds 4294967296"),
        ({"triangle": 320}, "entry 0: triangle is 320"),
        ({"medium": 1}, "entry 0: medium is 1"),
        ({"weight": -1}, r"entry 0: weight\[0\] is -1"),
        ({"weight": [1, 2]}, r"weight has the shape \(2,\)"),
        ({"weight": [1, 2, np.inf]}, r"entry 0: weight\[2\] is inf"),
        ({"albedo": 1.5}, r"entry 0: albedo\[0\] is 1.5"),
        ({"albedo": -1}, "albedo is -1; it must be >= 0, or None"),
        ({"albedo": np.nan}, r"entry 0: albedo\[0\] is -?nan"),
        ({"sigma_t": [1, -1, 1]}, "sigma_t is -1; it must be >= 0, or None"),
        ({"roughness": 2}, "entry 0: roughness is 2"),
        ({"path": -1}, "path is -1; it must be an integer"),
        ({"path": 0.5}, "path is 0.5; it must be an integer"),
        ({"roulette_threshold": 0}, "roulette_threshold is 0"),
        ({"roulette_threshold": np.nan}, "roulette_threshold is -?nan"),
    ],
)
def test_bad_arguments_are_refused(context: ty.Context, milk: ty.Scene, given_arguments: Any, said: str) -> None:
    arguments = {"direction": [0, 0, 1], **given_arguments}
    with pytest.raises(InvalidArgumentError, match=said):
        context.walk(milk, arguments.pop("position", [0, 0, 0]), arguments.pop("direction"), **arguments)


@pytest.mark.parametrize("name", ["seed", "first_path", "max_scatterings"])
def test_bad_numbers_are_refused(context: ty.Context, milk: ty.Scene, name: str) -> None:
    bad: list[Any] = [-1, 1 << 64, 0.5, "1"]
    for value in bad:
        with pytest.raises(InvalidArgumentError, match=f"{name} is "):
            context.walk(milk, [0, 0, 0], [0, 0, 1], **{name: value})


@pytest.mark.parametrize(
    ("more", "name"),
    [
        ({"direction": [0, 0, 1]}, "direction"),
        ({"mesh": 1}, "mesh"),
        ({"weight": 2}, "weight"),
        ({"weight": [1, 1, 1]}, "weight"),
    ],
)
def test_records_and_fields_together_are_refused(context: ty.Context, milk: ty.Scene, more: Any, name: str) -> None:
    with pytest.raises(InvalidArgumentError, match=f"which have a {name} of their own"):
        context.walk(milk, entries_of(1), **more)


def test_other_scenes_and_records_are_refused(context: ty.Context, milk: ty.Scene) -> None:
    with context.scene() as scene, pytest.raises(InvalidOperationError, match="not committed"):
        context.walk(scene, entries_of(1))
    with scene_with(context, None) as scene, pytest.raises(InvalidArgumentError, match="entry 0: mesh 0 has no medium"):
        context.walk(scene, entries_of(1))
    with ty.Context() as other, pytest.raises(InvalidArgumentError, match="another context"):
        other.walk(milk, entries_of(1))
    with pytest.raises(InvalidArgumentError, match=r"entries must be .* position, kind, direction"):
        context.walk(milk, np.zeros(2, ty.RAY))
    with pytest.raises(InvalidArgumentError, match=r"position must be numbers .* it is None"):
        context.walk(milk, None, [0, 0, 1])  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="progress is 5"):
        context.walk(milk, entries_of(1), progress=5)  # type: ignore[arg-type]


@settings(max_examples=30, deadline=None, derandomize=True)
@given(
    leading=st.lists(st.integers(0, 3), max_size=2).map(tuple),
    kind=st.sampled_from(["f4", "f8", ">f4", "i4"]),
    weight=st.sampled_from([(), (1,), (3,), "each", "grey"]),
    step=st.sampled_from([1, 2, -1]),
)
def test_any_arrays_of_entries(context: ty.Context, milk: ty.Scene, leading: Any, kind: str, weight: Any, step: int) -> None:
    """Clear walks, with no extinction: every weight leaves as it entered."""
    count = int(np.prod(leading))
    position = np.zeros((*leading, 6), kind)[..., ::step]
    shape = {"each": (*leading, 3), "grey": (*leading, 1)}.get(weight, weight)
    weights = 1 + np.arange(np.prod(shape, dtype=int)).reshape(shape)
    exits = context.walk(milk, position[..., :3], [0, 0, 1], weight=weights, sigma_t=0)
    assert exits.shape == (leading or (1,)) and exits.ledger is not None and exits.ledger.walks == count
    expected = np.broadcast_to(weights, (*leading, 3)).reshape(-1, 3)
    assert np.allclose(exits["weight"].reshape(-1, 3), expected)
