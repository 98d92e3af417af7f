# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""What surfaces do with light."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Union

from .. import capi
from .._core.fields import Fields, Numbers, defaults

_TEXTURE = defaults(capi.TynTexture)
_MATERIAL = defaults(capi.TynMaterial)


@dataclass(frozen=True)
class Texture(Fields):
    """A use of an image. The origin of uv is the upper left corner of the image, v grows downwards (glTF 2.0)."""

    _RECORD = capi.TynTexture
    _NAMES = {"wrap_u": ("repeat", "clamp", "mirror"), "wrap_v": ("repeat", "clamp", "mirror"), "filter": ("linear", "nearest")}
    _INDICES = ("image",)
    _SHAPES = {"transform": (2, 3)}

    image: int | None = None
    """Index from `Scene.add_image`; None: no texture."""
    wrap_u: str = _NAMES["wrap_u"][_TEXTURE.wrap_u]
    """ "repeat", "clamp" or "mirror"."""
    wrap_v: str = _NAMES["wrap_v"][_TEXTURE.wrap_v]
    """ "repeat", "clamp" or "mirror"."""
    filter: str = _NAMES["filter"][_TEXTURE.filter]
    """ "linear" or "nearest"."""
    transform: Numbers = _TEXTURE.transform
    """2 x 3: u' = t00 u + t01 v + t02, v' = t10 u + t11 v + t12 (KHR_texture_transform)."""


AnyTexture = Union[Texture, int, None]
"""A texture, the index of an image for one with the defaults, or None for no texture."""


@dataclass(frozen=True)
class Material(Fields):
    """What a surface does with light: metallic-roughness (glTF 2.0, appendix B) over an optional interior. The fields are
    keyword arguments; colours are linear RGB, three numbers or one for all.

    The dielectric part of the surface (fraction 1 - metallic) lets the fraction `transmission` of the light that its interface
    transmits into the mesh's medium (a walk); the rest meets an opaque Lambertian base of colour base_color.
    """

    _RECORD = capi.TynMaterial

    name: str | None = None
    base_color: Numbers = _MATERIAL.base_color
    """[0, 1]."""
    metallic: float = _MATERIAL.metallic
    """[0, 1]."""
    roughness: float = _MATERIAL.roughness
    """Perceptual, [0, 1]; GGX alpha = roughness^2; alpha < 0.001 is smooth."""
    ior: float = _MATERIAL.ior
    """Of the interface, [1, 4]. 1: no interface. A mesh with a medium: set both alike."""
    transmission: float = _MATERIAL.transmission
    """[0, 1]; 0 is opaque; 1: everything that enters walks."""
    emission: Numbers = _MATERIAL.emission
    """Radiance, >= 0; emitted on the outside (both sides if double_sided)."""
    normal_scale: float = _MATERIAL.normal_scale
    """Of normal_texture."""
    double_sided: bool = bool(_MATERIAL.double_sided)
    """No effect on a surface with an interior."""
    thin_walled: bool = bool(_MATERIAL.thin_walled)
    """No interior; `transmission` passes straight through, tinted by base_color."""
    thin_scatter: float = _MATERIAL.thin_scatter
    """Thin-walled: fraction of the transmitted light that is scattered, [0, 1]."""
    thin_scatter_color: Numbers = _MATERIAL.thin_scatter_color
    """Thin-walled: diffuse colour of what is scattered, [0, 1]."""
    thin_scatter_anisotropy: float = _MATERIAL.thin_scatter_anisotropy
    """Thin-walled: (1 + g) / 2 goes through, (1 - g) / 2 comes back, [-1, 1]."""
    multiscatter_color: Numbers | None = None
    """Multiple-scattering colour, [0, 1]; None: the medium's own albedo. Otherwise the entry point's colour (times the two
    textures) sets the walk's albedo (Kulla & Conty 2017); sigma_t stays the medium's."""
    scatter_strength: float = _MATERIAL.scatter_strength
    """[0, 1]; scales multiscatter_color."""
    base_color_texture: AnyTexture = Texture()
    """RGB, times base_color."""
    metallic_roughness_texture: AnyTexture = Texture()
    """B metallic, G roughness."""
    normal_texture: AnyTexture = Texture()
    """Tangent space."""
    emission_texture: AnyTexture = Texture()
    """RGB, times emission."""
    transmission_texture: AnyTexture = Texture()
    """R, times transmission."""
    multiscatter_color_texture: AnyTexture = Texture()
    """RGB, times multiscatter_color."""
    scatter_strength_texture: AnyTexture = Texture()
    """A, times scatter_strength."""

    def _from_caller(self, name: str, kind: Any, value: Any) -> Any:
        if kind is capi.TynTexture:
            return value if isinstance(value, Texture) else Texture(value)
        if name == "multiscatter_color" and value is None:
            return None
        return super()._from_caller(name, kind, value)

    def _to_record(self, name: str) -> Any:
        value = super()._to_record(name)
        return _MATERIAL.multiscatter_color if name == "multiscatter_color" and value is None else value
