# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Rendering, against furnaces and the C API in its raw form."""

from __future__ import annotations

import copy
import ctypes
import os
import pickle
import signal
import threading
import warnings
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from scenes import add, add_mesh, cube, light_everywhere

import tyndall as ty
from tyndall import capi, errors

SIZE: dict[str, int] = {"width": 12, "height": 8}


def cube_scene(context: ty.Context, radiance: float = 1.0, sigma_a: float = 0.0, walk: bool = True) -> ty.Scene:
    """A cube of edge 2 in light from everywhere: index-matched and scattering, or white and opaque."""
    scene = context.scene()
    fields: dict[str, int] = {}
    material = capi.TynMaterial(ior=1.0, transmission=1.0 if walk else 0.0)
    fields["material"] = add(scene, capi.lib.tyn_scene_add_material, material)
    if walk:
        medium = capi.TynMedium(sigma_a=[sigma_a] * 3, sigma_s=[2.0] * 3)
        fields["medium"] = add(scene, capi.lib.tyn_scene_add_medium, medium)
    add_mesh(scene, *cube(), **fields)
    light_everywhere(scene, radiance)
    scene.commit()
    return scene


@pytest.fixture(scope="module")
def scene(context: ty.Context) -> ty.Scene:
    return cube_scene(context, sigma_a=0.5)


@pytest.mark.parametrize("walk", [True, False])
def test_a_white_cube_in_light_from_everywhere_cannot_be_seen(context: ty.Context, walk: bool) -> None:
    """The furnace: what a white, lossless object sends out is what comes in. Within 5.5 standard errors, of which the film says
    what they are: wrong once in 10^7."""
    image = context.render(cube_scene(context, walk=walk), **SIZE, spp=64)
    layer = "subsurface" if walk else "diffuse"
    seen = image.beauty[..., 3] == 1
    assert 10 < seen.sum() < 96
    error = np.sqrt(image.variance[seen].sum(axis=0)) / seen.sum()
    assert np.all(error < 0.01)
    assert np.all(np.abs(image.beauty[seen, :3].mean(axis=0) - 1) < 5.5 * error + 1e-5)
    np.testing.assert_array_equal(image[layer][seen], image.beauty[seen, :3])
    missed = image.beauty[..., 3] == 0
    np.testing.assert_array_equal(image.beauty[missed, :3], 1.0)
    assert np.all(np.isinf(image.depth[missed])) and np.all(np.isfinite(image.depth[seen]))


def test_a_lambertian_square_under_a_distant_light(context: ty.Context) -> None:
    """Radiance base_color / pi x irradiance x cos, without noise."""
    scene = context.scene()
    material = add(scene, capi.lib.tyn_scene_add_material, capi.TynMaterial(base_color=[0.8, 0.4, 0.2], ior=1.0))
    add_mesh(scene, [(-9, -9, 0), (9, -9, 0), (9, 9, 0), (-9, 9, 0)], [(0, 1, 2), (0, 2, 3)], material=material)
    light = capi.TynLight(type=capi.TYN_LIGHT_DIRECTIONAL, direction=[0.6, 0.0, -0.8], intensity=[3.0, 3.0, 3.0])
    add(scene, capi.lib.tyn_scene_add_light, light)
    scene.commit()
    view = ty.Camera(world_from_camera=[[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 2]])
    image = context.render(scene, **SIZE, spp=4, camera=view)
    expected = np.array([0.8, 0.4, 0.2]) / np.pi * 3.0 * 0.8
    np.testing.assert_allclose(image.beauty[..., :3], np.broadcast_to(expected, (8, 12, 3)), rtol=1e-5)
    np.testing.assert_allclose(image.depth, np.full((8, 12, 1), 2.0), rtol=1e-5)
    np.testing.assert_allclose(image.normal, np.broadcast_to([0.0, 0.0, 1.0], (8, 12, 3)), atol=1e-5)
    assert image.renderer.camera == view


def test_films_have_the_bits_of_the_raw_calls(context: ty.Context, scene: ty.Scene) -> None:
    image = context.render(scene, **SIZE, spp=6, seed=4, max_bounces=9, exit="dielectric")
    options = capi.TynRenderOptions(width=12, height=8, seed=4, max_bounces=9, exit=capi.TYN_EXIT_DIELECTRIC)
    assert capi.lib.tyn_scene_frame(scene.handle, 1.5, ctypes.byref(options.camera)) == capi.TYN_OK
    raw = ctypes.POINTER(capi.TynRenderer)()
    assert capi.lib.tyn_renderer_create(scene.handle, ctypes.byref(options), ctypes.byref(raw)) == capi.TYN_OK
    try:
        for samples in (2, 4):
            assert capi.lib.tyn_renderer_run(raw, ctypes.byref(capi.TynRenderBudget(samples=samples))) == capi.TYN_OK
        assert image.names == ty.Renderer.layers() and len(image) == capi.TYN_LAYER_COUNT
        for layer, name in enumerate(image):
            pixels = np.empty((8, 12, capi.lib.tyn_layer_channels(layer)), np.float32)
            where = pixels.ctypes.data_as(ctypes.POINTER(ctypes.c_float))
            assert capi.lib.tyn_renderer_read(raw, layer, where, pixels.size) == capi.TYN_OK
            np.testing.assert_array_equal(image[name], pixels)
        stats = capi.TynRenderStats()
        assert capi.lib.tyn_renderer_stats(raw, ctypes.byref(stats)) == capi.TYN_OK
        found = image.stats
        assert (found.width, found.height, found.samples, found.seed) == (12, 8, 6, 4)
        assert (found.paths, found.error, found.nonfinite_paths) == (stats.paths, stats.error, 0)
        assert found.ledger.walks == stats.ledger.walks > 0
        np.testing.assert_array_equal(found.ledger.absorbed, list(stats.ledger.absorbed))
    finally:
        capi.lib.tyn_renderer_release(raw)


def test_samples_split_over_runs_give_the_same_film(context: ty.Context, scene: ty.Scene) -> None:
    renderer = context.renderer(scene, **SIZE)
    heard: list[float] = []
    for spp in (1, 3, 4):
        renderer.run(spp, progress=heard.append)
    whole = context.render(scene, **SIZE, spp=8)
    np.testing.assert_array_equal(renderer.read("beauty"), whole.beauty)
    assert renderer.stats.samples == 8 and np.all(renderer.read("samples") == 8)
    assert heard and all(0 <= one <= 1 for one in heard)
    later = ty.Image(renderer, ["beauty", "depth"])
    assert later.names == ["beauty", "depth"] and later.beauty.shape == (8, 12, 4) and later.depth.shape == (8, 12, 1)


def test_limits_of_time_and_error_end_a_run(context: ty.Context, scene: ty.Scene) -> None:
    renderer = context.renderer(scene, **SIZE)
    renderer.run(0, target_error=0.5)
    assert 16 <= renderer.stats.samples < 4096 and 0 < renderer.stats.error <= 0.5
    before = renderer.stats.samples
    renderer.run(0, seconds=0.02)
    assert renderer.stats.samples > before


def test_a_model_in_place_of_walks_has_its_albedo(context: ty.Context) -> None:
    """A plane wide against the mean free path, index-matched, in diffuse light: radiance is the albedo of the model, which is 1
    for normalized diffusion in a white medium."""
    scene = context.scene()
    material = add(scene, capi.lib.tyn_scene_add_material, capi.TynMaterial(ior=1.0, transmission=1.0))
    medium = add(scene, capi.lib.tyn_scene_add_medium, capi.TynMedium(sigma_a=[0.0] * 3, sigma_s=[200.0] * 3))
    add_mesh(scene, *cube(), material=material, medium=medium)
    light_everywhere(scene)
    scene.commit()
    view = ty.Camera(world_from_camera=[[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 2.0]], yfov=0.5)
    image = context.render(scene, **SIZE, spp=64, camera=view, bssrdf="normalized-diffusion")
    error = np.sqrt(image.variance.sum(axis=(0, 1))) / 96
    assert np.all(error < 0.01)
    assert np.all(np.abs(image.subsurface.mean(axis=(0, 1)) - 1) < 5.5 * error + 1e-4)


def test_default_cameras(context: ty.Context, scene: ty.Scene) -> None:
    frame = capi.TynCamera()
    assert capi.lib.tyn_scene_frame(scene.handle, 2.0, ctypes.byref(frame)) == capi.TYN_OK
    assert context.renderer(scene, width=20, height=10).camera == ty.Camera.of(frame)
    own = context.scene()
    add_mesh(own, *cube())
    light_everywhere(own)
    for yfov in (0.5, 0.75):
        add(own, capi.lib.tyn_scene_add_camera, capi.TynCamera(yfov=yfov))
    own.commit()
    assert context.renderer(own).camera.yfov == 0.5
    assert context.renderer(own, camera=1).camera.yfov == 0.75
    assert context.renderer(own, camera=np.int64(1)).camera.yfov == 0.75
    with pytest.raises(errors.InvalidArgumentError, match="camera is 2; the scene has 2 cameras"):
        context.renderer(own, camera=2)


def test_images_outlive_their_renderer(context: ty.Context, scene: ty.Scene) -> None:
    with context.render(scene, **SIZE, spp=1) as image:
        before = image.beauty.copy()
        assert not image.closed
    assert image.closed and image.renderer.closed
    np.testing.assert_array_equal(image["beauty"], before)
    assert image.beauty.dtype == np.float32 and image.beauty.flags.owndata
    assert "beauty" in image and "beauty" in dir(image) and "12 x 8, 1 samples" in repr(image)
    with pytest.raises(errors.ClosedError, match="renderer was closed"):
        image.renderer.run(1)
    with pytest.raises(KeyError, match="there are: beauty, "):
        image["beuty"]
    with pytest.raises(AttributeError, match="its layers are: beauty, "):
        image.beuty  # noqa: B018


@settings(max_examples=8, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(width=st.integers(1, 33), height=st.integers(1, 17))
def test_sizes(context: ty.Context, scene: ty.Scene, width: int, height: int) -> None:
    image = context.render(scene, width=width, height=height, spp=1)
    for name, layer in image.items():
        channels = {"beauty": 4, "depth": 1, "samples": 1}.get(name, 3)
        assert layer.shape == (height, width, channels) and layer.dtype == np.float32 and layer.flags.c_contiguous
    parts = sum(image[name] for name in ("subsurface", "specular", "diffuse", "emission"))
    np.testing.assert_allclose(parts, image.beauty[..., :3], rtol=1e-4, atol=1e-5)


# ---- ends before the end ----


def test_a_cancelled_render_has_what_was_done(context: ty.Context, scene: ty.Scene) -> None:
    with pytest.raises(errors.CancelledError) as caught:
        context.render(scene, **SIZE, spp=100000, progress=lambda fraction: fraction > 0)
    image = caught.value.result
    assert isinstance(image, ty.Image) and 0 < image.stats.samples < 100000
    same = context.render(scene, **SIZE, spp=image.stats.samples)
    np.testing.assert_array_equal(image.beauty, same.beauty)
    image.renderer.run(2)
    assert image.renderer.stats.samples == image.stats.samples + 2


def test_exceptions_of_the_listener_come_out(context: ty.Context, scene: ty.Scene) -> None:
    renderer = context.renderer(scene, **SIZE)

    def fail(fraction: float) -> None:
        raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        renderer.run(100000, progress=fail)
    assert np.all(np.isfinite(renderer.read("beauty")))
    with pytest.raises(errors.InvalidOperationError, match="progress callback"):
        renderer.run(100000, progress=lambda fraction: renderer.read("beauty"))


def test_ctrl_c_ends_a_render_and_keeps_the_film(context: ty.Context, scene: ty.Scene) -> None:
    renderer = context.renderer(scene, **SIZE)
    renderer.run(1)
    timer = threading.Timer(0.1, os.kill, (os.getpid(), signal.SIGINT))
    with pytest.raises(KeyboardInterrupt):
        timer.start()
        renderer.run(0, seconds=20)
    timer.join()
    samples = renderer.stats.samples
    assert samples > 1 and renderer.stats.seconds < 10
    np.testing.assert_array_equal(renderer.read("beauty"), context.render(scene, **SIZE, spp=samples).beauty)


# ---- what goes wrong ----


def test_scenes_that_cannot_be_rendered(context: ty.Context, scene: ty.Scene) -> None:
    open_scene = context.scene()
    add_mesh(open_scene, *cube())
    with pytest.raises(errors.InvalidOperationError, match=r"not committed; call its commit\(\) first"):
        context.render(open_scene)
    with pytest.raises(errors.InvalidOperationError, match="not committed"):
        context.renderer(open_scene)
    open_scene.close()
    with pytest.raises(errors.ClosedError):
        context.render(open_scene)
    with pytest.raises(errors.InvalidArgumentError, match=r"scene is .*Path"):
        context.render("Path")  # type: ignore[arg-type]
    with ty.Context() as other, pytest.raises(errors.InvalidArgumentError, match="another context"):
        other.render(scene)


def test_a_scene_without_light_is_warned_of_at_the_callers_line(context: ty.Context) -> None:
    for emission, expected in ((0.0, 1), (1.0, 0)):
        scene = context.scene()
        material = add(scene, capi.lib.tyn_scene_add_material, capi.TynMaterial(emission=[emission] * 3))
        add_mesh(scene, *cube(), material=material)
        scene.commit()
        for call in (lambda s: context.renderer(s, **SIZE), lambda s: context.render(s, **SIZE, spp=1)):
            with warnings.catch_warnings(record=True) as caught:
                warnings.simplefilter("always")
                call(scene)
            assert len(caught) == expected
            for one in caught:
                assert issubclass(one.category, errors.TyndallWarning) and "nothing lights the scene" in str(one.message)
                assert one.filename == __file__


def test_bad_arguments(context: ty.Context, scene: ty.Scene) -> None:
    for options, message in (
        ({"width": 0}, "width is 0"),
        ({"height": 32769}, "height is 32769"),
        ({"width": -1}, "width is -1"),
        ({"seed": -1}, "seed is -1"),
        ({"max_bounces": 0}, "max_bounces is 0"),
        ({"exit": "specular"}, 'exit is .specular.; it must be one of "diffuse", "dielectric"'),
        ({"bssrdf": "dipole"}, 'bssrdf is .dipole.; it must be one of "standard-dipole"'),
        ({"bssrdf": "gaussians"}, "gaussians"),
        ({"bssrdf": "exact", "exit": "dielectric"}, "exit"),
        ({"camera": "front"}, "camera is 'front'"),
        ({"camera": 0}, "the scene has 0 cameras"),
        ({"camera": ty.Camera(yfov=4.0)}, "yfov"),
        ({"spp": 0}, "samples, seconds and target_error"),
        ({"spp": -1}, "spp is -1"),
        ({"seconds": -1}, "seconds is -1"),
        ({"target_error": np.nan}, "target_error is nan"),
        ({"layers": "beauty"}, "it must be a list"),
        ({"layers": ["beauty", "beuty"]}, "layers is 'beuty'; it must be one of"),
    ):
        given_options: dict[str, Any] = {**SIZE, "spp": 1, **options}
        with pytest.raises(ValueError, match=message):
            context.render(scene, **given_options)
    for name in ("width", "spp", "seed"):
        with pytest.raises(errors.InvalidArgumentError, match=rf"{name} is 1\.5; it must be an integer"):
            context.render(scene, **{**SIZE, "spp": 1, name: 1.5})  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="progress is 3"):
        context.render(scene, **SIZE, spp=1, progress=3)  # type: ignore[arg-type]
    with pytest.raises(errors.InvalidArgumentError, match="layer is 'beuty'"):
        context.renderer(scene, **SIZE).read("beuty")


@pytest.mark.parametrize("copied", [copy.copy, copy.deepcopy, lambda image: pickle.loads(pickle.dumps(image))])
def test_copies_have_arrays_and_no_renderer(context: ty.Context, tmp_path: Path, copied: Any) -> None:
    with cube_scene(context) as scene:
        light = ty.Renderer(scene, width=4, height=3, seed=5)
        light.run(2)
        with ty.Image(light, ["beauty", "depth"]) as image:
            found = copied(image)
            assert type(found) is ty.Image and found.names == ["beauty", "depth"] and found.closed and found.renderer is None
            for name in found:
                np.testing.assert_array_equal(found[name], image[name])
            assert (found.stats.samples, found.stats.seed, found.stats.width) == (2, 5, 4)
            assert repr(found) == repr(image)
            found.close()
            assert not image.closed  # the copy had nothing of it
            with pytest.raises(ty.errors.ClosedError, match="copy of an Image"):
                ty.write_exr(tmp_path / "copy.exr", found)
