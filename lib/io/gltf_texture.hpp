// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Textures: an image, how it is sampled, and where it lies on the surface.
#pragma once

#include "io/gltf_image.hpp"

namespace tyn::io {

// Turns texture references of materials into the API's textures. A mesh of the API has one set of texture coordinates: the
// first reference of a material decides which, others are warned about.
class GltfTextures {
public:
  GltfTextures(GltfDocument &source, GltfImages &loaded, Warnings &sink)
      : document(source), images(loaded), warnings(sink) {}

  // A reference of the core schema: TextureInfo, NormalTextureInfo.
  template <class Info>
  TynTexture get(const Info &info, ColorSpace space, const std::string &where, int &uv_set) {
    return info.index < 0 ? tyn_texture() : make(info.index, info.texCoord, info.extensions, space, where, uv_set);
  }
  // Member `key` of an extension; no texture if there is none.
  TynTexture get(const tinygltf::Value &extension, const char *key, ColorSpace space, const std::string &where,
                 int &uv_set);

private:
  TynTexture make(int index, int uv_set_of_texture, const tinygltf::ExtensionMap &extensions, ColorSpace space,
                  const std::string &where, int &uv_set);
  void apply_sampler(int index, TynTexture &texture);

  GltfDocument &document;
  GltfImages &images;
  Warnings &warnings;
};

} // namespace tyn::io
