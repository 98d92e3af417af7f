// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// From what was added to what kernels read. Everything is made aside first: a commit that fails changes nothing.
#include "scene/commit.hpp"

#include <algorithm>
#include <utility>

#include "scene/bvh.hpp"
#include "scene/distance_grid.hpp"
#include "scene/horizons.hpp"
#include "scene/local_roots.hpp"

namespace tyn {
namespace {

// The arrays of all meshes, one after the other.
struct Geometry {
  std::vector<TynTriangleRecord> triangles;
  std::vector<Vec3> positions, normals;
  std::vector<Vec2> uvs;
  std::vector<uint32_t> turned; // a bit a triangle
};

bool needs_default_material(const TynScene &scene) {
  for (const Mesh &mesh : scene.meshes)
    if (std::find(mesh.materials.begin(), mesh.materials.end(), TYN_NONE) != mesh.materials.end())
      return true;
  return false;
}

void append_triangles(Geometry &geometry, const Mesh &mesh, uint32_t mesh_index, uint32_t default_material) {
  const uint32_t first_vertex = uint32_t(geometry.positions.size());
  for (size_t i = 0; i < mesh.materials.size(); i++) {
    const uint32_t *index = &mesh.indices[3 * i];
    const uint32_t material = mesh.materials[i] == TYN_NONE ? default_material : mesh.materials[i];
    const size_t number = geometry.triangles.size();
    if (number % 32 == 0)
      geometry.turned.push_back(0);
    geometry.turned.back() |= uint32_t(mesh.turned[i]) << number % 32;
    geometry.triangles.push_back({{first_vertex + index[0], first_vertex + index[1], first_vertex + index[2]},
                                  mesh_index,
                                  material,
                                  TYN_NO_HORIZON});
  }
}

Geometry concatenate(const TynScene &scene, uint32_t default_material) {
  Geometry geometry;
  for (uint32_t i = 0; i < scene.meshes.size(); i++) {
    const Mesh &mesh = scene.meshes[i];
    append_triangles(geometry, mesh, i, default_material);
    geometry.positions.insert(geometry.positions.end(), mesh.positions.begin(), mesh.positions.end());
    geometry.normals.insert(geometry.normals.end(), mesh.normals.begin(), mesh.normals.end());
    geometry.uvs.insert(geometry.uvs.end(), mesh.uvs.begin(), mesh.uvs.end());
    // zeros for what the mesh lacks
    geometry.normals.resize(geometry.positions.size(), Vec3{0, 0, 0});
    geometry.uvs.resize(geometry.positions.size(), Vec2{0, 0});
  }
  return geometry;
}

TynMeshRecord mesh_record(const Mesh &mesh, uint32_t root, uint32_t first_triangle) {
  TynMeshRecord record{};
  record.root = root;
  record.first_triangle = first_triangle;
  record.triangle_count = mesh.info.triangle_count;
  record.medium = mesh.medium;
  record.flags = (mesh.normals.empty() ? 0 : TYN_MESH_HAS_NORMALS) | (mesh.uvs.empty() ? 0 : TYN_MESH_HAS_UVS) |
                 (mesh.info.closed ? TYN_MESH_CLOSED : 0);
  record.slack = mesh_slack(mesh);
  for (int k = 0; k < 3; k++) {
    record.lower[k] = mesh.info.lower[k] - record.slack;
    record.upper[k] = mesh.info.upper[k] + record.slack;
  }
  return record;
}

std::vector<TynMeshRecord> mesh_records(const TynScene &scene, const std::vector<uint32_t> &roots) {
  std::vector<TynMeshRecord> records;
  uint32_t first_triangle = 0;
  for (size_t i = 0; i < scene.meshes.size(); i++) {
    records.push_back(mesh_record(scene.meshes[i], roots[i], first_triangle));
    first_triangle += records.back().triangle_count;
  }
  return records;
}

template <class T>
Buffer upload(TynContext &context, const std::vector<T> &values) {
  Buffer buffer(context, values.size() * sizeof(T), CL_MEM_READ_ONLY);
  context.write(buffer, values.data(), values.size() * sizeof(T));
  return buffer;
}

struct Media {
  std::vector<TynMediumRecord> records;
  std::vector<TynPhaseRecord> phases;
  PhaseTables tables;
};

// Henyey-Greenstein's function, however it was named, needs no record: walks have it built in.
void append_medium(Media &media, const TynMedium &medium) {
  TynMediumRecord record = medium_record(medium);
  if (medium.phase) {
    const TynPhaseRecord phase = media.tables.add(*medium.phase);
    if (phase.kind != TYN_PHASE_HENYEY_GREENSTEIN) {
      record.phase = uint32_t(media.phases.size());
      media.phases.push_back(phase);
    }
  }
  media.records.push_back(record);
}

void commit(TynScene &scene) {
  if (scene.meshes.empty())
    fail(TYN_ERROR_INVALID_OPERATION, "the scene has no mesh");
  Named<TynMaterial> default_material;
  default_material.value = tyn_material();
  const bool add_default = needs_default_material(scene);
  const uint32_t default_index = add_default ? uint32_t(scene.materials.size()) : TYN_NONE;

  Bvh bvh = build_bvh(scene.meshes);
  Geometry geometry = concatenate(scene, default_index);
  std::vector<TynMeshRecord> meshes = mesh_records(scene, bvh.roots);
  Media media;
  for (const Medium &medium : scene.media)
    append_medium(media, medium.value);
  // what only makes walks faster gives way to what is needed under a tight memory limit
  const uint64_t most_bytes = scene.context.memory_available() / 16;
  std::vector<uint32_t> cells = build_distance_grids(scene.meshes, media.records, meshes, most_bytes);
  find_horizons(scene.meshes, bvh, meshes, geometry.triangles);
  add_local_roots(bvh, meshes, cells, most_bytes);

  SceneBuffers buffers;
  buffers.nodes = upload(scene.context, bvh.nodes);
  buffers.blocks = upload(scene.context, bvh.blocks);
  buffers.triangles = upload(scene.context, geometry.triangles);
  buffers.positions = upload(scene.context, geometry.positions);
  buffers.normals = upload(scene.context, geometry.normals);
  buffers.uvs = upload(scene.context, geometry.uvs);
  buffers.meshes = upload(scene.context, meshes);
  buffers.media = upload(scene.context, media.records);
  buffers.phases = upload(scene.context, media.phases);
  buffers.phase_tables = upload(scene.context, media.tables.data);
  buffers.cells = upload(scene.context, cells);
  buffers.walk_queue = Buffer(scene.context, sizeof(uint32_t));
  buffers.turned = upload(scene.context, geometry.turned);
  if (add_default)
    scene.materials.push_back(std::move(default_material));

  // Nothing below can fail.
  scene.default_material = default_index;
  scene.mesh_records = std::move(meshes);
  scene.medium_records = std::move(media.records);
  scene.triangle_count = uint32_t(geometry.triangles.size());
  scene.buffers = std::move(buffers);
  for (const Mesh &mesh : scene.meshes)
    for (int k = 0; k < 3; k++) {
      scene.lower[k] = std::min(scene.lower[k], mesh.info.lower[k]);
      scene.upper[k] = std::max(scene.upper[k], mesh.info.upper[k]);
    }
  scene.committed = true;
}

} // namespace

TynMediumRecord medium_record(const TynMedium &medium) {
  TynMediumRecord record{};
  record.g = medium.phase ? PhaseTables::henyey_greenstein(phase_mean_cosine(*medium.phase)).g : medium.g;
  record.phase = TYN_NONE;
  record.ior = medium.ior;
  for (int i = 0; i < 3; i++) {
    const double sigma_t = double(medium.sigma_a[i]) + double(medium.sigma_s[i]);
    record.sigma_t[i] = float(sigma_t);
    record.albedo[i] = sigma_t > 0 ? float(double(medium.sigma_s[i]) / sigma_t) : 0.0f;
  }
  return record;
}

} // namespace tyn

extern "C" TynStatus tyn_scene_commit(TynScene *scene) {
  if (!scene)
    return TYN_ERROR_INVALID_ARGUMENT;
  return tyn::guarded(&scene->context, [&] {
    scene->require_open();
    tyn::commit(*scene);
  });
}
