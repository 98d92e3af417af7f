// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Meshes in world space.
#pragma once

#include "io/gltf_material.hpp"
#include "io/gltf_nodes.hpp"
#include "io/gltf_primitive.hpp"

namespace tyn::io {

// Adds the meshes that nodes place. The primitives of one node that hold the same medium become one mesh, with a material for
// each triangle: a closed object may be made of several primitives.
class GltfMeshes {
public:
  GltfMeshes(GltfDocument &source, const TynGltfOptions &options, Warnings &sink, LoadedScene &result);

  void add(const PlacedNode &node);

private:
  struct Piece;
  std::vector<Piece> read_pieces(int mesh);
  void append(const Piece &piece, const Affine &world, LoadedMesh &mesh);
  void count(const Triangles &triangles, const std::string &where);
  void warn_about_uvs(const Triangles &triangles, const MaterialUse &use, const std::string &where);

  GltfDocument &document;
  Warnings &warnings;
  LoadedScene &scene;
  GltfAccessors accessors;
  GltfMaterials materials;
  uint64_t max_triangles;
  uint64_t triangle_count = 0;
};

} // namespace tyn::io
