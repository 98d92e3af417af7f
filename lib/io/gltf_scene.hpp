// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// What a glTF file turns into, complete and checked before anything is added to the caller's scene. Indices count from 0
// within the file.
#pragma once

#include <string>
#include <vector>

#include "io/failure.hpp"
#include "io/input_file.hpp"

namespace tyn::io {

// A struct of the API whose name member points to `name` once it is added.
template <class T>
struct Named {
  std::string name;
  T value;
};

struct LoadedImage {
  std::string name;
  uint32_t width = 0, height = 0;
  uint32_t format = TYN_IMAGE_RGBA8_LINEAR;
  Bytes pixels;
};

struct LoadedMesh {
  std::string name;
  std::vector<float> positions; // world space
  std::vector<float> normals;   // empty: none
  std::vector<float> uvs;       // empty: none
  std::vector<uint32_t> indices;
  std::vector<uint32_t> triangle_materials;
  uint32_t medium = TYN_NONE;
};

struct LoadedScene {
  std::vector<LoadedImage> images;
  std::vector<Named<TynMedium>> media;
  std::vector<Named<TynMaterial>> materials;
  std::vector<LoadedMesh> meshes;
  std::vector<Named<TynLight>> lights;
  std::vector<Named<TynCamera>> cameras;
};

// Reads the default scene of a glTF file. Throws Failure.
LoadedScene read_gltf(const std::string &path, const TynGltfOptions &options, Warnings &warnings);

} // namespace tyn::io
