// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/bvh.hpp"

#include <algorithm>
#include <cmath>

#include "scene/embree_builder.hpp"

namespace tyn {
namespace {

static_assert(BuildNode::WIDTH == TYN_BVH_WIDTH, "one child a lane");

// Levels of inner nodes: each leaves up to 7 entries on the traversal stack, and the last one 8. The scene's levels
// suffice for 8^9 meshes; a mesh's are split by surface area down to level 18, then evenly.
constexpr uint32_t SCENE_LEVELS = 9;
constexpr uint32_t MESH_LEVELS = 27;
static_assert(7 * (SCENE_LEVELS + MESH_LEVELS) + 1 <= TYN_BVH_STACK, "the traversal stack holds the deepest tree");

constexpr uint32_t MAX_BLOCKS = (1u << 27) - 1; // the last number would look like TYN_CHILD_EMPTY
constexpr uint32_t MAX_NODES = TYN_CHILD_LEAF;

Box empty_box() { return {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}}; }

void extend(Box &box, const float *lower, const float *upper) {
  for (int k = 0; k < 3; k++) {
    box.lower[k] = std::min(box.lower[k], lower[k]);
    box.upper[k] = std::max(box.upper[k], upper[k]);
  }
}

Box triangle_box(const Mesh &mesh, size_t triangle) {
  Box box = empty_box();
  for (size_t k = 0; k < 3; k++) {
    const float *p = &mesh.positions[mesh.indices[3 * triangle + k]].x;
    extend(box, p, p);
  }
  return box;
}

// Two vertices in the same place: an area of exactly 0 from wherever it is looked at, so that nothing would ever hit
// it. Other triangles without area stay: they close the gap that rounding opens between an edge and a vertex lying on
// it.
bool is_invisible(const Mesh &mesh, size_t triangle) {
  const uint32_t *index = &mesh.indices[3 * triangle];
  const Vec3 &a = mesh.positions[index[0]], &b = mesh.positions[index[1]], &c = mesh.positions[index[2]];
  auto same = [](const Vec3 &p, const Vec3 &q) { return p.x == q.x && p.y == q.y && p.z == q.z; };
  return same(a, b) || same(b, c) || same(c, a);
}

// Turns Embree's tree of one mesh into nodes and blocks, depth first.
class Flattener {
public:
  Flattener(Bvh &bvh_, const Mesh &mesh_, const std::vector<uint32_t> &triangles_, uint32_t first_)
      : bvh(bvh_), mesh(mesh_), triangles(triangles_), first_triangle(first_), slack(mesh_slack(mesh_)) {}

  uint32_t deepest = 0; // level of the deepest inner node

  // Appends an inner node for `node` and returns its index; `box` receives its bounds. A leaf gets a node of its own.
  uint32_t add_inner(const BuildNode &node, uint32_t level, Box &box) {
    const uint32_t index = append_empty_node(bvh);
    deepest = std::max(deepest, level);
    box = empty_box();
    const uint32_t count = node.child_count ? node.child_count : 1;
    for (uint32_t i = 0; i < count; i++) {
      const BuildNode &child = node.child_count ? *node.child[i] : node;
      Box child_box;
      const uint32_t reference =
          child.child_count ? add_inner(child, level + 1, child_box) : add_leaf(child, child_box);
      set_child(bvh.nodes[index], i, reference, child_box);
      extend(box, child_box.lower, child_box.upper);
    }
    return index;
  }

  static uint32_t append_empty_node(Bvh &bvh) {
    if (bvh.nodes.size() >= MAX_NODES)
      fail(TYN_ERROR_OUT_OF_MEMORY, "the scene's acceleration structure would have more than %u nodes", MAX_NODES);
    TynBvhNode node;
    for (uint32_t i = 0; i < TYN_BVH_WIDTH; i++) {
      for (int k = 0; k < 3; k++)
        node.bounds[k][i] = INFINITY, node.bounds[k + 3][i] = -INFINITY;
      node.child[i] = TYN_CHILD_EMPTY;
    }
    bvh.nodes.push_back(node);
    return uint32_t(bvh.nodes.size() - 1);
  }

  static void set_child(TynBvhNode &node, uint32_t i, uint32_t reference, const Box &box) {
    for (int k = 0; k < 3; k++)
      node.bounds[k][i] = box.lower[k], node.bounds[k + 3][i] = box.upper[k];
    node.child[i] = reference;
  }

private:
  uint32_t add_leaf(const BuildNode &leaf, Box &box) {
    const size_t first = bvh.blocks.size();
    const uint32_t count = (leaf.item_count + TYN_BLOCK_SIZE - 1) / TYN_BLOCK_SIZE;
    if (first + count > MAX_BLOCKS)
      fail(TYN_ERROR_OUT_OF_MEMORY, "the scene's acceleration structure would have more than %u leaves", MAX_BLOCKS);
    box = empty_box();
    for (uint32_t i = 0; i < leaf.item_count; i++) {
      if (i % TYN_BLOCK_SIZE == 0)
        append_empty_block();
      const uint32_t triangle = triangles[leaf.item[i]];
      put_triangle(bvh.blocks.back(), i % TYN_BLOCK_SIZE, triangle);
      const Box own = triangle_box(mesh, triangle);
      extend(box, own.lower, own.upper);
    }
    for (int k = 0; k < 3; k++)
      box.lower[k] -= slack, box.upper[k] += slack;
    return TYN_CHILD_LEAF | uint32_t(first) << 4 | count;
  }

  void append_empty_block() {
    TynTriangleBlock block{};
    std::fill_n(block.triangle, TYN_BLOCK_SIZE, TYN_NONE);
    bvh.blocks.push_back(block);
  }

  void put_triangle(TynTriangleBlock &block, uint32_t place, uint32_t triangle) {
    for (int corner = 0; corner < 3; corner++) {
      const float *p = &mesh.positions[mesh.indices[3 * size_t(triangle) + size_t(corner)]].x;
      for (int k = 0; k < 3; k++)
        block.position[3 * corner + k][place] = p[k];
    }
    block.triangle[place] = first_triangle + triangle;
  }

  Bvh &bvh;
  const Mesh &mesh;
  const std::vector<uint32_t> &triangles; // item of Embree's tree -> triangle of the mesh
  const uint32_t first_triangle;
  const float slack;
};

// What the scene's tree needs to know of a mesh's.
struct MeshTree {
  Box box = empty_box();
  uint32_t levels = 0;
};

MeshTree add_mesh_tree(Bvh &bvh, EmbreeBuilder &builder, const Mesh &mesh, uint32_t first_triangle) {
  std::vector<uint32_t> triangles;
  std::vector<Box> boxes;
  for (uint32_t i = 0; i < mesh.indices.size() / 3; i++)
    if (!is_invisible(mesh, i)) {
      triangles.push_back(i);
      boxes.push_back(triangle_box(mesh, i));
    }
  MeshTree tree;
  const BuildNode *root = builder.build(boxes, {2 * TYN_BLOCK_SIZE, TYN_BLOCK_SIZE, MESH_LEVELS});
  if (!root) { // nothing to hit
    bvh.roots.push_back(Flattener::append_empty_node(bvh));
    return tree;
  }
  Flattener flattener(bvh, mesh, triangles, first_triangle);
  bvh.roots.push_back(flattener.add_inner(*root, 1, tree.box));
  tree.levels = flattener.deepest;
  return tree;
}

// The levels above the meshes. Node `index` is there already. Returns the deepest level, the meshes' own included.
uint32_t fill_scene_node(Bvh &bvh, uint32_t index, const BuildNode &node, uint32_t level,
                         const std::vector<MeshTree> &trees, const std::vector<uint32_t> &meshes, Box &box) {
  uint32_t deepest = level;
  box = empty_box();
  const uint32_t count = node.child_count ? node.child_count : 1;
  for (uint32_t i = 0; i < count; i++) {
    const BuildNode &child = node.child_count ? *node.child[i] : node;
    Box child_box;
    uint32_t reference;
    if (child.child_count) {
      reference = Flattener::append_empty_node(bvh);
      deepest = std::max(deepest, fill_scene_node(bvh, reference, child, level + 1, trees, meshes, child_box));
    } else {
      const uint32_t mesh = meshes[child.item[0]]; // leaves hold one mesh each
      reference = bvh.roots[mesh];
      child_box = trees[mesh].box;
      deepest = std::max(deepest, level + trees[mesh].levels);
    }
    Flattener::set_child(bvh.nodes[index], i, reference, child_box);
    extend(box, child_box.lower, child_box.upper);
  }
  return deepest;
}

void build_scene_tree(Bvh &bvh, EmbreeBuilder &builder, const std::vector<MeshTree> &trees) {
  std::vector<uint32_t> meshes; // those that can be hit
  std::vector<Box> boxes;
  for (uint32_t i = 0; i < trees.size(); i++)
    if (trees[i].levels > 0) {
      meshes.push_back(i);
      boxes.push_back(trees[i].box);
    }
  const BuildNode *root = builder.build(boxes, {1, 1, SCENE_LEVELS});
  if (!root)
    return;
  Box box;
  bvh.depth = fill_scene_node(bvh, 0, *root, 1, trees, meshes, box);
}

} // namespace

float mesh_slack(const Mesh &mesh) {
  float largest = 0;
  for (int k = 0; k < 3; k++)
    largest = std::max({largest, std::abs(mesh.info.lower[k]), std::abs(mesh.info.upper[k])});
  int exponent;
  const float fraction = std::frexp(largest, &exponent); // in [0.5, 1), 0 for 0
  if (fraction == 0.5f)
    exponent--;
  return largest > 0 ? std::ldexp(1.0f, exponent - 20) : 0;
}

double longest_side(const TynMeshRecord &record) {
  double longest = 0;
  for (int k = 0; k < 3; k++)
    longest = std::max(longest, double(record.upper[k]) - double(record.lower[k]));
  return longest;
}

Bvh build_bvh(const std::vector<Mesh> &meshes) {
  EmbreeBuilder builder;
  Bvh bvh;
  // Alone, a mesh's root is the scene's.
  const bool alone = meshes.size() == 1;
  if (!alone)
    Flattener::append_empty_node(bvh);
  std::vector<MeshTree> trees;
  uint32_t first_triangle = 0;
  for (const Mesh &mesh : meshes) {
    trees.push_back(add_mesh_tree(bvh, builder, mesh, first_triangle));
    first_triangle += uint32_t(mesh.indices.size() / 3);
  }
  if (alone)
    bvh.depth = trees[0].levels;
  else
    build_scene_tree(bvh, builder, trees);
  if (7 * bvh.depth + 1 > TYN_BVH_STACK)
    fail(TYN_ERROR_INTERNAL, "the scene's acceleration structure has %u levels; traversal is limited to %u", bvh.depth,
         (TYN_BVH_STACK - 1) / 7);
  return bvh;
}

} // namespace tyn
