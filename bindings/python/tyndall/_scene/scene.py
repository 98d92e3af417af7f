# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Scenes: meshes, the media inside them, materials, lights, cameras. Things are added, then the scene is committed."""

from __future__ import annotations

import ctypes
from typing import Any, Callable, TypeVar

import numpy as np
from numpy.typing import ArrayLike

from .. import capi
from .._core.arrays import shown
from .._core.context import ContextHandle
from .._core.numbers import decimal, index, number
from .._core.progress import LongCall
from .._core.text import optional_name
from .._media.medium import Medium
from .._media.phase import Phase
from ..errors import InvalidArgumentError
from .camera import Camera
from .files import SceneFiles
from .images import image_record
from .info import MeshInfo, SceneInfo
from .light import Environment, Light
from .material import Material
from .mesh import mesh_record

_T = TypeVar("_T")


class Scene(SceneFiles):
    """What light meets; made by `Context.scene`. Things are added to it, then `commit()` makes it read-only and ready for rays,
    walks and renderers. Lengths are in scene units, of `metres_per_unit` metres. Right-handed, Y up; RGB is linear, Rec.709.

    What is added is copied. Adding to a committed scene is an InvalidOperationError.
    """

    _kind = "scene"

    def __init__(self, context: ContextHandle, metres_per_unit: float = 1.0) -> None:
        """An empty scene; see `Context.scene`."""
        unit = number(metres_per_unit, "metres_per_unit")
        options = capi.TynSceneOptions(metres_per_unit=unit)
        pointer = ctypes.POINTER(capi.TynScene)()
        context._call(capi.lib.tyn_scene_create, context.handle, ctypes.byref(options), ctypes.byref(pointer))
        super().__init__(pointer, capi.lib.tyn_scene_release, context)
        self._context = context
        self._metres_per_unit = unit
        self._committed = False
        self._clear: dict[int, Material] = {}  # by medium
        self._known: dict[int, tuple[object, int]] = {}  # by id: media and materials that were added, and their indices

    @property
    def context(self) -> ContextHandle:
        """The context that it was made from."""
        return self._context

    @property
    def metres_per_unit(self) -> float:
        """What a scene unit is, in metres."""
        return self._metres_per_unit

    @property
    def committed(self) -> bool:
        """Whether the scene is read-only."""
        return self._committed

    def add_medium(self, medium: Medium) -> int:
        """Adds a medium of 1 or 3 channels, and returns its index. Its coefficients are converted to 1/scene unit if it says
        its unit, and else taken as being that. The same object is added once."""
        _require(medium, "medium", Medium)
        return self._added_once(medium, lambda: self._add(capi.lib.tyn_scene_add_medium, medium.record(self._metres_per_unit)))

    def add_material(self, material: Material) -> int:
        """Adds a material and returns its index. The same object is added once."""
        _require(material, "material", Material)
        return self._added_once(material, lambda: self._add(capi.lib.tyn_scene_add_material, material.record()))

    def add_image(self, pixels: ArrayLike, *, srgb: bool | None = None, name: str | None = None) -> int:
        """Adds an image and returns its index.

        pixels: height x width x 3 or 4, rows from top to bottom, 1 to 32768 pixels a side. uint8, or floating-point, which is
            linear and kept as float32. Without a fourth channel the image is opaque.
        srgb: whether R, G and B of uint8 pixels have the sRGB curve; None: they do. The fourth channel is linear.
        name: may be None.
        """
        return self._add(capi.lib.tyn_scene_add_image, image_record(pixels, srgb, name))

    def add_mesh(
        self,
        positions: ArrayLike,
        triangles: ArrayLike,
        *,
        normals: ArrayLike | None = None,
        uvs: ArrayLike | None = None,
        medium: int | Medium | None = None,
        material: int | Material | None = None,
        triangle_materials: ArrayLike | None = None,
        name: str | None = None,
    ) -> int:
        """Adds a triangle mesh, one object whose inside holds one medium, and returns its index. `mesh_info` says what was
        found out about it: an open or inconsistently oriented mesh still renders.

        Positions may repeat, at seams of normals and uv: vertices of the same position are one for the checks. float32 arrays
        are not copied on their way, also views whose rows are apart.

        positions: n x 3, scene units, of size at most 1e10; n >= 3. For walks a mesh should lie near the origin.
        triangles: m x 3 indices of vertices, counter-clockwise seen from outside; m >= 1.
        normals: n x 3, shading normals (normalized); one that is 0 becomes the mean of the triangles around.
        uvs: n x 2, texture coordinates.
        medium: what is inside: its index, or a Medium, which is added first; None: the mesh is opaque.
        material: of all triangles: its index, or a Material, which is added first. None: where there is a medium, one through
            which all light gets in that its interface does not reflect, of the medium's index of refraction
            (`Material(transmission=1, ior=medium.ior)`); else a default one, which is opaque.
        triangle_materials: m indices, one a triangle, instead of `material`; NONE is a default one.
        name: may be None.

        Errors: InvalidArgumentError (which element, its value), InvalidOperationError, OutOfMemoryError. A Medium or Material
        that was added first stays.
        """
        record = mesh_record(positions, triangles, normals, uvs, triangle_materials, name=optional_name(name))
        if medium is not None:
            record.medium = self.add_medium(medium) if isinstance(medium, Medium) else index(medium, "medium")
        if material is None and triangle_materials is None and record.medium < self.info.medium_count:
            material = self._clear_material(record.medium)
        if material is not None:
            record.material = self.add_material(material) if isinstance(material, Material) else index(material, "material")
        return self._add(capi.lib.tyn_scene_add_mesh, record)

    def add_light(self, light: Light) -> int:
        """Adds a light without size and returns its index."""
        _require(light, "light", Light)
        return self._add(capi.lib.tyn_scene_add_light, light.record())

    def add_camera(self, camera: Camera) -> int:
        """Adds a camera and returns its index."""
        _require(camera, "camera", Camera)
        return self._add(capi.lib.tyn_scene_add_camera, camera.record())

    def set_environment(self, environment: Environment) -> None:
        """Replaces the environment; a scene starts with a black one."""
        _require(environment, "environment", Environment)
        self._call(capi.lib.tyn_scene_set_environment, self.handle, ctypes.byref(environment.record()))

    def clear_lights(self) -> None:
        """Removes all lights without size; emissive triangles and the environment stay."""
        self._call(capi.lib.tyn_scene_clear_lights, self.handle)

    def commit(self) -> None:
        """Builds the acceleration structures, copies everything to the device and makes the scene read-only.

        Errors: InvalidOperationError (there is no mesh, or it is committed already), OutOfMemoryError, DeviceError.
        """
        with LongCall(None, "commit"):  # so that no interrupt comes between the two
            self._call(capi.lib.tyn_scene_commit, self.handle)
            self._committed = True

    @property
    def info(self) -> SceneInfo:
        """What the scene holds."""
        record = capi.TynSceneInfo()
        self._call(capi.lib.tyn_scene_info, self.handle, ctypes.byref(record))
        return SceneInfo.of(record)

    def mesh_info(self, mesh: int) -> MeshInfo:
        """What a mesh is. mesh: its index."""
        return self._read(capi.lib.tyn_scene_mesh_info, mesh, capi.TynMeshInfo(), MeshInfo.of)

    def medium(self, medium: int) -> Medium:
        """A medium that was added, of three channels, in 1/scene unit. medium: its index."""
        return self._read(capi.lib.tyn_scene_medium, medium, capi.TynMedium(), self._medium_of)

    def camera(self, camera: int) -> Camera:
        """A camera that was added. camera: its index."""
        return self._read(capi.lib.tyn_scene_camera, camera, capi.TynCamera(), Camera.of)

    def frame(self, aspect_ratio: float = 1.0) -> Camera:
        """A view of the whole scene: from the front, slightly above, 30 degrees field of view. aspect_ratio: the film's,
        width / height, > 0."""
        record = capi.TynCamera()
        self._call(capi.lib.tyn_scene_frame, self.handle, number(aspect_ratio, "aspect_ratio"), ctypes.byref(record))
        return Camera.of(record)

    def _add(self, function: Any, record: Any) -> int:
        result = ctypes.c_uint32()
        self._call(function, self.handle, ctypes.byref(record), ctypes.byref(result))
        return result.value

    def _clear_material(self, medium: int) -> Material:
        """What a mesh with a medium has, unless it is told otherwise: an opaque one would hide it from renderers."""
        return self._clear.setdefault(medium, Material(transmission=1.0, ior=self.medium(medium).ior))

    def _added_once(self, item: object, add: Callable[[], int]) -> int:
        known = self._known.get(id(item))
        if known is not None:
            return known[1]
        result = add()
        self._known[id(item)] = (item, result)
        return result

    def _read(self, function: Any, which: int, record: Any, copy: Callable[[Any], _T]) -> _T:
        """What `copy` makes of the record that is read. It points into the scene, so it is copied before another thread may
        close that."""
        place = index(which, "index")
        copies: list[_T] = []

        def read() -> int:
            status: int = function(self.handle, place, ctypes.byref(record))
            if status == capi.TYN_OK:
                copies.append(copy(record))
            return status

        self._call(read)
        return copies[0]

    def _medium_of(self, record: Any) -> Medium:
        return Medium(
            [decimal(one) for one in record.sigma_a],
            [decimal(one) for one in record.sigma_s],
            g=decimal(record.g),
            ior=decimal(record.ior),
            phase=_phase(record.phase.contents) if record.phase else None,
            name=record.name.decode(errors="replace") or None,
            metres_per_unit=self._metres_per_unit,
        )

    def __repr__(self) -> str:
        state = "closed" if self.closed else "committed" if self._committed else "open"
        return f"<tyndall.Scene, {state}, metres_per_unit={self._metres_per_unit:g}>"


class SceneCalls(ContextHandle):
    """What makes scenes."""

    def scene(self, metres_per_unit: float = 1.0) -> Scene:
        """An empty scene. metres_per_unit: what its unit of length is, > 0; 1e-3 makes it millimetres."""
        return Scene(self, metres_per_unit)


def scene_of(context: ContextHandle, scene: Scene) -> Scene:
    """`scene`, if it was made from `context`."""
    _require(scene, "scene", Scene)
    if scene.context is not context:
        raise InvalidArgumentError("scene was made from another context than this one")
    return scene


def mesh_choice(mesh: int | None) -> int:
    """The index of one mesh, or what stands for all."""
    return capi.TYN_NONE if mesh is None else index(mesh, "mesh")


def _require(value: object, name: str, kind: type) -> None:
    if not isinstance(value, kind):
        raise InvalidArgumentError(f"{name} is {shown(value)}; it must be a tyndall.{kind.__name__}")


def _phase(record: Any) -> Phase:
    if record.kind != capi.TYN_PHASE_TABULATED:
        return Phase(record.kind, g=record.g, g2=record.g2, weight=record.weight, alpha=record.alpha)
    cosines, values = (np.ctypeslib.as_array(table, (record.count,)) for table in (record.cosines, record.values))
    return Phase.tabulated(cosines, values)
