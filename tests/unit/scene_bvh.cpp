// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <set>
#include <thread>

#include "common/meshes.hpp"
#include "scene/bvh.hpp"
#include "scene/mesh_check.hpp"

#include <gtest/gtest.h>

using namespace tyn_test;

namespace {

tyn::Mesh to_mesh(const MeshData &data) {
  tyn::Mesh mesh;
  for (size_t i = 0; i < data.positions.size(); i += 3)
    mesh.positions.push_back({data.positions[i], data.positions[i + 1], data.positions[i + 2]});
  mesh.indices = data.indices;
  tyn::check_mesh(mesh);
  return mesh;
}

std::vector<tyn::Mesh> to_meshes(const std::vector<NamedMesh> &list) {
  std::vector<tyn::Mesh> meshes;
  for (const NamedMesh &named : list)
    meshes.push_back(to_mesh(named.mesh));
  return meshes;
}

template <class T>
bool same_bytes(const std::vector<T> &a, const std::vector<T> &b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

// What lies below a reference: the triangles, once each, inside the bounds that the parents state.
struct Visitor {
  const tyn::Bvh &bvh;
  std::multiset<uint32_t> triangles;
  uint32_t deepest = 0;

  void visit(uint32_t reference, const float *lower, const float *upper, uint32_t level) {
    if (reference & TYN_CHILD_LEAF)
      return visit_leaf(reference, lower, upper);
    deepest = std::max(deepest, level);
    const TynBvhNode &node = bvh.nodes[reference];
    for (int i = 0; i < TYN_BVH_WIDTH; i++) {
      if (node.child[i] == TYN_CHILD_EMPTY) {
        EXPECT_EQ(node.bounds[0][i], INFINITY);
        EXPECT_EQ(node.bounds[3][i], -INFINITY);
        continue;
      }
      float l[3], u[3];
      for (int k = 0; k < 3; k++) {
        l[k] = node.bounds[k][i], u[k] = node.bounds[k + 3][i];
        EXPECT_GE(l[k], lower[k]);
        EXPECT_LE(u[k], upper[k]);
      }
      visit(node.child[i], l, u, level + 1);
    }
  }

  void visit_leaf(uint32_t reference, const float *lower, const float *upper) {
    const uint32_t first = (reference & ~TYN_CHILD_LEAF) >> 4, count = reference & 15;
    EXPECT_GE(count, 1u);
    EXPECT_LE(count, 2u);
    for (uint32_t b = first; b < first + count; b++)
      for (int i = 0; i < TYN_BLOCK_SIZE; i++) {
        const TynTriangleBlock &block = bvh.blocks[b];
        if (block.triangle[i] == TYN_NONE) {
          for (int k = 0; k < 9; k++)
            EXPECT_EQ(block.position[k][i], 0.0f);
          continue;
        }
        triangles.insert(block.triangle[i]);
        for (int k = 0; k < 9; k++) {
          EXPECT_GT(block.position[k][i], lower[k % 3]) << "bounds are widened";
          EXPECT_LT(block.position[k][i], upper[k % 3]);
        }
      }
  }
};

Visitor visit_all(const tyn::Bvh &bvh, uint32_t root) {
  Visitor visitor{bvh, {}, 0};
  const float lower[3] = {-INFINITY, -INFINITY, -INFINITY}, upper[3] = {INFINITY, INFINITY, INFINITY};
  visitor.visit(root, lower, upper, 1);
  return visitor;
}

TEST(Bvh, HoldsEveryTriangleOnceInsideItsBounds) {
  const std::vector<tyn::Mesh> meshes = to_meshes(closed_meshes());
  const tyn::Bvh bvh = tyn::build_bvh(meshes);
  uint32_t total = 0;
  for (size_t i = 0; i < meshes.size(); i++) {
    const Visitor visitor = visit_all(bvh, bvh.roots[i]);
    const uint32_t count = meshes[i].info.triangle_count;
    ASSERT_EQ(visitor.triangles.size(), count);
    EXPECT_EQ(*visitor.triangles.begin(), total);
    EXPECT_EQ(*visitor.triangles.rbegin(), total + count - 1);
    EXPECT_EQ(std::set<uint32_t>(visitor.triangles.begin(), visitor.triangles.end()).size(), count);
    total += count;
  }
  const Visitor whole = visit_all(bvh, 0);
  EXPECT_EQ(whole.triangles.size(), total);
  EXPECT_EQ(whole.deepest, bvh.depth);
}

TEST(Bvh, TheRootOfTheOnlyMeshIsTheScenes) {
  const tyn::Bvh bvh = tyn::build_bvh({to_mesh(icosphere(2))});
  EXPECT_EQ(bvh.roots[0], 0u);
}

TEST(Bvh, IsTheSameEveryTimeWhateverTheThreads) {
  // Large enough for Embree to split the work; concurrent builds disturb its schedule.
  const std::vector<tyn::Mesh> meshes = {to_mesh(bumpy_sphere(6, 0.3f)), to_mesh(torus(1, 0.3f, 300, 100))};
  const tyn::Bvh first = tyn::build_bvh(meshes);
  for (int round = 0; round < 3; round++) {
    tyn::Bvh other[2];
    std::thread thread([&] { other[1] = tyn::build_bvh(meshes); });
    other[0] = tyn::build_bvh(meshes);
    thread.join();
    for (const tyn::Bvh &bvh : other) {
      EXPECT_TRUE(same_bytes(first.nodes, bvh.nodes));
      EXPECT_TRUE(same_bytes(first.blocks, bvh.blocks));
      EXPECT_EQ(first.roots, bvh.roots);
    }
  }
}

TEST(Bvh, ScalesWithThePositionsBitByBit) {
  for (float factor : {2.0f, 0.0009765625f}) {
    std::vector<tyn::Mesh> meshes, scaled_meshes;
    for (const NamedMesh &named : closed_meshes()) {
      meshes.push_back(to_mesh(named.mesh));
      scaled_meshes.push_back(to_mesh(scaled(named.mesh, factor)));
    }
    tyn::Bvh bvh = tyn::build_bvh(meshes);
    const tyn::Bvh scaled_bvh = tyn::build_bvh(scaled_meshes);
    for (TynBvhNode &node : bvh.nodes)
      for (auto &row : node.bounds)
        for (float &bound : row)
          bound *= factor;
    for (TynTriangleBlock &block : bvh.blocks)
      for (auto &row : block.position)
        for (float &position : row)
          position *= factor;
    EXPECT_TRUE(same_bytes(bvh.nodes, scaled_bvh.nodes));
    EXPECT_TRUE(same_bytes(bvh.blocks, scaled_bvh.blocks));
  }
}

TEST(Bvh, LeavesOutTrianglesWithRepeatedPositions) {
  const tyn::Bvh bvh = tyn::build_bvh({to_mesh(with_zero_area_triangles(cube()))});
  EXPECT_EQ(visit_all(bvh, 0).triangles.size(), 12u);
  // but keeps a sliver, which closes a gap
  EXPECT_EQ(visit_all(tyn::build_bvh({to_mesh(cube_with_sliver())}), 0).triangles.size(), 14u);
}

TEST(Bvh, HoldsAMeshThatNothingCanHit) {
  MeshData nothing = single_triangle();
  nothing.indices = {1, 1, 1};
  const tyn::Bvh alone = tyn::build_bvh({to_mesh(nothing)});
  EXPECT_EQ(alone.depth, 0u);
  EXPECT_TRUE(visit_all(alone, 0).triangles.empty());
  const tyn::Bvh bvh = tyn::build_bvh({to_mesh(nothing), to_mesh(cube())});
  EXPECT_TRUE(visit_all(bvh, bvh.roots[0]).triangles.empty());
  EXPECT_EQ(visit_all(bvh, 0).triangles.size(), 12u);
}

TEST(Bvh, StaysShallowEnoughForTheTraversalStack) {
  // Triangles whose size and place halve every time: the surface area heuristic alone would peel them off one by one.
  MeshData spiral;
  for (int i = 0; i < 4000; i++) {
    const double size = std::ldexp(1.0, 30 - i % 120), shift = 1 + i / 120 * 1e-3;
    const uint32_t a = spiral.add_vertex(size * shift, 0, 0), b = spiral.add_vertex(size * shift, size * 0.1, 0),
                   c = spiral.add_vertex(size * shift, 0, size * 0.1);
    spiral.add_triangle(a, b, c);
  }
  const tyn::Bvh deep = tyn::build_bvh({to_mesh(spiral)});
  EXPECT_EQ(visit_all(deep, 0).triangles.size(), 4000u);
  EXPECT_LE(7 * deep.depth + 1, uint32_t(TYN_BVH_STACK));
  // All in one place: there is nothing to split by.
  MeshData pile;
  for (int i = 0; i < 5000; i++) {
    const uint32_t first = pile.vertex_count();
    pile.append(single_triangle());
    EXPECT_EQ(pile.vertex_count(), first + 3);
  }
  const tyn::Bvh flat = tyn::build_bvh({to_mesh(pile), to_mesh(spiral)});
  EXPECT_EQ(visit_all(flat, flat.roots[0]).triangles.size(), 5000u);
  EXPECT_LE(7 * flat.depth + 1, uint32_t(TYN_BVH_STACK));
  EXPECT_TRUE(same_bytes(flat.nodes, tyn::build_bvh({to_mesh(pile), to_mesh(spiral)}).nodes));
}

TEST(Bvh, HoldsThousandsOfMeshes) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> place(-100, 100);
  std::vector<tyn::Mesh> meshes;
  for (int i = 0; i < 3000; i++)
    meshes.push_back(to_mesh(translated(tetrahedron(), place(random), place(random), place(random))));
  const tyn::Bvh bvh = tyn::build_bvh(meshes);
  EXPECT_EQ(visit_all(bvh, 0).triangles.size(), 12000u);
  EXPECT_LE(7 * bvh.depth + 1, uint32_t(TYN_BVH_STACK));
}

TEST(Bvh, SlackIsAPowerOfTwoAboveTheLargestCoordinate) {
  EXPECT_EQ(tyn::mesh_slack(to_mesh(cube())), std::ldexp(1.0f, -20));
  EXPECT_EQ(tyn::mesh_slack(to_mesh(scaled(cube(), 1.5f))), std::ldexp(1.0f, -19));
  EXPECT_EQ(tyn::mesh_slack(to_mesh(translated(cube(), 0, -1022.9f, 0))), std::ldexp(1.0f, -10));
}

} // namespace
