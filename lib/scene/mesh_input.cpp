// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/mesh_input.hpp"

#include <cstring>

#include "core/argument.hpp"
#include "scene/mesh_check.hpp"
#include "scene/vector.hpp"

namespace tyn {
namespace {

// Products of three coordinates must stay far from the largest float (3.4e38) in the ray-triangle test.
constexpr float MAX_COORDINATE = 1e10f;
// Scene-wide. Blocks of triangles are numbered with 27 bits; kernels compute 3 x vertex in 32 bits.
constexpr uint64_t MAX_TRIANGLES = (1u << 27) - 2, MAX_VERTICES = 1u << 30;

const char AXIS[] = "xyz";

void require_counts(const TynMesh &given, const TynScene &scene) {
  if (given.vertex_count < 3)
    fail(TYN_ERROR_INVALID_ARGUMENT, "TynMesh::vertex_count is %u; it must be at least 3", given.vertex_count);
  if (given.triangle_count < 1)
    fail(TYN_ERROR_INVALID_ARGUMENT, "TynMesh::triangle_count is 0; it must be at least 1");
  uint64_t vertices = given.vertex_count, triangles = given.triangle_count;
  for (const Mesh &mesh : scene.meshes) {
    vertices += mesh.positions.size();
    triangles += mesh.indices.size() / 3;
  }
  if (vertices > MAX_VERTICES)
    fail(TYN_ERROR_INVALID_ARGUMENT, "TynMesh::vertex_count is %u: the scene would have %llu vertices; at most %llu",
         given.vertex_count, static_cast<unsigned long long>(vertices), static_cast<unsigned long long>(MAX_VERTICES));
  if (triangles > MAX_TRIANGLES)
    fail(TYN_ERROR_INVALID_ARGUMENT, "TynMesh::triangle_count is %u: the scene would have %llu triangles; at most %llu",
         given.triangle_count, static_cast<unsigned long long>(triangles),
         static_cast<unsigned long long>(MAX_TRIANGLES));
}

// One record of N floats a vertex, `stride` bytes apart (0: without gaps).
template <class T>
std::vector<T> read_vertices(const char *name, const float *source, size_t stride, uint32_t count) {
  if (stride == 0)
    stride = sizeof(T);
  if (stride < sizeof(T))
    fail(TYN_ERROR_INVALID_ARGUMENT, "TynMesh::%s_stride is %zu; it must be 0 or at least %zu", name, stride,
         sizeof(T));
  size_t total;
  if (__builtin_mul_overflow(stride, size_t(count), &total))
    fail(TYN_ERROR_INVALID_ARGUMENT, "TynMesh::%s_stride is %zu: %u vertices of it overflow", name, stride, count);
  std::vector<T> result(count);
  for (size_t i = 0; i < count; i++)
    std::memcpy(&result[i], reinterpret_cast<const char *>(source) + i * stride, sizeof(T));
  return result;
}

void read_positions(const TynMesh &given, Mesh &mesh) {
  require_pointer("TynMesh::positions", given.positions);
  mesh.positions = read_vertices<Vec3>("position", given.positions, given.position_stride, given.vertex_count);
  for (size_t i = 0; i < mesh.positions.size(); i++)
    for (int k = 0; k < 3; k++) {
      const float value = (&mesh.positions[i].x)[k];
      if (!(std::abs(value) <= MAX_COORDINATE))
        fail(TYN_ERROR_INVALID_ARGUMENT, "TynMesh::positions[%zu].%c is %g; it must be finite and in [-%g, %g]", i,
             AXIS[k], double(value), double(MAX_COORDINATE), double(MAX_COORDINATE));
    }
}

void read_normals(const TynMesh &given, Mesh &mesh) {
  if (!given.normals)
    return;
  mesh.normals = read_vertices<Vec3>("normal", given.normals, given.normal_stride, given.vertex_count);
  for (size_t i = 0; i < mesh.normals.size(); i++) {
    Vec3 &n = mesh.normals[i];
    for (int k = 0; k < 3; k++)
      if (!std::isfinite((&n.x)[k]))
        fail(TYN_ERROR_INVALID_ARGUMENT, "TynMesh::normals[%zu].%c is %g; it must be finite", i, AXIS[k],
             double((&n.x)[k]));
    const Double3 wide = to_double(n);
    const double size = length(wide);
    // One that is 0 is found from the triangles later.
    if (size > 0)
      n = {float(wide.x / size), float(wide.y / size), float(wide.z / size)};
  }
}

void read_uvs(const TynMesh &given, Mesh &mesh) {
  if (!given.uvs)
    return;
  mesh.uvs = read_vertices<Vec2>("uv", given.uvs, given.uv_stride, given.vertex_count);
  for (size_t i = 0; i < mesh.uvs.size(); i++)
    if (!std::isfinite(mesh.uvs[i].x) || !std::isfinite(mesh.uvs[i].y))
      fail(TYN_ERROR_INVALID_ARGUMENT, "TynMesh::uvs[%zu] is (%g, %g); it must be finite", i, double(mesh.uvs[i].x),
           double(mesh.uvs[i].y));
}

void read_indices(const TynMesh &given, Mesh &mesh) {
  require_pointer("TynMesh::indices", given.indices);
  mesh.indices.assign(given.indices, given.indices + 3 * size_t(given.triangle_count));
  for (size_t i = 0; i < mesh.indices.size(); i++)
    if (mesh.indices[i] >= given.vertex_count)
      fail(TYN_ERROR_INVALID_ARGUMENT, "TynMesh::indices[%zu] (triangle %zu) is %u, but the mesh has %u vertices", i,
           i / 3, mesh.indices[i], given.vertex_count);
}

void read_materials(const TynMesh &given, const TynScene &scene, Mesh &mesh) {
  require_index_or_none("TynMesh::medium", given.medium, scene.media.size(), "media");
  require_index_or_none("TynMesh::material", given.material, scene.materials.size(), "materials");
  mesh.medium = given.medium;
  mesh.material = given.material;
  mesh.materials.assign(given.triangle_count, given.material);
  for (size_t i = 0; given.triangle_materials && i < given.triangle_count; i++) {
    const uint32_t material = given.triangle_materials[i];
    if (material != TYN_NONE && material >= scene.materials.size())
      fail(TYN_ERROR_INVALID_ARGUMENT, "TynMesh::triangle_materials[%zu] is %u, but the scene has %zu materials", i,
           material, scene.materials.size());
    mesh.materials[i] = material;
  }
}

// Files do hold normals of length 0. They become the mean of the triangles around, weighted by area.
void repair_normals(Mesh &mesh) {
  auto missing = [](const Vec3 &n) { return n.x == 0 && n.y == 0 && n.z == 0; };
  std::vector<Double3> sums;
  for (size_t i = 0; i < mesh.indices.size() && !mesh.normals.empty(); i++) {
    if (!missing(mesh.normals[mesh.indices[i]]))
      continue;
    if (sums.empty())
      sums.resize(mesh.normals.size(), Double3{0, 0, 0});
    Double3 &sum = sums[mesh.indices[i]];
    sum = sum + area_vector(mesh, i / 3);
  }
  for (size_t i = 0; i < mesh.normals.size(); i++) {
    if (!missing(mesh.normals[i]))
      continue;
    const Double3 sum = sums.empty() ? Double3{0, 0, 0} : sums[i];
    const double size = length(sum);
    mesh.normals[i] = size > 0 ? Vec3{float(sum.x / size), float(sum.y / size), float(sum.z / size)} : Vec3{0, 1, 0};
  }
}

} // namespace

Mesh read_mesh(const TynMesh &given, const TynScene &scene) {
  require_counts(given, scene);
  Mesh mesh;
  mesh.name = given.name ? given.name : "";
  read_positions(given, mesh);
  read_normals(given, mesh);
  read_uvs(given, mesh);
  read_indices(given, mesh);
  read_materials(given, scene, mesh);
  check_mesh(mesh);
  repair_normals(mesh);
  mesh.info.medium = mesh.medium;
  mesh.info.material = mesh.material;
  return mesh;
}

} // namespace tyn
