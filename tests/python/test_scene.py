# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Scenes: what goes in, what comes back, and what is refused."""

import ctypes
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from shapes_by_hand import area, edges_twice, volume

import tyndall as ty
from tyndall import capi
from tyndall.errors import ClosedError, InvalidArgumentError, InvalidOperationError

BOX = ty.shapes.box()


@pytest.fixture
def scene(context: ty.Context) -> Iterator[ty.Scene]:
    with context.scene() as one:
        yield one


def hits_of(scene: ty.Scene) -> bytes:
    """What rays see of a scene, which is committed."""
    height = np.linspace(-0.6, 0.6, 13)
    hits = scene.context.intersect(scene, [(-3, y, 0.1) for y in height], [1, 0, 0])
    return bytes(hits.tobytes())


# ---- shapes


@pytest.mark.parametrize("size", [1.0, (0.5, 2.0, 3.0)])
def test_boxes_are_closed_and_face_outwards(size: Any) -> None:
    positions, triangles = ty.shapes.box(size)
    x, y, z = np.broadcast_to(size, 3)
    assert (positions.dtype, triangles.dtype) == (np.float32, np.uint32)
    assert edges_twice(triangles)
    assert volume(positions, triangles) == pytest.approx(x * y * z)
    assert area(positions, triangles) == pytest.approx(2 * (x * y + y * z + z * x))
    assert np.allclose(positions.min(axis=0), np.divide([-x, -y, -z], 2))


@pytest.mark.parametrize("subdivisions", [0, 1, 3])
def test_spheres_are_closed_and_face_outwards(subdivisions: int) -> None:
    positions, triangles = ty.shapes.sphere(2.0, subdivisions)
    assert len(triangles) == 20 * 4**subdivisions and len(positions) == 10 * 4**subdivisions + 2
    assert np.allclose(np.linalg.norm(positions, axis=1), 2)
    assert edges_twice(triangles)
    inside = volume(positions, triangles)
    assert inside < 4 / 3 * np.pi * 8
    if subdivisions == 0:  # of an icosahedron with the circumradius r: (sqrt(10 + 2 sqrt 5) / 4) a = r, 5 (3 + sqrt 5) a^3 / 12
        edge = 2 / (np.sqrt(10 + 2 * np.sqrt(5)) / 4)
        assert inside == pytest.approx(5 * (3 + np.sqrt(5)) * edge**3 / 12)


@pytest.mark.parametrize("size", [0, -1, np.nan, np.inf, (1, 2), (1, 2, 0)])
def test_shapes_refuse_bad_sizes(size: Any) -> None:
    with pytest.raises(InvalidArgumentError, match="size is"):
        ty.shapes.box(size)
    if np.ndim(size) == 0:
        with pytest.raises(InvalidArgumentError, match="radius is"):
            ty.shapes.sphere(size)


@pytest.mark.parametrize("subdivisions", [-1, 11, 1.5])
def test_spheres_refuse_bad_subdivisions(subdivisions: Any) -> None:
    with pytest.raises(InvalidArgumentError, match="subdivisions is"):
        ty.shapes.sphere(1.0, subdivisions)


# ---- meshes


def test_a_mesh_is_described(scene: ty.Scene) -> None:
    positions, triangles = ty.shapes.box((1, 2, 3))
    medium = scene.add_medium(ty.Medium(1, 2))
    material = scene.add_material(ty.Material())
    assert scene.add_mesh(positions, triangles, medium=medium, material=material, name="brick") == 0
    info = scene.mesh_info(0)
    assert (info.name, info.medium, info.material) == ("brick", 0, 0)
    assert (info.vertex_count, info.triangle_count, info.welded_vertex_count) == (8, 12, 8)
    assert info.closed and info.components == 1 and info.turned_triangles == 0
    assert info.area == pytest.approx(22) and info.volume == pytest.approx(6)
    assert np.array_equal(info.lower, [-0.5, -1, -1.5]) and np.array_equal(info.upper, [0.5, 1, 1.5])


def test_a_mesh_without_medium_and_material(scene: ty.Scene) -> None:
    positions, triangles = BOX
    scene.add_mesh(positions, triangles[:-1])
    info = scene.mesh_info(0)
    assert (info.name, info.medium, info.material) == ("", None, None)
    assert not info.closed and info.boundary_edges == 3


def test_a_scene_is_described(context: ty.Context) -> None:
    with context.scene(metres_per_unit=0.01) as scene:
        empty = scene.info
        assert empty.mesh_count == 0 and np.all(empty.lower > empty.upper)
        scene.add_image(np.zeros((2, 3, 4), np.uint8))
        lamp = scene.add_material(ty.Material(emission=2.0))
        scene.add_mesh(*BOX, material=lamp)
        scene.add_mesh(BOX[0] + np.float32(3), BOX[1], medium=ty.Medium(1, 1))
        scene.add_light(ty.Light())
        scene.add_camera(ty.Camera())
        scene.set_environment(ty.Environment(radiance=0.5))
        info = scene.info
        counts = (
            info.mesh_count,
            info.medium_count,
            info.material_count,
            info.image_count,
            info.light_count,
            info.camera_count,
        )
        assert counts == (2, 1, 2, 1, 1, 1)
        assert info.triangle_count == 24 and info.emissive_triangle_count == 12 and info.has_environment is True
        assert info.metres_per_unit == 0.01 == scene.metres_per_unit
        assert np.array_equal(info.lower, [-0.5] * 3) and np.array_equal(info.upper, [3.5] * 3)
        scene.clear_lights()
        assert scene.info.light_count == 0


def test_views_of_records_are_read_by_their_strides(context: ty.Context) -> None:
    """Of vertices in records, with normals and texture coordinates between the positions, as graphics programs keep them."""
    positions, triangles = ty.shapes.sphere(1.0, 1)
    vertices = np.zeros(len(positions), [("position", "f4", 3), ("normal", "f4", 3), ("uv", "f4", 2), ("bone", "u1")])
    vertices["position"], vertices["normal"] = positions, positions
    vertices["uv"] = positions[:, :2]
    whole = {"normals": positions, "uvs": positions[:, :2].copy()}
    found = []
    for arrays in ((positions, whole), (vertices["position"], {"normals": vertices["normal"], "uvs": vertices["uv"]})):
        with context.scene() as scene:
            scene.add_mesh(arrays[0], triangles, medium=ty.Medium(0.1, 2, ior=1.3), **arrays[1])
            scene.commit()
            found.append((scene.mesh_info(0).volume, context.walk(scene, np.zeros((20, 3)), [0, 0.6, 0.8], seed=2).tobytes()))
    assert found[0] == found[1]


@pytest.mark.parametrize("change", ["float64", "big-endian", "fortran", "reversed", "int triangles", "big-endian triangles"])
def test_other_layouts_are_converted(context: ty.Context, change: str) -> None:
    positions, triangles = ty.shapes.sphere(0.5, 1)
    with context.scene() as scene:
        scene.add_mesh(positions, triangles)
        scene.commit()
        expected = hits_of(scene)
    changed: dict[str, Any] = {
        "float64": (positions.astype(np.float64), triangles),
        "big-endian": (positions.astype(">f4"), triangles),
        "fortran": (np.asfortranarray(positions), triangles),
        "reversed": (positions[::-1].copy()[::-1], triangles),
        "int triangles": (positions, triangles.astype(np.int8).astype(np.int64)),
        "big-endian triangles": (positions, triangles.astype(">u4")),
    }
    with context.scene() as scene:
        scene.add_mesh(*changed[change])
        scene.commit()
        assert hits_of(scene) == expected


def test_lists_are_converted(scene: ty.Scene) -> None:
    scene.add_mesh([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)])
    assert scene.mesh_info(0).area == 0.5


TRIANGLE = np.eye(3, dtype=np.float32)


@pytest.mark.parametrize(
    ("positions", "triangles", "more", "said"),
    [
        (np.zeros((3, 2)), [(0, 1, 2)], {}, r"positions has the shape \(3, 2\)"),
        (np.zeros(9), [(0, 1, 2)], {}, r"positions has the shape \(9,\)"),
        (np.zeros((0, 3)), [(0, 1, 2)], {}, "vertex_count is 0"),
        ("abc", [(0, 1, 2)], {}, "positions must be numbers"),
        (TRIANGLE * 1j, [(0, 1, 2)], {}, "positions must be numbers"),
        (np.full((3, 3), np.nan), [(0, 1, 2)], {}, r"positions\[0\].x is -?nan"),
        (TRIANGLE * 2e10, [(0, 1, 2)], {}, r"positions\[0\].x is 2e\+10"),
        (TRIANGLE, [(0, 1)], {}, r"triangles has the shape \(1, 2\)"),
        (TRIANGLE, [0, 1, 2], {}, r"triangles has the shape \(3,\)"),
        (TRIANGLE, np.zeros((0, 3), np.uint32), {}, "triangle_count is 0"),
        (TRIANGLE, [(0, 1, 3)], {}, r"indices\[2\] \(triangle 0\) is 3, but the mesh has 3 vertices"),
        (TRIANGLE, [(0, 1, -1)], {}, "triangles holds -1"),
        (TRIANGLE, [(0, 1, 1 << 32)], {}, "triangles holds 4294967296"),
        (TRIANGLE, [(0, 1, 2.0)], {}, "triangles must be integers"),
        (TRIANGLE, [(0, 1, 2)], {"normals": TRIANGLE[:2]}, "normals has 2 rows; there are 3"),
        (TRIANGLE, [(0, 1, 2)], {"normals": np.full((3, 3), np.inf)}, r"normals\[0\].x is inf"),
        (TRIANGLE, [(0, 1, 2)], {"uvs": np.zeros((3, 3))}, r"uvs has the shape \(3, 3\); it must be n x 2"),
        (TRIANGLE, [(0, 1, 2)], {"uvs": np.full((3, 2), np.nan)}, r"uvs\[0\]"),
        (TRIANGLE, [(0, 1, 2)], {"medium": 0}, "medium is 0, but the scene has 0 media"),
        (TRIANGLE, [(0, 1, 2)], {"medium": -1}, "medium is -1; it must be an index"),
        (TRIANGLE, [(0, 1, 2)], {"medium": "milk"}, "medium is 'milk'; it must be an index"),
        (TRIANGLE, [(0, 1, 2)], {"medium": ty.Medium([1, 2], 1)}, "1 or 3 channels; this one has 2"),
        (TRIANGLE, [(0, 1, 2)], {"material": 3}, "material is 3, but the scene has 0 materials"),
        (TRIANGLE, [(0, 1, 2)], {"material": ty.Material(metallic=2)}, "metallic is 2"),
        (TRIANGLE, [(0, 1, 2)], {"triangle_materials": [0, 0]}, r"triangle_materials has the shape \(2,\)"),
        (TRIANGLE, [(0, 1, 2)], {"triangle_materials": [0]}, r"triangle_materials\[0\] is 0, but the scene has 0"),
    ],
)
def test_bad_meshes_are_refused(scene: ty.Scene, positions: Any, triangles: Any, more: Any, said: str) -> None:
    with pytest.raises(InvalidArgumentError, match=said):
        scene.add_mesh(positions, triangles, **more)
    assert scene.info.mesh_count == 0


@settings(max_examples=40, deadline=None, derandomize=True)
@given(
    rows=st.integers(0, 6),
    columns=st.sampled_from([3, 3, 2, 4]),
    steps=st.tuples(st.sampled_from([1, 2, -1]), st.sampled_from([1, 2, -1])),
    kind=st.sampled_from(["f2", "f4", ">f4", "f8", "i2", "u8", "?", "c8", "S3", "O"]),
)
def test_any_array_of_positions_is_read_or_refused(
    context: ty.Context, rows: int, columns: int, steps: tuple[int, int], kind: str
) -> None:
    values = np.arange(4 * rows * columns, dtype=np.float64).reshape(2 * rows, 2 * columns).astype(kind)
    positions = values[:: steps[0], :: steps[1]][:rows, :columns]
    with context.scene() as scene:
        if columns != 3 or rows < 3 or kind in ("c8", "S3", "O"):
            with pytest.raises(InvalidArgumentError):
                scene.add_mesh(positions, [(0, 1, 2)])
        else:
            scene.add_mesh(positions, [(0, 1, 2)])
            used = positions[:3].astype(np.float32)
            assert np.array_equal(scene.mesh_info(0).lower, used.min(axis=0))


# ---- media, materials and the rest


def test_media_come_back(scene: ty.Scene) -> None:
    grey = scene.add_medium(ty.Medium(0.25, 2.0, g=0.8, ior=1.33, name="fog"))
    found = scene.medium(grey)
    assert found.name == "fog" and (found.g, found.ior) == (0.8, 1.33)
    assert np.array_equal(found.sigma_a, [0.25] * 3) and np.array_equal(found.sigma_s, [2.0] * 3)
    colour = scene.medium(scene.add_medium(ty.Medium([0.1, 0.2, 0.3], [1, 2, 3])))
    assert np.array_equal(colour.sigma_a, [0.1, 0.2, 0.3]) and colour.name is None


@pytest.mark.parametrize(
    "phase",
    [
        ty.Phase.two_lobe(0.8, -0.3, 0.7),
        ty.Phase.draine(0.5, 2.0),
        ty.Phase.tabulated([-1, 0.25, 1], [1, 2, 5]),
        ty.Phase.rayleigh(),
    ],
)
def test_phase_functions_come_back(scene: ty.Scene, phase: ty.Phase) -> None:
    found = scene.medium(scene.add_medium(ty.Medium(1, 1, phase=phase))).phase
    assert found is not None and found.name == phase.name
    cosines = np.linspace(-1, 1, 9)
    values = np.empty((2, 9))
    for row, one in zip(values, (phase, found)):
        point = ctypes.POINTER(ctypes.c_double)
        capi.lib.tyn_phase_value(ctypes.byref(one.record), cosines.ctypes.data_as(point), 9, row.ctypes.data_as(point))
    assert values[0].min() > 0 and np.allclose(values[0], values[1], rtol=1e-12)


def test_media_are_converted_to_the_scene_s_unit(context: ty.Context) -> None:
    with context.scene(metres_per_unit=0.01) as scene:  # centimetres
        per_mm = scene.add_medium(ty.Medium(0.5, 2.0, metres_per_unit=1e-3))
        assert np.array_equal(scene.medium(per_mm).sigma_a, [5.0] * 3)
        assert scene.medium(per_mm).metres_per_unit == 0.01
        unknown = scene.add_medium(ty.Medium(0.5, 2.0))
        assert np.array_equal(scene.medium(unknown).sigma_a, [0.5] * 3)


def test_the_same_objects_are_added_once(scene: ty.Scene) -> None:
    milk, other, glass = ty.Medium(1, 1), ty.Medium(1, 1), ty.Material(ior=1.3)
    assert scene.add_mesh(*BOX, medium=milk, material=glass) == 0
    assert scene.add_mesh(*BOX, medium=other, material=glass) == 1
    assert scene.add_mesh(*BOX, medium=milk) == 2
    assert scene.add_medium(milk) == 0 and scene.add_material(glass) == 0
    assert (scene.info.medium_count, scene.info.material_count) == (2, 2)
    assert [scene.mesh_info(mesh).material for mesh in range(3)] == [0, 0, 1]
    assert [scene.mesh_info(mesh).medium for mesh in range(3)] == [0, 1, 0]


def test_materials_of_triangles(scene: ty.Scene) -> None:
    lamp = scene.add_material(ty.Material(emission=1))
    scene.add_mesh(*BOX, triangle_materials=[lamp] * 5 + [ty.NONE] * 7)
    assert scene.info.emissive_triangle_count == 5


RECORDS = [
    (ty.Material, capi.TynMaterial),
    (ty.Texture, capi.TynTexture),
    (ty.Light, capi.TynLight),
    (ty.Camera, capi.TynCamera),
    (ty.Environment, capi.TynEnvironment),
]


@pytest.mark.parametrize(("kind", "record"), RECORDS)
def test_defaults_and_fields_are_those_of_the_c_api(kind: Any, record: Any) -> None:
    assert bytes(kind().record()) == bytes(record())
    assert {field for field, *_ in record._fields_} - {"size"} == set(kind.__dataclass_fields__)


def test_every_field_of_a_material_reaches_the_record() -> None:
    texture = ty.Texture(3, wrap_u="clamp", wrap_v="mirror", filter="nearest", transform=[(1, 2, 3), (4, 5, 6)])
    material = ty.Material(
        name="all", base_color=(0.1, 0.2, 0.3), metallic=0.4, roughness=0.5, ior=1.25, transmission=0.75, emission=2,
        normal_scale=0.7, double_sided=True, thin_walled=True, thin_scatter=0.8, thin_scatter_color=0.9,
        thin_scatter_anisotropy=-0.5, multiscatter_color=(0.2, 0.4, 0.6), scatter_strength=0.3, base_color_texture=texture,
        metallic_roughness_texture=1, normal_texture=2, emission_texture=3, transmission_texture=4,
        multiscatter_color_texture=5, scatter_strength_texture=6,
    )  # fmt: skip
    record = material.record()
    floats = np.float32
    assert record.name == b"all" and np.array_equal(record.base_color[:], floats([0.1, 0.2, 0.3]))
    numbers = [record.metallic, record.roughness, record.ior, record.transmission, record.normal_scale, record.thin_scatter]
    assert np.array_equal(numbers, floats([0.4, 0.5, 1.25, 0.75, 0.7, 0.8]))
    assert record.emission[:] == [2, 2, 2] and np.array_equal(record.thin_scatter_color[:], floats([0.9] * 3))
    assert (record.double_sided, record.thin_walled, record.thin_scatter_anisotropy) == (1, 1, -0.5)
    assert np.array_equal(record.multiscatter_color[:], floats([0.2, 0.4, 0.6]))
    assert record.scatter_strength == floats(0.3)
    one = record.base_color_texture
    assert (one.image, one.wrap_u, one.wrap_v, one.filter) == (3, capi.TYN_WRAP_CLAMP, capi.TYN_WRAP_MIRROR, 1)
    assert one.transform[:] == [1, 2, 3, 4, 5, 6]
    names = ["metallic_roughness", "normal", "emission", "transmission", "multiscatter_color", "scatter_strength"]
    assert [getattr(record, f"{name}_texture").image for name in names] == [1, 2, 3, 4, 5, 6]


def test_every_field_of_lights_and_environments_reaches_the_record() -> None:
    light = ty.Light("spot", (1, 2, 3), (0, 1, 0), (4, 5, 6), inner_cone=0.25, outer_cone=0.5, name="lamp").record()
    assert (light.type, light.name) == (capi.TYN_LIGHT_SPOT, b"lamp")
    assert (light.position[:], light.direction[:], light.intensity[:]) == ([1, 2, 3], [0, 1, 0], [4, 5, 6])
    assert (light.inner_cone, light.outer_cone) == (0.25, 0.5)
    sky = ty.Environment((1, 2, 3), image=4, rotation=0.5, hidden_from_camera=True).record()
    assert (sky.radiance[:], sky.image, sky.rotation, sky.hidden_from_camera) == ([1, 2, 3], 4, 0.5, 1)


@pytest.mark.parametrize(
    ("make", "said"),
    [
        (lambda: ty.Light("laser"), 'type is \'laser\'; it must be one of "point", "spot", "directional"'),
        (lambda: ty.Light(position=(1, 2)), r"Light.position has the shape \(2,\); it must be 3"),
        (lambda: ty.Material(base_color="red"), "Material.base_color is 'red'; it must be numbers"),
        (lambda: ty.Material(metallic=(1, 2)), r"Material.metallic has the shape \(2,\); it must be a single number"),
        (lambda: ty.Material(normal_texture=-1), "image is -1; it must be an index"),
        (lambda: ty.Texture(0, filter="cubic"), 'filter is \'cubic\'; it must be one of "linear", "nearest"'),
        (lambda: ty.Texture(transform=np.eye(3)), r"Texture.transform has the shape \(3, 3\); it must be 2 x 3"),
        (lambda: ty.Camera(yfov=None), "Camera.yfov is None; it must be numbers"),
        (lambda: ty.Camera.look_at((0, 0, 0), (0, 0, 0)), "do not make a view"),
        (lambda: ty.Camera.look_at((0, 1, 0), (0, 0, 0)), "do not make a view"),
        (lambda: ty.Camera.look_at((0, 1), (0, 0, 0)), r"eye has the shape \(2,\)"),
    ],
)
def test_bad_fields_are_refused(make: Any, said: str) -> None:
    with pytest.raises(InvalidArgumentError, match=said):
        make()


@pytest.mark.parametrize(
    ("add", "said"),
    [
        (lambda scene: scene.add_light(ty.Light("spot", outer_cone=2)), "outer_cone is 2"),
        (lambda scene: scene.add_light(ty.Light(intensity=np.nan)), r"intensity\[0\] is -?nan"),
        (lambda scene: scene.add_light(ty.Camera()), "light is .*; it must be a tyndall.Light"),
        (lambda scene: scene.add_camera(ty.Camera(yfov=4)), "yfov is 4"),
        (lambda scene: scene.add_camera(ty.Camera(world_from_camera=2 * np.eye(3, 4))), "world_from_camera"),
        (lambda scene: scene.add_material(ty.Material(normal_texture=0)), "normal_texture.image is 0"),
        (lambda scene: scene.add_material("wax"), "material is 'wax'"),
        (lambda scene: scene.add_medium(ty.Material()), "medium is .*; it must be a tyndall.Medium"),
        (lambda scene: scene.set_environment(ty.Environment(image=0)), "image is 0"),
        (lambda scene: scene.set_environment(1.0), "environment is 1.0"),
        (lambda scene: scene.mesh_info(0), "mesh is 0, but the scene has 0"),
        (lambda scene: scene.mesh_info(-1), "is -1; it must be an index"),
        (lambda scene: scene.medium(0), "index is 0"),
        (lambda scene: scene.camera(0), "index is 0"),
        (lambda scene: scene.frame(-1), "aspect"),
    ],
)
def test_bad_objects_are_refused(scene: ty.Scene, add: Any, said: str) -> None:
    with pytest.raises(InvalidArgumentError, match=said):
        add(scene)


def test_cameras_come_back(scene: ty.Scene) -> None:
    camera = ty.Camera.look_at((3, 4, 5), (3, 0, 2), yfov=0.5, aspect_ratio=1.5, znear=0.25, name="view")
    found = scene.camera(scene.add_camera(camera))
    pose = np.array(found.world_from_camera)
    assert np.allclose(pose, camera.world_from_camera, atol=1e-6)
    assert np.allclose(pose[:, 2], np.array([0, 4, 3]) / 5, atol=1e-6)  # looks along -Z, from the target to the eye
    assert np.allclose(pose[:, 0], [1, 0, 0], atol=1e-6) and np.array_equal(pose[:, 3], [3, 4, 5])
    assert np.linalg.det(pose[:, :3]) == pytest.approx(1)
    assert (found.type, found.yfov, found.aspect_ratio, found.znear, found.name) == ("perspective", 0.5, 1.5, 0.25, "view")
    flat = scene.camera(scene.add_camera(ty.Camera("orthographic", ymag=2.5)))
    assert (flat.type, flat.ymag) == ("orthographic", 2.5)


def test_a_frame_shows_the_whole_scene(scene: ty.Scene) -> None:
    positions, triangles = BOX
    scene.add_mesh(positions + np.float32([5, 0, 0]), triangles)
    camera = scene.frame(2.0)
    pose = np.array(camera.world_from_camera)
    local = (np.add(positions, [5, 0, 0]) - pose[:, 3]) @ pose[:, :3]
    upwards = np.abs(local[:, 1] / -local[:, 2])
    assert camera.yfov == pytest.approx(np.radians(30), rel=1e-6)
    assert np.all(local[:, 2] < 0) and np.all(upwards < np.tan(camera.yfov / 2))
    assert np.all(np.abs(local[:, 0] / -local[:, 2]) < 2 * np.tan(camera.yfov / 2))


# ---- images


def test_images_reach_the_library_as_they_are(scene: ty.Scene, monkeypatch: pytest.MonkeyPatch) -> None:
    seen: list[Any] = []

    def note(function: Any, handle: Any, record: Any, result: Any) -> None:
        image = record._obj
        size = 16 if image.format == capi.TYN_IMAGE_RGBA32F else 4
        stride = image.row_stride or size * image.width
        rows = [ctypes.string_at(image.pixels + y * stride, size * image.width) for y in range(image.height)]
        seen.append((image.format, image.width, image.height, b"".join(rows)))

    monkeypatch.setattr(scene, "_call", note)
    generator = np.random.default_rng(1)
    bytes_ = generator.integers(0, 256, (5, 7, 4), np.uint8)
    floats = generator.random((5, 7, 4), np.float32)
    opaque, opaque_floats = bytes_.copy(), floats.copy()
    opaque[..., 3], opaque_floats[..., 3] = 255, 1
    srgb, linear, wide = capi.TYN_IMAGE_RGBA8_SRGB, capi.TYN_IMAGE_RGBA8_LINEAR, capi.TYN_IMAGE_RGBA32F
    cases: list[tuple[Any, Any, int, Any]] = [
        (bytes_, None, srgb, bytes_),
        (bytes_, False, linear, bytes_),
        (bytes_[..., :3], True, srgb, opaque),
        (floats, None, wide, floats),
        (floats.astype(np.float64), False, wide, floats),
        (floats[..., :3], None, wide, opaque_floats),
        (bytes_[::-1], None, srgb, bytes_[::-1]),
        (bytes_[:, ::2], None, srgb, bytes_[:, ::2]),
        (bytes_[1:4, 2:6], None, srgb, bytes_[1:4, 2:6]),
        (floats[::2, 1:], None, wide, floats[::2, 1:]),
        (bytes_[:1], None, srgb, bytes_[:1]),
    ]
    for pixels, curve, kind, expected in cases:
        scene.add_image(pixels, srgb=curve)
        height, width = expected.shape[:2]
        assert seen.pop() == (kind, width, height, expected.tobytes())


@pytest.mark.parametrize(
    ("pixels", "more", "said"),
    [
        (np.zeros((2, 2), np.uint8), {}, r"pixels has the shape \(2, 2\)"),
        (np.zeros((2, 2, 2), np.uint8), {}, r"pixels has the shape \(2, 2, 2\)"),
        (np.zeros((0, 2, 3), np.uint8), {}, "height is 0"),
        (np.zeros((2, 0, 3), np.float32), {}, "width is 0"),
        (np.zeros((2, 2, 3), np.int32), {}, "pixels is of type int32"),
        (np.zeros((2, 2, 3), np.float32), {"srgb": True}, "srgb is for uint8"),
        (np.full((2, 2, 4), np.nan, np.float32), {}, r"pixel \(0, 0\) is -?nan"),
    ],
)
def test_bad_images_are_refused(scene: ty.Scene, pixels: Any, more: Any, said: str) -> None:
    with pytest.raises(InvalidArgumentError, match=said):
        scene.add_image(pixels, **more)


# ---- life


def test_a_committed_scene_is_read_only(scene: ty.Scene) -> None:
    with pytest.raises(InvalidOperationError, match="mesh"):
        scene.commit()
    assert not scene.committed
    scene.add_mesh(*BOX)
    scene.commit()
    assert scene.committed and "committed" in repr(scene)
    adds: list[Any] = [
        lambda: scene.add_mesh(*BOX),
        lambda: scene.add_medium(ty.Medium(1, 1)),
        lambda: scene.add_material(ty.Material()),
        lambda: scene.add_image(np.zeros((1, 1, 4), np.uint8)),
        lambda: scene.add_light(ty.Light()),
        lambda: scene.add_camera(ty.Camera()),
        lambda: scene.set_environment(ty.Environment()),
        scene.clear_lights,
        scene.commit,
    ]
    for add in adds:
        with pytest.raises(InvalidOperationError, match="committed"):
            add()
    assert scene.info.mesh_count == 1


def test_a_closed_scene_is_refused(context: ty.Context) -> None:
    with context.scene() as scene:
        scene.add_mesh(*BOX)
        scene.commit()
    assert scene.closed and "closed" in repr(scene)
    uses: list[Any] = [
        lambda: scene.info,
        lambda: scene.add_light(ty.Light()),
        lambda: context.intersect(scene, [0, 0, 0], [0, 0, 1]),
        lambda: context.walk(scene, [0, 0, 0], [0, 0, 1]),
        scene.__enter__,
    ]
    for use in uses:
        with pytest.raises(ClosedError, match="this scene was closed"):
            use()


def test_closing_a_context_closes_its_scenes() -> None:
    context = ty.Context()
    scene = context.scene()
    context.close()
    assert scene.closed
    with pytest.raises(ClosedError):
        scene.add_mesh(*BOX)
    with pytest.raises(ClosedError, match="this context was closed"):
        context.scene()


def test_a_scene_keeps_its_context() -> None:
    scene = ty.Context().scene()
    scene.add_mesh(*BOX)
    scene.commit()
    assert scene.context.intersect(scene, [0, 0, 3], [0, 0, -1])["t"][0] == 2.5


@pytest.mark.parametrize("unit", [0, -1, np.nan, np.inf])
def test_bad_units_are_refused(context: ty.Context, unit: float) -> None:
    with pytest.raises(InvalidArgumentError, match="metres_per_unit is"):
        context.scene(unit)


def test_a_mesh_with_a_medium_lets_light_in_unless_told_otherwise(context: ty.Context) -> None:
    """In constant light a white, index-matched box is as bright as what is around it, all of it by walks: the layer subsurface
    is the beauty. An opaque box has none."""
    pictures = []
    for material in (None, ty.Material(base_color=0.5)):
        with context.scene() as scene:
            scene.add_mesh(*BOX, medium=ty.Medium(0, 3), material=material)
            scene.set_environment(ty.Environment(radiance=1.0, hidden_from_camera=True))
            scene.commit()
            pictures.append(context.render(scene, width=8, height=8, spp=64))
    clear, opaque = pictures
    inside = clear.beauty[..., 3] == 1
    assert inside.sum() > 4
    assert np.allclose(clear.beauty[inside][:, :3], clear.subsurface[inside], atol=1e-6)
    assert clear.subsurface[inside].mean() == pytest.approx(1.0, abs=0.03)
    assert not opaque.subsurface.any()
