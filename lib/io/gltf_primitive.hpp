// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// One primitive of a mesh as an indexed list of triangles.
#pragma once

#include "io/gltf_accessor.hpp"

namespace tyn::io {

struct Triangles {
  std::vector<float> positions; // in the mesh's space, only vertices that a triangle uses
  std::vector<float> normals;   // empty: none
  std::vector<float> uvs;       // empty: none
  std::vector<uint32_t> indices;

  size_t vertex_count() const { return positions.size() / 3; }
  size_t triangle_count() const { return indices.size() / 3; }
};

// Reads a primitive: lists, strips and fans, indexed or not. Points, lines and triangles that use fewer than three vertices in all give no triangles and a warning. `uv_set`: which
// TEXCOORD_n. Throws FORMAT.
Triangles read_primitive(GltfDocument &document, GltfAccessors &accessors, const tinygltf::Primitive &primitive,
                         int uv_set, const std::string &where, Warnings &warnings);

// Gives every triangle vertices of its own, with its geometric normal: flat shading as glTF wants it of a mesh without normals.
void add_flat_normals(Triangles &triangles);

} // namespace tyn::io
