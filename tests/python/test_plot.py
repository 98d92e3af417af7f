# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Pictures of results: what is drawn is what the library says."""

from __future__ import annotations

import pathlib
import subprocess
import sys
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from scenes import add_mesh, cube, light_everywhere

import tyndall as ty
from tyndall import errors, plot

matplotlib = pytest.importorskip("matplotlib")
matplotlib.use("Agg")
plt = pytest.importorskip("matplotlib.pyplot")

SKIN = ty.Medium([0.032, 0.17, 0.48], [0.74, 0.88, 1.01], ior=1.3, metres_per_unit=1e-3)
GREY = ty.Medium(0.1, 2.0, g=0.5)


@pytest.fixture(autouse=True)
def closed_figures() -> Iterator[None]:
    """Draws every figure of a test, which is when matplotlib finds most mistakes, and closes it."""
    yield
    for number in plt.get_fignums():
        plt.figure(number).canvas.draw()
    plt.close("all")


def lines(ax: Any) -> dict[str, Any]:
    return {line.get_label(): line for line in ax.get_lines()}


def legend(ax: Any) -> list[str]:
    return [text.get_text() for text in ax.get_legend().get_texts()]


# ---- profiles ----


def test_profiles_of_channels_and_models(context: ty.Context) -> None:
    dipole = context.bssrdf("standard-dipole", SKIN)
    ax = plot.profile([dipole, "better-dipole"], SKIN, context=context)
    drawn = lines(ax)
    assert list(drawn) == [f"{m}-dipole, {c}" for m in ("standard", "better") for c in ("red", "green", "blue")]
    for name, model in (("standard", dipole), ("better", context.bssrdf("better-dipole", SKIN))):
        for channel, color in enumerate(("red", "green", "blue")):
            r, values = drawn[f"{name}-dipole, {color}"].get_data()
            np.testing.assert_array_equal(values, model.profile(r)[:, channel])
            assert len(r) == 200 and r[0] == pytest.approx(0.01 / 1.49) and r[-1] == pytest.approx(20 / 0.772)
    assert len({drawn[f"standard-dipole, {c}"].get_color() for c in ("red", "green", "blue")}) == 3
    assert drawn["standard-dipole, red"].get_color() == drawn["better-dipole, red"].get_color()
    assert drawn["standard-dipole, red"].get_linestyle() != drawn["better-dipole, red"].get_linestyle()
    assert legend(ax) == ["standard-dipole", "better-dipole", "red", "green", "blue"]
    assert (ax.get_xscale(), ax.get_yscale()) == ("log", "log")
    assert "(mm)" in ax.get_xlabel() and "mm$^{-2}$" in ax.get_ylabel()
    assert not ax.collections  # no errors to show


def test_profiles_of_one_channel_on_axes_that_are_given(context: ty.Context) -> None:
    figure, (left, right) = plt.subplots(1, 2)
    radii = [3.0, 1.0, 2.0]
    ax = plot.profile({"mine": "standard-dipole"}, GREY, radii=radii, channels=["near infrared"], context=context, ax=right)
    assert ax is right and not left.get_lines() and plt.get_fignums() == [figure.number]
    r, values = lines(ax)["mine"].get_data()
    np.testing.assert_array_equal(r, [1, 2, 3])
    np.testing.assert_array_equal(values, context.bssrdf("standard-dipole", GREY).profile([1, 2, 3])[:, 0])
    assert legend(ax) == ["mine"] and "mm" not in ax.get_xlabel()


def test_bands_of_exact_are_two_standard_errors() -> None:
    with ty.Context(cache_directory="") as own:
        model = own.bssrdf("exact", ty.Medium(0.1, 0.9), exact_events=1_000_000)
        ax = plot.profile(model, radii=[0.5, 1.0, 2.0])
        (band,) = ax.collections
        corners = {tuple(np.float32(corner)) for corner in band.get_paths()[0].vertices}
        value, error = model.profile([0.5, 1.0, 2.0])[:, 0], model.profile_error([0.5, 1.0, 2.0])[:, 0]
        for r, low, high in zip((0.5, 1.0, 2.0), value - 2 * error, value + 2 * error):
            heights = sorted(y for x, y in corners if x == r)
            assert heights[0] == pytest.approx(low, rel=1e-5) and heights[-1] == pytest.approx(high, rel=1e-5) and low < high
        assert not plot.profile(model, radii=[0.5, 1.0], errors=False).collections


def test_measured_profiles_are_steps_per_light_that_gets_in(context: ty.Context) -> None:
    medium = ty.Medium(0.1, 0.9, ior=1.5)
    result = context.slab(medium, photons=20000, radial=(5.0, 10))
    ax = plot.profile({"walks": result, "model": context.bssrdf("better-dipole", medium)}, radii=[0.5, 1.0, 5.0])
    (steps,) = (one for one in ax.patches if one.get_label() == "walks")
    values, edges, _ = steps.get_data()
    surface = ((1.5 - 1) / (1.5 + 1)) ** 2  # Fresnel, perpendicularly
    np.testing.assert_allclose(values, np.asarray(result.radial.reflectance)[:, 0] / (1 - surface), rtol=1e-6)
    np.testing.assert_allclose(edges, [0.25, *np.arange(1, 11) / 2])  # not from 0, which the axis does not have
    (band,) = ax.collections
    corners = band.get_paths()[0].vertices
    spread = 2 * result.radial.reflectance.stderr[:, 0] / (1 - surface)
    for place in range(10):
        heights = [y for x, y in corners if edges[place] <= x < edges[place + 1]]
        for expected in (values[place] - spread[place], values[place] + spread[place]):
            assert np.min(np.abs(np.array(heights) / expected - 1)) < 1e-6
    assert legend(ax) == ["walks", "model"] and ax.get_xlim() == (0.5, 5)
    alone = plot.profile(result, errors=False)
    assert not alone.collections and alone.get_xlim() == (0.25, 5) and legend(alone) == ["walks"]
    assert alone.get_ylim()[0] < values.min() and alone.get_ylim()[1] > values.max()


def test_bad_profiles(context: ty.Context) -> None:
    grey, color = (context.bssrdf("standard-dipole", one) for one in (GREY, SKIN))
    other_unit = context.bssrdf("standard-dipole", SKIN.converted(1.0))
    for call, message in (
        (lambda: plot.profile([]), "models is empty"),
        (lambda: plot.profile("standard-dipole"), "there is no medium"),
        (lambda: plot.profile("dipole", GREY, context=context), "model is 'dipole'"),
        (lambda: plot.profile([3]), "models holds 3"),
        (lambda: plot.profile(context.slab(GREY, photons=1)), r"walks is a SlabResult without R\(r\)"),
        (lambda: plot.profile([color, context.slab(GREY, photons=1, radial=(1, 2))]), r"\[1, 3\] channels"),
        (lambda: plot.albedo(context.slab(GREY, photons=1)), "models must be names"),
        (lambda: plot.profile([grey, color]), r"\[1, 3\] channels"),
        (lambda: plot.profile([color, other_unit]), "different units"),
        (lambda: plot.profile(grey, radii=[0.0, 1.0]), r"radii\[0\] is 0"),
        (lambda: plot.profile(grey, radii=[[1.0]]), "radii has the shape"),
        (lambda: plot.profile(color, channels=["one"]), "channels has 1 names; there are 3"),
        (lambda: plot.profile(grey, ax=3), "ax is 3"),
    ):
        with pytest.raises(errors.InvalidArgumentError, match=message):
            call()
    grey.close()
    with pytest.raises(errors.ClosedError):
        plot.profile(grey)


# ---- albedos ----


def test_albedos_of_models_over_the_single_scattering_albedo(context: ty.Context) -> None:
    """The curve of the standard dipole against its closed form (Jensen & Buhler 2002, eq. 15), index-matched."""
    x = np.linspace(0, 1, 5)
    ax = plot.albedo({"dipole": "standard-dipole"}, single_scattering_albedo=x, context=context)
    drawn_x, drawn_y = lines(ax)["dipole"].get_data()
    np.testing.assert_array_equal(drawn_x, x)
    fresnel = -1.440 + 0.710 + 0.668 + 0.0636
    a = (1 + fresnel) / (1 - fresnel)
    root = np.sqrt(3 * (1 - x))
    np.testing.assert_allclose(drawn_y, x / 2 * (1 + np.exp(-4 / 3 * a * root)) * np.exp(-root), rtol=1e-6, atol=1e-12)
    assert "single-scattering albedo" in ax.get_xlabel() and legend(ax) == ["dipole"]


def test_media_are_marked_among_albedos(context: ty.Context) -> None:
    ax = plot.albedo("normalized-diffusion", single_scattering_albedo=[0.5, 1], media={"skin": SKIN}, context=context)
    expected = context.bssrdf("normalized-diffusion", SKIN).albedo
    marks = [line.get_xydata()[0] for line in ax.get_lines() if line.get_marker() == "o" and len(line.get_xdata())]
    np.testing.assert_allclose(marks, np.stack([SKIN.albedo, expected], axis=1), rtol=1e-12)
    assert legend(ax) == ["normalized-diffusion", "skin"]
    model = context.bssrdf("standard-dipole", SKIN)
    for call, message in (
        (lambda: plot.albedo(model), "must be names"),
        (lambda: plot.albedo("standard-dipole", single_scattering_albedo=[0.5, 1.5], context=context), "albedo is"),
        (lambda: plot.albedo("standard-dipole", single_scattering_albedo=0.5, context=context), "shape"),
    ):
        with pytest.raises(errors.InvalidArgumentError, match=message):
            call()


# ---- pictures ----


@pytest.fixture(scope="module")
def picture(context: ty.Context) -> ty.Image:
    scene = context.scene(metres_per_unit=1e-3)
    material = scene.add_material(ty.Material(base_color=(0.6, 0.3, 0.1), ior=1.0))
    add_mesh(scene, *cube(), material=material)
    light_everywhere(scene, 0.8)
    scene.commit()
    return context.render(scene, width=10, height=8, spp=2)


@pytest.mark.parametrize("tone", ["srgb", "aces"])
@pytest.mark.parametrize("layer", ["beauty", "normal", "albedo"])
def test_pictures_are_those_of_png_files(picture: ty.Image, tmp_path: pathlib.Path, layer: str, tone: str) -> None:
    pillow = pytest.importorskip("PIL.Image")
    (drawn,) = plot.image(picture, layer, tone=tone, exposure=-0.5).get_images()
    ty.write_png(tmp_path / "x.png", picture, layer=layer, tone=tone, exposure=-0.5)
    with pillow.open(tmp_path / "x.png") as file:
        expected = np.asarray(file)
    assert expected.std() > 1
    np.testing.assert_allclose(255 * drawn.get_array(), expected, atol=0.51)


def test_depth_and_samples_have_a_bar(picture: ty.Image) -> None:
    ax = plot.image(picture, "depth")
    (drawn,) = ax.get_images()
    assert 0 < drawn.get_array().mask.sum() < 80
    np.testing.assert_array_equal(drawn.get_array().filled(np.inf), picture.depth[..., 0])
    assert [other.get_ylabel() for other in ax.figure.axes if other is not ax] == ["depth (mm)"]
    (drawn,) = plot.image(picture, "samples").get_images()
    assert np.all(drawn.get_array() == 2)


def test_pixels_are_drawn_as_the_layer_is(picture: ty.Image) -> None:
    drawn = [plot.image(one, tone="aces", exposure=1.0).images[0].get_array() for one in (picture, picture.beauty)]
    assert np.array_equal(*drawn)


def test_bad_pictures(picture: ty.Image) -> None:
    for call, message in (
        (lambda: plot.image(picture.beauty[..., 0]), "must be a tyndall.Image, or pixels"),
        (lambda: plot.image(picture.depth), "height x width x 3 or 4"),
        (lambda: plot.image("beauty"), "img is 'beauty'"),
        (lambda: plot.image(picture, "beuty"), "layer is 'beuty'"),
        (lambda: plot.image(picture, tone="filmic"), "tone is 'filmic'"),
        (lambda: plot.image(picture, exposure=np.nan), "exposure is nan"),
        (lambda: plot.image(ty.Image(picture.renderer, ["depth"])), 'it must be one of "depth"'),
    ):
        with pytest.raises(errors.InvalidArgumentError, match=message):
            call()


# ---- walks ----


def ball(context: ty.Context, ior: float = 1.0) -> ty.Scene:
    scene = context.scene(metres_per_unit=1e-3)
    scene.add_mesh(*ty.shapes.sphere(1.0, 1), medium=ty.Medium(0.2, 4.0, g=0.3, ior=ior))
    scene.commit()
    return scene


def test_walks_pass_every_point_where_they_scatter(context: ty.Context) -> None:
    """In an index-matched medium nothing turns between two of them, so that the way along them is the path length."""
    scene = ball(context)
    numbers = np.array([5, 1 << 40, 3, 0, 2**64 - 9, 7, 7, 1, 2], np.uint64)
    entries = ty.walk_entries(np.zeros((9, 3)), (0, 0, 1), path=numbers)
    exits = context.walk(scene, entries, seed=4, first_path=11, roulette=False)
    paths = plot.walk_paths(scene, entries, seed=4, first_path=11)
    assert np.all(exits.escaped) and exits["scatterings"].max() > 5
    for path, end in zip(paths, exits):
        assert len(path) == end["scatterings"] + 2 and path.dtype == np.float32
        np.testing.assert_array_equal(path[0], [0, 0, 0])
        np.testing.assert_array_equal(path[-1], end["position"])
        steps = np.linalg.norm(np.diff(path.astype(float), axis=0), axis=1)
        assert steps.sum() == pytest.approx(end["path_length"], rel=1e-5)
        assert np.all(steps > 0)
        np.testing.assert_allclose(np.cross(path[1], [0, 0, 1]), 0, atol=1e-6)  # the first flight goes straight on
    short = plot.walk_paths(scene, entries, seed=4, first_path=11, max_scatterings=2)
    for path, whole in zip(short, paths):
        np.testing.assert_array_equal(path, whole[: len(path)])
        assert len(path) == min(3, len(whole))


def test_walks_are_drawn(context: ty.Context) -> None:
    scene = ball(context, ior=1.4)
    entries = ty.walk_entries(np.zeros((4, 3)), (0, 0, 1))
    mesh = ty.shapes.sphere(1.0, 1)
    paths = plot.walk_paths(scene, entries, seed=1)
    ax = plot.walk(scene, entries, mesh=mesh, seed=1)
    assert ax.name == "3d" and "(mm)" in ax.get_zlabel() and legend(ax) == ["entry", "exit"]
    flat = plot.walk(scene, entries, view="zx", mesh=mesh, seed=1, ax=plt.figure().add_subplot())
    assert flat.get_xlabel() == "z (mm)" and flat.get_ylabel() == "x (mm)" and len(flat.collections) == 1
    for number, path in enumerate(paths):
        np.testing.assert_array_equal(np.transpose(lines(ax)[f"walk {number}"].get_data_3d()), path)
        np.testing.assert_array_equal(np.transpose(lines(flat)[f"walk {number}"].get_data()), path[:, [2, 0]])
    np.testing.assert_array_equal(np.transpose(lines(flat)["exit"].get_data()), [path[-1, [2, 0]] for path in paths])


def test_bad_walks(context: ty.Context) -> None:
    scene = ball(context)
    entries = ty.walk_entries(np.zeros((1, 3)), (0, 0, 1))
    for call, message in (
        (lambda: plot.walk(scene, np.zeros((1, 3))), "WALK_ENTRY"),
        (lambda: plot.walk(scene, entries, view="xx"), "view is 'xx'"),
        (lambda: plot.walk(scene, entries, mesh=([[0, 0, 0]], [[0, 0, 1]])), "vertex 1"),
        (lambda: plot.walk(scene, entries, ax=plt.figure().add_subplot()), "projection"),
        (lambda: plot.walk(None, entries), "scene is None; it must be a tyndall.Scene"),
        (lambda: plot.walk_paths(scene, entries, max_scatterings=0), "max_scatterings is 0"),
    ):
        with pytest.raises(errors.InvalidArgumentError, match=message):
            call()


# ---- matplotlib ----


def test_matplotlib_is_imported_when_something_is_drawn_and_missed_clearly() -> None:
    program = (
        "import sys, tyndall as ty; assert not [m for m in sys.modules if m.split('.')[0] in ('matplotlib', 'scipy', 'tqdm')];"
        "sys.modules['matplotlib'] = None; ty.plot.albedo('gaussians')"
    )
    result = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert result.stderr.strip().endswith("ModuleNotFoundError: tyndall.plot needs matplotlib: pip install 'tyndall[plot]'")
