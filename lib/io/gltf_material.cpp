// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "io/gltf_material.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "io/gltf_value.hpp"

namespace tyn::io {

// A material that is being converted.
struct GltfMaterials::Builder {
  Builder(const tinygltf::Material &from, const std::string &path) : source(from), where(path) {}
  const tinygltf::Material &source;
  std::string where; // its JSON path
  TynMaterial material = tyn_material();
  uint32_t medium = TYN_NONE;
  int uv_set = -1; // not decided yet
  GltfScatter scatter;
  float diffuse_transmission = 0;
};

namespace {

bool same_medium(const TynMedium &a, const TynMedium &b) {
  return std::memcmp(a.sigma_a, b.sigma_a, sizeof a.sigma_a) == 0 &&
         std::memcmp(a.sigma_s, b.sigma_s, sizeof a.sigma_s) == 0 && a.g == b.g && a.ior == b.ior;
}

bool has_texture(const TynTexture &texture) { return texture.image != TYN_NONE; }

bool is_white(const float (&color)[3]) { return color[0] == 1 && color[1] == 1 && color[2] == 1; }

} // namespace

GltfMaterials::GltfMaterials(GltfDocument &source, const TynGltfOptions &given, Warnings &sink, LoadedScene &result)
    : document(source), options(given), warnings(sink), scene(result),
      images(source, given.max_image_pixels, result.images), textures(source, images, sink) {
  check_assignments(options, document.model);
}

MaterialUse GltfMaterials::get(int index) {
  const auto found = known.find(index);
  if (found != known.end())
    return found->second;
  const tinygltf::Material fallback;
  const tinygltf::Material &source = index < 0 ? fallback : document.model.materials[size_t(index)];
  return known[index] = build(source, index < 0 ? "the default material" : text("materials[%d]", index), index < 0);
}

MaterialUse GltfMaterials::build(const tinygltf::Material &source, const std::string &where, bool unnamed) {
  Builder builder(source, where);
  read_surface(builder);
  read_emission(builder);
  // A mesh without a material is metallic by the letter of glTF; whoever asks for a medium everywhere does not mean that.
  const bool metal =
      !unnamed && builder.material.metallic >= 1 && !has_texture(builder.material.metallic_roughness_texture);
  if (const char *preset = assigned_preset(options, source.name, metal)) {
    fill_with_preset(builder, preset);
  } else {
    read_transmission(builder);
    const tinygltf::Value *volume = extension(source.extensions, "KHR_materials_volume");
    if (volume && number(*volume, "thicknessFactor", 0) > 0)
      fill_with_volume(builder, *volume);
    else
      make_thin(builder);
  }
  warn_about_what_is_ignored(builder);
  scene.materials.push_back({source.name, builder.material});
  return {uint32_t(scene.materials.size() - 1), builder.medium, std::max(builder.uv_set, 0)};
}

void GltfMaterials::read_surface(Builder &builder) {
  const tinygltf::PbrMetallicRoughness &pbr = builder.source.pbrMetallicRoughness;
  const std::string where = builder.where + ".pbrMetallicRoughness";
  TynMaterial &material = builder.material;
  for (int i = 0; i < 3; i++)
    material.base_color[i] =
        limited(pbr.baseColorFactor[size_t(i)], 0, 1, text("%s.baseColorFactor[%d]", where.c_str(), i), warnings);
  material.metallic = limited(pbr.metallicFactor, 0, 1, where + ".metallicFactor", warnings);
  material.roughness = limited(pbr.roughnessFactor, 0, 1, where + ".roughnessFactor", warnings);
  material.double_sided = builder.source.doubleSided;
  material.base_color_texture =
      textures.get(pbr.baseColorTexture, ColorSpace::Srgb, where + ".baseColorTexture", builder.uv_set);
  material.metallic_roughness_texture = textures.get(pbr.metallicRoughnessTexture, ColorSpace::Linear,
                                                     where + ".metallicRoughnessTexture", builder.uv_set);
  material.normal_texture =
      textures.get(builder.source.normalTexture, ColorSpace::Linear, builder.where + ".normalTexture", builder.uv_set);
  material.normal_scale =
      limited(builder.source.normalTexture.scale, -1e6, 1e6, builder.where + ".normalTexture.scale", warnings);
  if (const tinygltf::Value *ior = extension(builder.source.extensions, "KHR_materials_ior"))
    material.ior =
        limited(number(*ior, "ior", 1.5), 1, 4, builder.where + ".extensions.KHR_materials_ior.ior", warnings);
}

void GltfMaterials::read_emission(Builder &builder) {
  double strength = 1;
  const std::string where = builder.where + ".extensions.KHR_materials_emissive_strength.emissiveStrength";
  if (const tinygltf::Value *value = extension(builder.source.extensions, "KHR_materials_emissive_strength"))
    strength = limited(number(*value, "emissiveStrength", 1), 0, 1e30, where, warnings);
  bool emits = false;
  for (size_t i = 0; i < 3; i++) {
    const double factor = builder.source.emissiveFactor.size() == 3 ? builder.source.emissiveFactor[i] : 0;
    builder.material.emission[i] =
        limited(factor * strength, 0, 1e30, text("%s.emissiveFactor[%zu]", builder.where.c_str(), i), warnings);
    emits = emits || builder.material.emission[i] > 0;
  }
  if (emits)
    builder.material.emission_texture = textures.get(builder.source.emissiveTexture, ColorSpace::Srgb,
                                                     builder.where + ".emissiveTexture", builder.uv_set);
}

// How much light passes the surface, by the two extensions and whatever scatters behind it.
void GltfMaterials::read_transmission(Builder &builder) {
  const std::string where = builder.where + ".extensions.";
  if (const tinygltf::Value *value = extension(builder.source.extensions, "KHR_materials_transmission")) {
    const std::string inside = where + "KHR_materials_transmission";
    builder.material.transmission =
        limited(number(*value, "transmissionFactor", 0), 0, 1, inside + ".transmissionFactor", warnings);
    builder.material.transmission_texture =
        textures.get(*value, "transmissionTexture", ColorSpace::Linear, inside, builder.uv_set);
  }
  if (const tinygltf::Value *value = extension(builder.source.extensions, "KHR_materials_diffuse_transmission")) {
    const std::string inside = where + "KHR_materials_diffuse_transmission";
    builder.diffuse_transmission =
        limited(number(*value, "diffuseTransmissionFactor", 0), 0, 1, inside + ".diffuseTransmissionFactor", warnings);
    for (const char *key : {"diffuseTransmissionTexture", "diffuseTransmissionColorTexture"})
      if (member(*value, key))
        warnings.add("%s.%s is not supported and ignored", inside.c_str(), key);
  }
  builder.scatter = find_scatter(builder.source, builder.where, warnings);
}

// The scatter drafts came with KHR_materials_transmission, with KHR_materials_diffuse_transmission or with neither; something
// that scatters below its surface lets light in.
void GltfMaterials::let_light_in(Builder &builder) {
  if (builder.material.transmission > 0)
    return;
  if (builder.diffuse_transmission > 0) {
    warnings.add("%s: diffuse transmission into a volume is treated as KHR_materials_transmission",
                 builder.where.c_str());
    builder.material.transmission = builder.diffuse_transmission;
  } else if (builder.scatter.object) {
    warnings.add("%s: scatters without KHR_materials_transmission; a transmissionFactor of 1 is used",
                 builder.where.c_str());
    builder.material.transmission = 1;
  }
}

void GltfMaterials::fill_with_volume(Builder &builder, const tinygltf::Value &volume) {
  let_light_in(builder);
  TynMaterial &material = builder.material;
  const GltfScatter &scatter = builder.scatter;
  if (material.transmission == 0)
    return; // a volume behind an opaque surface
  builder.medium = add_medium(make_medium(volume, scatter, material.ior, builder.where, warnings), builder.source.name);
  if (!scatter.object)
    return;
  material.multiscatter_color_texture =
      textures.get(*scatter.object, "multiscatterColorTexture", ColorSpace::Srgb, scatter.where, builder.uv_set);
  material.scatter_strength_texture =
      textures.get(*scatter.object, "scatterStrengthTexture", ColorSpace::Linear, scatter.where, builder.uv_set);
  if (!has_texture(material.multiscatter_color_texture) && !has_texture(material.scatter_strength_texture))
    return; // the medium says it all
  std::copy(scatter.color, scatter.color + 3, material.multiscatter_color);
  material.scatter_strength = scatter.strength;
}

// A surface without an interior that light passes: KHR_materials_transmission without a volume, and what scatters there.
void GltfMaterials::make_thin(Builder &builder) {
  TynMaterial &material = builder.material;
  const GltfScatter &scatter = builder.scatter;
  if (scatter.object) {
    warnings.add("%s: scatters without a volume whose thicknessFactor is > 0; it is treated as thin-walled",
                 builder.where.c_str());
    for (const char *key : {"multiscatterColorTexture", "scatterStrengthTexture"})
      if (member(*scatter.object, key))
        warnings.add("%s.%s is ignored on a thin-walled surface", scatter.where.c_str(), key);
    let_light_in(builder);
    material.thin_scatter = scatter.strength;
    std::copy(scatter.color, scatter.color + 3, material.thin_scatter_color);
    material.thin_scatter_anisotropy = scatter.g;
  } else if (material.transmission == 0 && builder.diffuse_transmission > 0) {
    // All of it is scattered, and all of that comes out on the other side.
    const tinygltf::Value &value = *extension(builder.source.extensions, "KHR_materials_diffuse_transmission");
    double color[3] = {1, 1, 1};
    numbers(value, "diffuseTransmissionColorFactor", color);
    for (int i = 0; i < 3; i++)
      material.thin_scatter_color[i] =
          limited(color[i], 0, 1, text("%s: diffuseTransmissionColorFactor[%d]", builder.where.c_str(), i), warnings);
    material.transmission = builder.diffuse_transmission;
    material.thin_scatter = 1;
    material.thin_scatter_anisotropy = 1;
  }
  material.thin_walled = material.transmission > 0;
}

// The caller's choice: a measured medium, coloured by the base colour where the material has one.
void GltfMaterials::fill_with_preset(Builder &builder, const char *preset) {
  TynMaterial &material = builder.material;
  const TynMedium medium = preset_medium(preset);
  if (material.metallic >= 1 && !has_texture(material.metallic_roughness_texture)) {
    if (!builder.source.name.empty())
      warnings.add("%s is metallic; as %s it is not", builder.where.c_str(), preset);
    material.metallic = 0;
  }
  material.transmission = 1;
  material.ior = medium.ior;
  builder.medium = add_medium(medium, preset);
  if (!has_texture(material.base_color_texture) && is_white(material.base_color))
    return;
  std::copy(material.base_color, material.base_color + 3, material.multiscatter_color);
  material.multiscatter_color_texture = material.base_color_texture;
}

void GltfMaterials::warn_about_what_is_ignored(const Builder &builder) {
  const tinygltf::Material &source = builder.source;
  const TynMaterial &material = builder.material;
  if (source.alphaMode != "OPAQUE")
    warnings.add("%s.alphaMode is %s, which is not supported: the material is opaque", builder.where.c_str(),
                 printable(source.alphaMode).c_str());
  if (extension(source.extensions, "KHR_materials_unlit"))
    warnings.add("%s: KHR_materials_unlit is ignored; the material is lit", builder.where.c_str());
  const bool tinted = !is_white(material.base_color) || has_texture(material.base_color_texture);
  const bool enters_whole = material.transmission >= 1 && !has_texture(material.transmission_texture);
  const bool colors_medium = material.multiscatter_color[0] >= 0;
  if (builder.medium != TYN_NONE && tinted && enters_whole && !colors_medium && material.metallic < 1)
    warnings.add("%s: the base colour does not tint the light that enters the volume", builder.where.c_str());
}

// Materials with equal media share one, so that an object whose surface has several of them stays one object.
uint32_t GltfMaterials::add_medium(const TynMedium &medium, const std::string &name) {
  for (size_t i = 0; i < scene.media.size(); i++)
    if (same_medium(scene.media[i].value, medium))
      return uint32_t(i);
  TynMedium stored = medium;
  stored.name = nullptr; // points into the preset table, or nowhere
  scene.media.push_back({name, stored});
  return uint32_t(scene.media.size() - 1);
}

} // namespace tyn::io
