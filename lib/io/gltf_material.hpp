// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Materials: glTF 2.0 metallic-roughness with its extensions.
#pragma once

#include <map>

#include "io/gltf_medium.hpp"
#include "io/gltf_texture.hpp"

namespace tyn::io {

// What a primitive needs to know of its material.
struct MaterialUse {
  uint32_t material = 0;
  uint32_t medium = TYN_NONE;
  int uv_set = 0; // TEXCOORD_n of its textures
};

class GltfMaterials {
public:
  GltfMaterials(GltfDocument &source, const TynGltfOptions &given, Warnings &sink, LoadedScene &result);

  // Material `index` of the file, -1 for the default one; converted when first asked for.
  MaterialUse get(int index);

private:
  struct Builder;
  MaterialUse build(const tinygltf::Material &source, const std::string &where, bool unnamed);
  void read_surface(Builder &builder);
  void read_emission(Builder &builder);
  void read_transmission(Builder &builder);
  void fill_with_preset(Builder &builder, const char *preset);
  void fill_with_volume(Builder &builder, const tinygltf::Value &volume);
  void make_thin(Builder &builder);
  void let_light_in(Builder &builder);
  void warn_about_what_is_ignored(const Builder &builder);
  uint32_t add_medium(const TynMedium &medium, const std::string &name);

  GltfDocument &document;
  const TynGltfOptions &options;
  Warnings &warnings;
  LoadedScene &scene;
  GltfImages images;
  GltfTextures textures;
  std::map<int, MaterialUse> known;
};

} // namespace tyn::io
