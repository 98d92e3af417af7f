// SPDX-License-Identifier: Apache-2.0
// What a scene holds on the host, and, once committed, on the device.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/context.hpp"
#include "kernels/shared.h"
#include "media/phase.hpp"

namespace tyn {

struct Vec2 {
  float x, y;
};
struct Vec3 {
  float x, y, z;
};

struct Mesh {
  std::string name;
  std::vector<Vec3> positions;
  std::vector<Vec3> normals;       // empty, or one a vertex, unit length
  std::vector<Vec2> uvs;           // empty, or one a vertex
  std::vector<uint32_t> indices;   // 3 a triangle; turned outwards if there is a medium
  std::vector<uint32_t> materials; // one a triangle; TYN_NONE: default material
  std::vector<uint8_t> turned;     // one a triangle: 1 if its second and third index were exchanged
  uint32_t medium = TYN_NONE;
  uint32_t material = TYN_NONE;
  TynMeshInfo info{}; // `name` is filled in on request
};

struct Image {
  std::string name;
  uint32_t width = 0, height = 0;
  uint32_t format = 0;               // TYN_IMAGE_*
  std::vector<unsigned char> pixels; // tightly packed
};

// The public struct, with an owned name.
template <class T>
struct Named {
  T value{};
  std::string name;
};

// value.phase points into `phase`, or is NULL: what callers are handed stays where it is when the list of media grows.
struct Medium : Named<TynMedium> {
  std::shared_ptr<const OwnedPhase> phase;
};

// The committed scene's buffers.
struct SceneBuffers {
  Buffer nodes;        // TynBvhNode
  Buffer blocks;       // TynTriangleBlock
  Buffer triangles;    // TynTriangleRecord
  Buffer positions;    // float x, y, z a vertex
  Buffer normals;      // float x, y, z a vertex; zeros for meshes without
  Buffer uvs;          // float u, v a vertex; zeros for meshes without
  Buffer meshes;       // TynMeshRecord
  Buffer media;        // TynMediumRecord
  Buffer phases;       // TynPhaseRecord of the media that have one
  Buffer phase_tables; // float
  Buffer cells;        // of the meshes' grids: see distance_bound.clh and local_roots.clh
  Buffer walk_queue;   // a uint: see WalkQueue in walk.cl
  Buffer turned;       // a bit a triangle, 32 in a uint: Mesh::turned; callers' u and v are exchanged there
};

} // namespace tyn

struct TynScene {
  explicit TynScene(TynContext &context);
  void retain();
  void release();

  void require_open() const;              // throws INVALID_OPERATION after commit
  void require_committed() const;         // throws INVALID_OPERATION before commit
  void require_mesh(uint32_t mesh) const; // throws INVALID_ARGUMENT unless a mesh index or TYN_NONE
  uint32_t root(uint32_t mesh) const;     // BVH root of a mesh, or of the scene for TYN_NONE

  TynContext &context; // retained
  double metres_per_unit = 1.0;
  bool committed = false;
  std::vector<tyn::Mesh> meshes;
  std::vector<tyn::Image> images;
  std::vector<tyn::Medium> media;
  std::vector<tyn::Named<TynMaterial>> materials;
  std::vector<tyn::Named<TynLight>> lights;
  std::vector<tyn::Named<TynCamera>> cameras;
  TynEnvironment environment{};
  uint32_t default_material = TYN_NONE; // appended to `materials` by commit if a triangle has none

  // After commit. The renderer uploads materials, images and lights itself, in its own records.
  std::vector<TynMeshRecord> mesh_records;
  std::vector<TynMediumRecord> medium_records;
  uint32_t triangle_count = 0; // of all meshes
  float lower[3], upper[3];    // of all meshes
  tyn::SceneBuffers buffers;

private:
  ~TynScene();
  std::atomic<uint32_t> references{1};
};
