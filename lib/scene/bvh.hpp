// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The acceleration structure of kernels/shared.h over all meshes of a scene.
#pragma once

#include <vector>

#include "scene/scene.hpp"

namespace tyn {

struct Bvh {
  std::vector<TynBvhNode> nodes; // node 0 is the scene's root
  std::vector<TynTriangleBlock> blocks;
  std::vector<uint32_t> roots; // of each mesh
  uint32_t depth = 0;          // levels of inner nodes, from node 0 down
};

// How far the bounds of a mesh's nodes are widened, and how far behind its origin a ray may still hit: 2^-20 of the
// largest absolute coordinate, rounded up to a power of two.
float mesh_slack(const Mesh &mesh);

// Of a mesh's bounds.
double longest_side(const TynMeshRecord &record);

// The same bytes for the same meshes, whatever the number of threads. Scaling all positions by a power of two changes
// only the exponents in it. Throws OUT_OF_MEMORY or, for trees that the traversal stack cannot hold, INTERNAL.
Bvh build_bvh(const std::vector<Mesh> &meshes);

} // namespace tyn
