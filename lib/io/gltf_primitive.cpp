// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "io/gltf_primitive.hpp"

#include <cmath>

#include "io/affine.hpp"

namespace tyn::io {
namespace {

bool is_listed(const tinygltf::Primitive &primitive, const char *attribute) {
  return primitive.attributes.count(attribute) != 0;
}

// Vertices in the order in which the primitive draws them.
std::vector<uint32_t> drawn_vertices(GltfAccessors &accessors, const tinygltf::Primitive &primitive,
                                     size_t vertex_count, const std::string &where) {
  std::vector<uint32_t> vertices;
  if (primitive.indices < 0) {
    vertices.resize(vertex_count);
    for (size_t i = 0; i < vertex_count; i++)
      vertices[i] = uint32_t(i);
    return vertices;
  }
  vertices = accessors.indices(primitive.indices, where + ".indices");
  for (size_t i = 0; i < vertices.size(); i++)
    if (vertices[i] >= vertex_count)
      fail(TYN_ERROR_FORMAT, "%s.indices (accessors[%d]): element %zu is %u, but there are %zu vertices", where.c_str(),
           primitive.indices, i, vertices[i], vertex_count);
  return vertices;
}

// glTF 2.0, section 3.7.2.1: which vertices make triangle i.
std::vector<uint32_t> assemble(const std::vector<uint32_t> &vertices, int mode) {
  if (mode == TINYGLTF_MODE_TRIANGLES)
    return {vertices.begin(), vertices.end() - std::ptrdiff_t(vertices.size() % 3)};
  std::vector<uint32_t> triangles;
  for (size_t i = 0; i + 2 < vertices.size(); i++) {
    const bool strip = mode == TINYGLTF_MODE_TRIANGLE_STRIP;
    const uint32_t a = vertices[strip ? i : i + 1];
    const uint32_t b = vertices[strip ? i + 1 + i % 2 : i + 2];
    const uint32_t c = vertices[strip ? i + 2 - i % 2 : 0];
    if (a != b && b != c && c != a) // strips repeat vertices to jump
      triangles.insert(triangles.end(), {a, b, c});
  }
  return triangles;
}

void check_finite(const std::vector<float> &values, int components, int accessor, const std::string &where) {
  for (size_t i = 0; i < values.size(); i++)
    if (!std::isfinite(values[i]))
      fail(TYN_ERROR_FORMAT, "%s (accessors[%d]): element %zu is %g; it must be finite", where.c_str(), accessor,
           i / size_t(components), double(values[i]));
}

// An attribute that may be absent; it must have as many elements as the positions.
std::vector<float> optional_attribute(GltfAccessors &accessors, const tinygltf::Primitive &primitive, const char *name,
                                      int components, size_t vertex_count, const std::string &where) {
  const auto found = primitive.attributes.find(name);
  if (found == primitive.attributes.end())
    return {};
  const std::string inside = where + ".attributes." + name;
  std::vector<float> values = accessors.floats(found->second, components, inside);
  if (values.size() != vertex_count * size_t(components))
    fail(TYN_ERROR_FORMAT, "%s (accessors[%d]) has %zu elements, but POSITION has %zu", inside.c_str(), found->second,
         values.size() / size_t(components), vertex_count);
  return values;
}

void copy_vertex(const std::vector<float> &from, std::vector<float> &to, size_t vertex, size_t components) {
  if (!from.empty())
    to.insert(to.end(), from.begin() + std::ptrdiff_t(vertex * components),
              from.begin() + std::ptrdiff_t((vertex + 1) * components));
}

// Drops the vertices that no triangle uses: primitives often share one large accessor.
Triangles compacted(const Triangles &all) {
  Triangles result;
  std::vector<uint32_t> moved(all.vertex_count(), TYN_NONE);
  result.indices.reserve(all.indices.size());
  for (const uint32_t vertex : all.indices) {
    if (moved[vertex] == TYN_NONE) {
      moved[vertex] = uint32_t(result.vertex_count());
      copy_vertex(all.positions, result.positions, vertex, 3);
      copy_vertex(all.normals, result.normals, vertex, 3);
      copy_vertex(all.uvs, result.uvs, vertex, 2);
    }
    result.indices.push_back(moved[vertex]);
  }
  return result;
}

void warn_about_primitive(const tinygltf::Primitive &primitive, const std::string &where, Warnings &warnings) {
  if (!primitive.targets.empty())
    warnings.add("%s has morph targets, which are not supported: the mesh keeps its base shape", where.c_str());
  if (is_listed(primitive, "COLOR_0"))
    warnings.add("%s has vertex colours, which are not supported and ignored", where.c_str());
}

bool gives_triangles(const tinygltf::Primitive &primitive, const std::string &where, Warnings &warnings) {
  const bool triangles = primitive.mode >= TINYGLTF_MODE_TRIANGLES;
  if (!triangles)
    warnings.add("%s draws %s, which are ignored", where.c_str(),
                 primitive.mode == TINYGLTF_MODE_POINTS ? "points" : "lines");
  else if (!is_listed(primitive, "POSITION"))
    warnings.add("%s has no POSITION and is ignored", where.c_str());
  return triangles && is_listed(primitive, "POSITION");
}

// A file may offer Draco data beside ordinary accessors; without these it cannot be read.
void check_draco(const GltfDocument &document, const tinygltf::Primitive &primitive, const std::string &where) {
  if (!primitive.extensions.count("KHR_draco_mesh_compression"))
    return;
  const tinygltf::Accessor &positions = document.model.accessors[size_t(primitive.attributes.at("POSITION"))];
  if (positions.bufferView < 0 && !positions.sparse.isSparse)
    fail(TYN_ERROR_FORMAT,
         "%s is compressed with KHR_draco_mesh_compression, which is not supported: save the model "
         "without compression or with EXT_meshopt_compression",
         where.c_str());
}

} // namespace

Triangles read_primitive(GltfDocument &document, GltfAccessors &accessors, const tinygltf::Primitive &primitive,
                         int uv_set, const std::string &where, Warnings &warnings) {
  if (!gives_triangles(primitive, where, warnings))
    return {};
  check_draco(document, primitive, where);
  warn_about_primitive(primitive, where, warnings);
  const int position = primitive.attributes.at("POSITION");
  Triangles all;
  all.positions = accessors.floats(position, 3, where + ".attributes.POSITION");
  check_finite(all.positions, 3, position, where + ".attributes.POSITION");
  const std::string uv_name = "TEXCOORD_" + std::to_string(uv_set);
  all.normals = optional_attribute(accessors, primitive, "NORMAL", 3, all.vertex_count(), where);
  all.uvs = optional_attribute(accessors, primitive, uv_name.c_str(), 2, all.vertex_count(), where);
  if (!all.uvs.empty())
    check_finite(all.uvs, 2, primitive.attributes.at(uv_name), where + ".attributes." + uv_name);
  const std::vector<uint32_t> vertices = drawn_vertices(accessors, primitive, all.vertex_count(), where);
  if (primitive.mode == TINYGLTF_MODE_TRIANGLES && vertices.size() % 3 != 0)
    warnings.add("%s has %zu indices, which is not a multiple of 3; the last ones are ignored", where.c_str(),
                 vertices.size());
  all.indices = assemble(vertices, primitive.mode);
  if (all.indices.empty())
    warnings.add("%s has no triangles", where.c_str());
  Triangles used = compacted(all);
  if (used.vertex_count() >= 3 || all.indices.empty())
    return used;
  // Such a primitive shows nothing, and a mesh of it alone would be refused by the scene.
  warnings.add("%s has only triangles that repeat a vertex (they use %zu in all) and is ignored", where.c_str(),
               used.vertex_count());
  return {};
}

void add_flat_normals(Triangles &triangles) {
  Triangles flat;
  for (size_t t = 0; t < triangles.triangle_count(); t++) {
    Vector corner[3];
    for (size_t k = 0; k < 3; k++) {
      const uint32_t vertex = triangles.indices[3 * t + k];
      for (size_t c = 0; c < 3; c++)
        corner[k][c] = triangles.positions[vertex * size_t(3) + c];
      flat.indices.push_back(uint32_t(flat.indices.size()));
      copy_vertex(triangles.positions, flat.positions, vertex, 3);
      copy_vertex(triangles.uvs, flat.uvs, vertex, 2);
    }
    const Vector normal = cross(corner[1] - corner[0], corner[2] - corner[0]);
    const double size = length(normal);
    for (int k = 0; k < 3; k++)
      for (size_t c = 0; c < 3; c++) // a triangle without area is never seen: any normal will do
        flat.normals.push_back(size > 0 ? float(normal[c] / size) : float(c == 2));
  }
  triangles = std::move(flat);
}

} // namespace tyn::io
