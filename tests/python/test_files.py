# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Files, against other programs' readers and writers of the same formats."""

from __future__ import annotations

import json
import os
import pathlib
import struct
import subprocess
import sys
import warnings
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from scenes import cube

import tyndall as ty
from tyndall import errors

SIZE: dict[str, int] = {"width": 9, "height": 7}


def glb(path: pathlib.Path, **changes: Any) -> pathlib.Path:
    """A GLB of a cube of edge 2 about (5, 0, 0) of the material "wax", a light and a camera; `changes` to its JSON."""
    corners, triangles = cube()
    positions, indices = corners.astype("<f4").tobytes(), triangles.astype("<u2").tobytes()
    document = {
        "asset": {"version": "2.0"},
        "extensionsUsed": ["KHR_lights_punctual"],
        "extensions": {"KHR_lights_punctual": {"lights": [{"type": "directional", "intensity": 2.0}]}},
        "scene": 0,
        "scenes": [{"nodes": [0, 1, 2]}],
        "nodes": [
            {"mesh": 0, "translation": [5, 0, 0]},
            {"camera": 0, "translation": [5, 0, 6]},
            {"extensions": {"KHR_lights_punctual": {"light": 0}}},
        ],
        "cameras": [{"type": "perspective", "perspective": {"yfov": 0.5, "znear": 0.1}}],
        "materials": [{"name": "wax", "pbrMetallicRoughness": {"metallicFactor": 0.0}}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 8, "type": "VEC3", "min": [-1] * 3, "max": [1] * 3},
            {"bufferView": 1, "componentType": 5123, "count": 36, "type": "SCALAR"},
        ],
        "bufferViews": [
            {"buffer": 0, "byteLength": len(positions)},
            {"buffer": 0, "byteOffset": len(positions), "byteLength": len(indices)},
        ],
        "buffers": [{"byteLength": len(positions) + len(indices)}],
        **changes,
    }
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<I4s", len(text), b"JSON") + text
    chunks += struct.pack("<I4s", len(positions + indices), b"BIN\0") + positions + indices
    path.write_bytes(struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks)
    return path


@pytest.fixture
def model(tmp_path: pathlib.Path) -> pathlib.Path:
    return glb(tmp_path / "cube.glb")


@pytest.fixture(scope="module")
def image(context: ty.Context, tmp_path_factory: pytest.TempPathFactory) -> ty.Image:
    """With all kinds of layers: an opaque cube against a bright background."""
    scene = context.load(glb(tmp_path_factory.mktemp("model") / "cube.glb"), environment=[0.2, 0.5, 1.5])
    return context.render(scene, **SIZE, spp=3, seed=11, camera=scene.frame(9 / 7))


# ---- glTF ----


def test_a_model_with_everything(context: ty.Context, model: pathlib.Path) -> None:
    for path in (model, str(model)):
        scene = context.load(path)
        assert scene.committed
        info = scene.info
        assert (info.mesh_count, info.triangle_count, info.light_count, info.camera_count) == (1, 12, 1, 1)
        assert (info.medium_count, info.has_environment) == (0, False)
        np.testing.assert_array_equal(info.lower, [4, -1, -1])
        np.testing.assert_array_equal(info.upper, [6, 1, 1])
        mesh = scene.mesh_info(0)
        assert mesh.closed and mesh.area == pytest.approx(24) and mesh.volume == pytest.approx(8)
        assert context.renderer(scene, **SIZE).camera.yfov == pytest.approx(0.5)


def test_materials_become_media(context: ty.Context, model: pathlib.Path) -> None:
    for medium in ("marble", {"wax": "marble"}, {"ALL": "skin1", "wax": "marble"}):
        scene = context.load(model, medium=medium)
        assert scene.mesh_info(0).medium == 0
        found = scene.medium(0)
        np.testing.assert_allclose(found.sigma_s, [2190, 2620, 3000], rtol=1e-6)  # Jensen et al. 2001, in 1/m
        np.testing.assert_allclose(found.sigma_a, [2.1, 4.1, 7.1], rtol=1e-6)


def test_surroundings(context: ty.Context, model: pathlib.Path) -> None:
    """What rays that miss see is what was asked for."""
    for given_radiance, expected in (
        (0.25, (0.25,) * 3),
        ([1.0, 2.0, 3.0], (1, 2, 3)),
        (ty.Environment(radiance=2.0), (2,) * 3),
    ):
        scene = context.load(model, environment=given_radiance, lights=False)
        assert scene.info.light_count == 0 and scene.info.has_environment
        away = ty.Camera(world_from_camera=[[1, 0, 0, 50], [0, 1, 0, 0], [0, 0, 1, 0]])
        beauty = context.render(scene, **SIZE, spp=1, camera=away).beauty
        np.testing.assert_array_equal(beauty, np.broadcast_to([*expected, 0], (7, 9, 4)))


def test_an_environment_from_a_file(context: ty.Context, model: pathlib.Path, tmp_path: pathlib.Path) -> None:
    """The upper half of the image is one colour and the lower another: rays that go up see the first, those down the second."""
    openexr = pytest.importorskip("OpenEXR")
    colors = np.array([(2.0, 1.0, 0.5), (0.25, 0.0, 4.0)], np.float32)
    pixels = np.repeat(colors, 8, axis=0)[:, None].repeat(32, axis=1)
    openexr.File({"type": openexr.scanlineimage}, {"RGB": np.ascontiguousarray(pixels)}).write(str(tmp_path / "sky.exr"))
    scene = context.load(model, environment=tmp_path / "sky.exr", lights=False)
    up = ty.Camera(world_from_camera=[[1, 0, 0, 50], [0, 0, -1, 0], [0, 1, 0, 0]], yfov=0.2)  # its back, column 2, is -Y
    down = ty.Camera(world_from_camera=[[1, 0, 0, 50], [0, 0, 1, 0], [0, -1, 0, 0]], yfov=0.2)
    for view, expected in ((up, colors[0]), (down, colors[1])):
        beauty = context.render(scene, **SIZE, spp=1, camera=view).beauty[..., :3]
        np.testing.assert_allclose(beauty, np.broadcast_to(expected, (7, 9, 3)), rtol=1e-6)
    open_scene = context.load(model, commit=False)
    assert not open_scene.committed and open_scene.load_exr(str(tmp_path / "sky.exr")) == 0
    open_scene.set_environment(ty.Environment(radiance=0.5, image=0))
    open_scene.commit()
    beauty = context.render(open_scene, **SIZE, spp=1, camera=up).beauty[..., :3]
    np.testing.assert_allclose(beauty, np.broadcast_to(colors[0] / 2, (7, 9, 3)), rtol=1e-6)


def test_models_are_added_to_what_is_there(context: ty.Context, model: pathlib.Path) -> None:
    scene = context.scene()
    scene.load_gltf(model)
    scene.load_gltf(model, medium="cream", lights=False)
    assert (scene.info.mesh_count, scene.info.medium_count, scene.info.light_count) == (2, 1, 1)
    scene.commit()
    with pytest.raises(errors.InvalidOperationError, match="committed"):
        scene.load_gltf(model)
    with pytest.raises(errors.InvalidArgumentError, match="metres_per_unit"):
        context.scene(metres_per_unit=0.5).load_gltf(model)


def test_warnings_come_at_the_callers_line_or_as_errors(context: ty.Context, tmp_path: pathlib.Path) -> None:
    model = glb(tmp_path / "odd.glb", extensionsUsed=["KHR_lights_punctual", "EXT_odd"])
    for load in (lambda: context.load(model), lambda: context.scene().load_gltf(model)):
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            load()
        assert [one.category for one in caught] == [errors.TyndallWarning] and "EXT_odd" in str(caught[0].message)
        assert caught[0].filename == __file__
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            with pytest.raises(errors.TyndallWarning, match="EXT_odd"):
                load()


def test_bad_models(context: ty.Context, model: pathlib.Path, tmp_path: pathlib.Path) -> None:
    whole = model.read_bytes()
    bad = tmp_path / "bad.glb"
    for content in (b"", b"glTF", whole[:40], whole[:-30], b"glTF" + whole[4:].replace(b'"2.0"', b'"3.0"'), b"\0" * 100, b"{}"):
        bad.write_bytes(content)
        with pytest.raises(errors.FormatError, match=r"bad\.glb"):
            context.load(bad)
    for indices in ([0, 1, 9] * 12, [0, 1, 300] * 12):
        bad.write_bytes(whole[:-72] + struct.pack("<36H", *indices))
        with pytest.raises(errors.FormatError, match=r"bad\.glb"):
            context.load(bad)
    for error in (errors.FileError, OSError):
        with pytest.raises(error, match=r"no\.glb"):
            context.load(tmp_path / "no.glb")
    for options, message in (
        ({"medium": "custard"}, "custard.*skimmilk"),
        ({"medium": {"stone": "marble"}}, "stone.*wax"),
        ({"medium": 3}, "medium is 3"),
        ({"medium": {"wax": ty.Medium(1, 1)}}, "name of a preset"),
        ({"medium": "mar\0ble"}, "zero byte"),
        ({"environment": -1}, "radiance"),
        ({"environment": [1, 2]}, r"shape \(2,\)"),
        ({"environment": np.nan}, "radiance"),
    ):
        with pytest.raises(errors.InvalidArgumentError, match=message):
            context.load(model, **options)
    with pytest.raises(errors.FileError, match=r"no\.exr"):
        context.load(model, environment=str(tmp_path / "no.exr"))
    with pytest.raises(errors.FormatError, match=r"cube\.glb"):
        context.load(model, environment=model)
    with pytest.raises(errors.FileError, match="at most 100"):
        context.load(model, max_file_bytes=100)
    with pytest.raises(errors.FormatError, match="triangles"):
        context.load(model, max_triangles=11)
    for path, message in ((3, "path is 3"), (None, "path is None"), ("a\0b", "zero byte")):
        with pytest.raises(errors.InvalidArgumentError, match=message):
            context.load(path)


# ---- pictures ----


def letters(name: str) -> str:
    return {"beauty": "RGBA", "normal": "XYZ", "depth": "Z", "samples": "Y"}.get(name, "RGB")


def test_exr_files_hold_all_layers(image: ty.Image, tmp_path: pathlib.Path) -> None:
    openexr = pytest.importorskip("OpenEXR")
    path = tmp_path / "picture.exr"
    ty.write_exr(path, image, attributes={"subject": "a cube", "number": 3})
    file = openexr.File(str(path), separate_channels=True)
    channels = file.channels()
    for name in image:
        for index, letter in enumerate(letters(name)):
            channel = channels.pop(letter if name == "beauty" else f"{name}.{letter}")
            np.testing.assert_array_equal(channel.pixels, image[name][..., index])
            assert channel.pixels.dtype == np.float32
    assert not channels
    header = file.header()
    assert (header["subject"], header["number"]) == ("a cube", "3")
    assert (header["tyndall:seed"], header["tyndall:samples"]) == ("11", "3")
    assert "chromaticities" in header


def curve(tone: str, exposure: float, values: Any) -> Any:
    v = np.maximum(values.astype(float), 0) * 2.0**exposure
    if tone == "aces":
        v = v * (2.51 * v + 0.03) / (v * (2.43 * v + 0.59) + 0.14)
    v = np.minimum(v, 1)
    return np.where(v <= 0.0031308, 12.92 * v, 1.055 * v ** (1 / 2.4) - 0.055)


@settings(max_examples=12, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(
    tone=st.sampled_from(["srgb", "aces"]),
    exposure=st.sampled_from([0, -2.5, 1.0]),
    layer=st.sampled_from(["beauty", "diffuse", "emission", "albedo"]),
)
def test_png_files_hold_the_tone_curve(image: ty.Image, tmp_path: pathlib.Path, tone: str, exposure: float, layer: str) -> None:
    pillow = pytest.importorskip("PIL.Image")
    path = tmp_path / "picture.png"
    ty.write_png(path, image.renderer, exposure=exposure, tone=tone, layer=layer)
    with pillow.open(path) as file:
        assert file.mode == "RGB" and file.size == (9, 7)
        assert ("ACES" in file.text["Tone mapping"]) == (tone == "aces")
        found = np.asarray(file)
    np.testing.assert_allclose(found, 255 * curve(tone, exposure, image[layer][..., :3]), atol=0.51)


def test_png_files_of_data_and_with_alpha(image: ty.Image, tmp_path: pathlib.Path) -> None:
    pillow = pytest.importorskip("PIL.Image")

    def written(**options: Any) -> Any:
        ty.write_png(os.fspath(tmp_path / "picture.png"), image, **options)
        with pillow.open(tmp_path / "picture.png") as file:
            return np.asarray(file)

    alpha = image.beauty[..., 3]
    assert 0 < alpha.mean() < 1
    np.testing.assert_allclose(written(transparent=True)[..., 3], 255 * alpha, atol=0.51)
    np.testing.assert_allclose(written(layer="normal"), 255 * (0.5 + 0.5 * image.normal), atol=0.51)
    assert np.all(written(layer="samples") == 255)


def test_pictures_that_cannot_be_written(context: ty.Context, image: ty.Image, tmp_path: pathlib.Path) -> None:
    for call in (ty.write_exr, ty.write_png):
        with pytest.raises(errors.FileError, match=r"no/x\.y"):
            call(tmp_path / "no" / "x.y", image)
        for thing in (None, image.beauty, "image"):
            with pytest.raises(errors.InvalidArgumentError, match="image is "):
                call(tmp_path / "x.y", thing)
        with pytest.raises(errors.InvalidArgumentError, match="path is 3"):
            call(3, image)
    for options, message in (
        ({"tone": "filmic"}, 'tone is .filmic.; it must be one of "srgb", "aces"'),
        ({"layer": "beuty"}, "layer is 'beuty'"),
        ({"exposure": np.nan}, "exposure is nan"),
    ):
        with pytest.raises(errors.InvalidArgumentError, match=message):
            ty.write_png(tmp_path / "x.y", image, **options)
    for attributes in ({"compression": "none"}, {"": "x"}, {"x": "a\0b"}):
        with pytest.raises(errors.InvalidArgumentError, match="attribute"):
            ty.write_exr(tmp_path / "x.y", image, attributes=attributes)
    scene = image.renderer.scene
    with context.render(scene, **SIZE, spp=1) as closed:
        pass
    with pytest.raises(errors.ClosedError, match="renderer was closed"):
        ty.write_exr(tmp_path / "x.y", closed)
    assert not list(tmp_path.iterdir())


def test_the_library_of_files_is_loaded_when_it_is_used() -> None:
    """Importing the package and asking for everything in it leaves libtyndall-io alone."""
    program = (
        "import tyndall as ty; [getattr(ty, name) for name in ty.__all__];"
        "loaded = lambda: print('tyndall-io' in open('/proc/self/maps').read());"
        "loaded(); ty.capi.io.tyn_png_write; loaded()"
    )
    if not os.path.exists("/proc/self/maps"):
        pytest.skip("needs /proc/self/maps")
    result = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert result.stdout.split() == ["False", "True"]
