// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "io/gltf_texture.hpp"

#include <cmath>

#include "io/gltf_value.hpp"

namespace tyn::io {
namespace {

uint32_t wrap_mode(int mode, const char *which, int sampler) {
  switch (mode) {
  case -1: // absent
  case TINYGLTF_TEXTURE_WRAP_REPEAT:
    return TYN_WRAP_REPEAT;
  case TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE:
    return TYN_WRAP_CLAMP;
  case TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT:
    return TYN_WRAP_MIRROR;
  default:
    fail(TYN_ERROR_FORMAT, "samplers[%d].%s is %d; it must be 10497, 33071 or 33648", sampler, which, mode);
  }
}

// KHR_texture_transform: scale, then rotation, then offset. Its rotation is counter-clockwise with v downwards.
void apply_transform(const tinygltf::Value &value, TynTexture &texture, const std::string &where) {
  double offset[2] = {0, 0}, scale[2] = {1, 1};
  numbers(value, "offset", offset);
  numbers(value, "scale", scale);
  const double angle = number(value, "rotation", 0);
  const double c = std::cos(angle), s = std::sin(angle);
  const double transform[6] = {c * scale[0], s * scale[1], offset[0], -s * scale[0], c * scale[1], offset[1]};
  for (int i = 0; i < 6; i++) {
    texture.transform[i] = float(transform[i]);
    if (!std::isfinite(texture.transform[i]))
      fail(TYN_ERROR_FORMAT, "%s.extensions.KHR_texture_transform is too large for single precision", where.c_str());
  }
}

} // namespace

void GltfTextures::apply_sampler(int index, TynTexture &texture) {
  const tinygltf::Sampler &sampler = document.model.samplers[size_t(index)];
  texture.wrap_u = wrap_mode(sampler.wrapS, "wrapS", index);
  texture.wrap_v = wrap_mode(sampler.wrapT, "wrapT", index);
  if (sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST)
    texture.filter = TYN_FILTER_NEAREST;
}

TynTexture GltfTextures::make(int index, int set, const tinygltf::ExtensionMap &extensions, ColorSpace space,
                              const std::string &where, int &uv_set) {
  const tinygltf::Texture &source = document.model.textures[size_t(index)];
  if (source.source < 0) {
    warnings.add("textures[%d] has no PNG or JPEG image: %s is ignored", index, where.c_str());
    return tyn_texture();
  }
  TynTexture texture = tyn_texture();
  if (const tinygltf::Value *transform = extension(extensions, "KHR_texture_transform")) {
    apply_transform(*transform, texture, where);
    set = int(number(*transform, "texCoord", set));
  }
  if (uv_set < 0)
    uv_set = set;
  if (set != uv_set) {
    warnings.add(
        "%s uses TEXCOORD_%d, but the material's first texture uses TEXCOORD_%d: one set is supported, and the "
        "texture is ignored",
        where.c_str(), set, uv_set);
    return tyn_texture();
  }
  if (source.sampler >= 0)
    apply_sampler(source.sampler, texture);
  texture.image = images.load(source.source, space);
  return texture;
}

TynTexture GltfTextures::get(const tinygltf::Value &object, const char *key, ColorSpace space, const std::string &where,
                             int &uv_set) {
  const tinygltf::Value *info = member(object, key);
  if (!info)
    return tyn_texture();
  tinygltf::ExtensionMap extensions;
  if (const tinygltf::Value *nested = member(*info, "extensions"))
    for (const std::string &name : nested->Keys())
      extensions[name] = nested->Get(name);
  return make(int(number(*info, "index", 0)), int(number(*info, "texCoord", 0)), extensions, space, where + "." + key,
              uv_set);
}

} // namespace tyn::io
