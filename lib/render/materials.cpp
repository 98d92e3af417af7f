// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "render/materials.hpp"

#include <algorithm>

#include "render/fresnel.hpp"

namespace tyn {
namespace {

void copy(float (&to)[3], const float (&from)[3]) { std::copy(from, from + 3, to); }

} // namespace

TynMaterialRecord material_record(const TynMaterial &m, TextureTable &textures) {
  TynMaterialRecord record{};
  copy(record.base_color, m.base_color);
  copy(record.emission, m.emission);
  copy(record.multiscatter_color, m.multiscatter_color);
  copy(record.thin_color, m.thin_scatter_color);
  record.metallic = m.metallic;
  record.roughness = m.roughness;
  record.transmission = m.transmission;
  record.thin_scatter = m.thin_scatter;
  record.thin_forward = 0.5f * (1.0f + m.thin_scatter_anisotropy);
  record.ior = m.ior;
  record.transmittance = float(mean_transmittance(double(m.ior)));
  record.normal_scale = m.normal_scale;
  record.scatter_strength = m.scatter_strength;
  record.flags = (m.double_sided ? TYN_MATERIAL_DOUBLE_SIDED : 0) | (m.thin_walled ? TYN_MATERIAL_THIN : 0);
  record.textures[TYN_TEXTURE_BASE_COLOR] = textures.add(m.base_color_texture);
  record.textures[TYN_TEXTURE_METALLIC_ROUGHNESS] = textures.add(m.metallic_roughness_texture);
  record.textures[TYN_TEXTURE_NORMAL] = textures.add(m.normal_texture);
  record.textures[TYN_TEXTURE_EMISSION] = textures.add(m.emission_texture);
  record.textures[TYN_TEXTURE_TRANSMISSION] = textures.add(m.transmission_texture);
  record.textures[TYN_TEXTURE_MULTISCATTER] = textures.add(m.multiscatter_color_texture);
  record.textures[TYN_TEXTURE_STRENGTH] = textures.add(m.scatter_strength_texture);
  return record;
}

TynRenderMedium render_medium(const TynMediumRecord &medium) {
  TynRenderMedium record{};
  for (int c = 0; c < 3; c++)
    record.color[c] = tyn_color_from_albedo(medium.albedo[c], medium.g);
  record.transmittance = float(mean_transmittance(double(medium.ior)));
  return record;
}

} // namespace tyn
