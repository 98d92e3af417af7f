# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""What scenes read from files."""

from __future__ import annotations

import ctypes
import warnings
from collections.abc import Mapping
from typing import Any, Union

from .. import capi
from .._bssrdf.paths import Path, path_bytes, text_bytes
from .._core.handles import Handle
from .._core.numbers import UINT64, integer
from .._core.progress import LongCall
from ..errors import InvalidArgumentError, TyndallWarning

Assignments = Union[str, Mapping[str, str], None]
"""Media for materials without scattering: the name of a preset for all of them that are not fully metallic, or the presets of
materials by their names, of which "ALL" is every one and the last that matches wins."""

LIMITS = capi.TynGltfOptions()


class SceneFiles(Handle):
    """The calls of a scene that read files."""

    def load_gltf(
        self,
        path: Path,
        *,
        medium: Assignments = None,
        lights: bool = True,
        max_file_bytes: int = LIMITS.max_file_bytes,
        max_triangles: int = LIMITS.max_triangles,
        max_image_pixels: int = LIMITS.max_image_pixels,
    ) -> None:
        """Adds the default scene of a glTF 2.0 file, .gltf or .glb: meshes in world space, media, materials, textures, lights,
        cameras. The scene must not be committed, and its metres_per_unit must be 1.

        medium: turns dielectric materials without scattering into media: the name of one of `Medium.presets()` for all that are
            not fully metallic, or {name of a material: preset}, where "ALL" is every one and the last that matches wins.
        lights: False leaves the file's punctual lights out.
        max_file_bytes: larger files, buffers and images are refused; by default 1 GiB.
        max_triangles: by default 100 million. max_image_pixels: by default 256 million.

        What was ignored, repaired or is doubtful comes as TyndallWarning; a warning that is an error (warnings.simplefilter) is
        raised when everything was added.
        Errors: FileError (cannot be read), FormatError (what is wrong, with the JSON path), InvalidArgumentError (an unknown
        preset), InvalidOperationError (committed), OutOfMemoryError. On failure nothing was added.
        """
        self._load_gltf(path, medium, lights, max_file_bytes, max_triangles, max_image_pixels, stacklevel=3)

    def _load_gltf(
        self,
        path: Path,
        medium: Assignments,
        lights: bool,
        max_file_bytes: int,
        max_triangles: int,
        max_image_pixels: int,
        stacklevel: int,
    ) -> None:
        """`load_gltf`. stacklevel: where warnings say that they are from."""
        messages: list[str] = []
        hear = capi.TynWarning(lambda user, message: messages.append(message.decode(errors="replace")))
        pairs = _assignments(medium)
        records = (capi.TynMediumAssignment * len(pairs))(*pairs)
        options = capi.TynGltfOptions(
            assignments=records, assignment_count=len(pairs), skip_lights=0 if lights else 1,
            max_file_bytes=integer(max_file_bytes, "max_file_bytes", 0, UINT64),
            max_triangles=integer(max_triangles, "max_triangles", 0, UINT64),
            max_image_pixels=integer(max_image_pixels, "max_image_pixels", 0, UINT64), warning=hear,
        )  # fmt: skip
        name = path_bytes(path)
        with LongCall(None, "load"):  # puts Ctrl-C off, which must not come inside `hear`
            self._call(capi.io.tyn_gltf_load, self.handle, name, ctypes.byref(options))
        for message in messages:
            warnings.warn(message, TyndallWarning, stacklevel=stacklevel)

    def load_exr(self, path: Path) -> int:
        """Adds the image of an OpenEXR file, R G B of its first part, in linear float32; returns its index, for environments
        and textures. Errors: FileError, FormatError, InvalidOperationError (committed), OutOfMemoryError."""
        image = ctypes.c_uint32()
        self._call(capi.io.tyn_exr_load, self.handle, path_bytes(path), ctypes.byref(image))
        return image.value


def _assignments(medium: Assignments) -> list[Any]:
    """The TynMediumAssignment of each."""
    if medium is None:
        return []
    pairs = {"ALL": medium} if isinstance(medium, str) else medium
    if not isinstance(pairs, Mapping) or not all(isinstance(one, str) for pair in pairs.items() for one in pair):
        raise InvalidArgumentError(
            f"medium is {medium!r}; it must be the name of a preset, or names of presets by names of materials"
        )
    return [
        capi.TynMediumAssignment(material=text_bytes(material, "medium"), medium=text_bytes(preset, "medium"))
        for material, preset in pairs.items()
    ]
