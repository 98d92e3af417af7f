// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Local roots: all that overlaps a cell and half a cell around it is found from the cell's own root.
#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "common/walk_scene.hpp"
#include "scene/bvh.hpp"
#include "scene/local_roots.hpp"

namespace {

using namespace tyn_test;

struct Extent {
  float lower[3] = {INFINITY, INFINITY, INFINITY}, upper[3] = {-INFINITY, -INFINITY, -INFINITY};

  bool overlaps(const Extent &other) const {
    for (int k = 0; k < 3; ++k)
      if (lower[k] > other.upper[k] || upper[k] < other.lower[k])
        return false;
    return true;
  }
  bool holds(const Extent &other) const {
    for (int k = 0; k < 3; ++k)
      if (lower[k] > other.lower[k] || upper[k] < other.upper[k])
        return false;
    return true;
  }
};

class LocalRoots {
public:
  LocalRoots(const MeshData &mesh, uint64_t most_bytes)
      : scene(make_scene(shared_context(), mesh, grey_medium(0, 1))), bvh(tyn::build_bvh(scene->meshes)) {
    records = scene->mesh_records;
    records[0].root = bvh.roots[0];
    cells = {7}; // of something else
    const size_t nodes = bvh.nodes.size();
    tyn::add_local_roots(bvh, records, cells, most_bytes);
    bytes = (cells.size() - 1) * sizeof(uint32_t) + (bvh.nodes.size() - nodes) * sizeof(TynBvhNode);
    for (size_t i = 0; i < scene->meshes[0].indices.size(); ++i)
      for (int k = 0; k < 3; ++k) {
        if (i % 3 == 0 && k == 0)
          boxes.emplace_back();
        const float x = (&scene->meshes[0].positions[scene->meshes[0].indices[i]].x)[k];
        boxes.back().lower[k] = std::min(boxes.back().lower[k], x);
        boxes.back().upper[k] = std::max(boxes.back().upper[k], x);
      }
  }

  const TynMeshRecord &record() const { return records[0]; }

  // How many triangles that overlap a random cell and `around` cells around it are not found, of how many.
  void check(float around, std::mt19937 &random, size_t &missing, size_t &near) {
    uint64_t index = record().local_first, stride = 1;
    Extent box;
    for (int k = 0; k < 3; ++k) {
      const uint32_t at = uint32_t(random() % record().local_size[k]);
      index += stride * at;
      stride *= record().local_size[k];
      box.lower[k] = record().lower[k] + (float(at) - around) * record().local_cell;
      box.upper[k] = record().lower[k] + (float(at) + 1 + around) * record().local_cell;
    }
    found.assign(boxes.size(), false);
    if (cells[index] != TYN_NONE)
      find(cells[index]);
    for (size_t i = 0; i < boxes.size(); ++i)
      if (boxes[i].overlaps(box)) {
        ++near;
        missing += !found[i];
      }
  }

  uint64_t bytes;

private:
  // What rays can find under a node: triangles within the bounds of all nodes above them.
  void find(uint32_t index) {
    ASSERT_LT(index, bvh.nodes.size());
    const TynBvhNode node = bvh.nodes[index];
    for (uint32_t i = 0; i < TYN_BVH_WIDTH; ++i) {
      if (node.child[i] == TYN_CHILD_EMPTY)
        continue;
      Extent bounds;
      for (int k = 0; k < 3; ++k)
        bounds.lower[k] = node.bounds[k][i], bounds.upper[k] = node.bounds[k + 3][i];
      within.push_back(bounds);
      if (node.child[i] & TYN_CHILD_LEAF)
        find_in_leaf(node.child[i]);
      else
        find(node.child[i]);
      within.pop_back();
    }
  }

  void find_in_leaf(uint32_t leaf) {
    const uint32_t first = (leaf & ~TYN_CHILD_LEAF) >> 4;
    for (uint32_t block = first; block < first + (leaf & 15u); ++block)
      for (const uint32_t triangle : bvh.blocks[block].triangle)
        if (triangle != TYN_NONE)
          found[triangle] = std::all_of(within.begin(), within.end(),
                                        [&](const Extent &bounds) { return bounds.holds(boxes[triangle]); });
  }

  SceneHandle scene;
  tyn::Bvh bvh;
  std::vector<TynMeshRecord> records;
  std::vector<uint32_t> cells;
  std::vector<Extent> boxes, within;
  std::vector<bool> found;
};

std::vector<NamedMesh> solid_meshes() {
  std::vector<NamedMesh> meshes = closed_meshes();
  meshes.push_back({"bumpy sphere", bumpy_sphere(5, 0.3f)});
  return meshes;
}

TEST(LocalRoots, LeadToAllThatIsNear) {
  std::mt19937 random(9);
  size_t near = 0, missing_far = 0, far = 0;
  for (const NamedMesh &named : solid_meshes()) {
    SCOPED_TRACE(named.name);
    LocalRoots roots(named.mesh, UINT64_MAX);
    size_t missing = 0;
    for (int i = 0; i < 300; ++i) {
      roots.check(0.5f, random, missing, near);
      roots.check(2.5f, random, missing_far, far);
    }
    EXPECT_EQ(missing, 0u);
  }
  EXPECT_GT(near, 10000u);
  EXPECT_GT(missing_far, 10000u); // not just the mesh's own root
}

TEST(LocalRoots, GiveWayToATightLimit) {
  std::mt19937 random(9);
  const MeshData mesh = bumpy_sphere(5, 0.3f);
  size_t near = 0, missing = 0;
  for (uint64_t most : {UINT64_MAX, uint64_t(100000), uint64_t(10000), uint64_t(1000), uint64_t(0)}) {
    LocalRoots roots(mesh, most);
    EXPECT_LE(roots.bytes, std::max<uint64_t>(most, 4));
    EXPECT_EQ(roots.record().local_size[0] == 1, most <= 10 * 4);
    for (int i = 0; i < 100; ++i)
      roots.check(0.5f, random, missing, near);
  }
  EXPECT_EQ(missing, 0u);
  EXPECT_GT(near, 1000u);
}

} // namespace
