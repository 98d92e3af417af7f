// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Embree's builder behind an interface of our own: boxes in, a tree of indices out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace tyn {

struct Box {
  float lower[3], upper[3];
};

// A node of the tree that Embree built. Leaves hold items, the others children.
struct BuildNode {
  static constexpr uint32_t WIDTH = 8;
  uint32_t child_count; // 0: a leaf
  uint32_t item_count;  // of a leaf
  uint32_t smallest;    // lowest item below this node: a name for it that no two siblings share
  BuildNode *child[WIDTH];
  uint32_t item[WIDTH];
};

struct TreeLimits {
  uint32_t max_leaf_size; // <= BuildNode::WIDTH
  uint32_t block_size;    // items that are tested together
  uint32_t max_depth;     // levels of inner nodes that the tree does not exceed
};

// Owns Embree's device and the memory of the trees built with it.
class EmbreeBuilder {
public:
  EmbreeBuilder();
  ~EmbreeBuilder();
  EmbreeBuilder(const EmbreeBuilder &) = delete;
  EmbreeBuilder &operator=(const EmbreeBuilder &) = delete;

  // The root over `boxes` (item i is boxes[i]), or nullptr if there are none. Children are in ascending order of
  // their lowest item and items ascend, so the tree is the same whatever the number of threads. The root may be a
  // leaf. The tree lives until the next build.
  BuildNode *build(const std::vector<Box> &boxes, const TreeLimits &options);

private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation;
};

} // namespace tyn
