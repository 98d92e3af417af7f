// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/embree_builder.hpp"

#ifndef TYN_EMBREE_MAJOR
#define TYN_EMBREE_MAJOR 3
#endif
#if TYN_EMBREE_MAJOR >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <algorithm>

#include "core/status.hpp"

namespace tyn {
namespace {

[[noreturn]] void fail_embree(RTCDevice device, const char *call) {
  const RTCError error = rtcGetDeviceError(device);
  fail(error == RTC_ERROR_OUT_OF_MEMORY ? TYN_ERROR_OUT_OF_MEMORY : TYN_ERROR_INTERNAL,
       "%s failed with Embree error %d", call, int(error));
}

// Embree calls these from several threads at once. Each writes only to the node it is given.

void *create_node(RTCThreadLocalAllocator allocator, unsigned count, void *) {
  auto *node = static_cast<BuildNode *>(rtcThreadLocalAlloc(allocator, sizeof(BuildNode), 16));
  node->child_count = count;
  node->item_count = 0;
  return node;
}

void set_children(void *node, void **children, unsigned count, void *) {
  for (unsigned i = 0; i < count; i++)
    static_cast<BuildNode *>(node)->child[i] = static_cast<BuildNode *>(children[i]);
}

void set_bounds(void *, const RTCBounds **, unsigned, void *) {} // they are computed when the tree is flattened

void *create_leaf(RTCThreadLocalAllocator allocator, const RTCBuildPrimitive *primitives, size_t count, void *) {
  auto *node = static_cast<BuildNode *>(rtcThreadLocalAlloc(allocator, sizeof(BuildNode), 16));
  node->child_count = 0;
  node->item_count = uint32_t(count);
  for (size_t i = 0; i < count; i++)
    node->item[i] = primitives[i].primID;
  return node;
}

// Which thread came first decides about the order that Embree leaves things in. This one is always the same. The
// depth of the recursion is limited by TreeLimits::max_depth.
void put_in_order(BuildNode *node) {
  std::sort(node->item, node->item + node->item_count);
  for (uint32_t i = 0; i < node->child_count; i++)
    put_in_order(node->child[i]);
  std::sort(node->child, node->child + node->child_count,
            [](const BuildNode *a, const BuildNode *b) { return a->smallest < b->smallest; });
  node->smallest = node->child_count ? node->child[0]->smallest : node->item[0];
}

std::vector<RTCBuildPrimitive> to_primitives(const std::vector<Box> &boxes) {
  std::vector<RTCBuildPrimitive> primitives(boxes.size());
  for (size_t i = 0; i < boxes.size(); i++) {
    const Box &b = boxes[i];
    primitives[i] = {b.lower[0], b.lower[1], b.lower[2], 0, b.upper[0], b.upper[1], b.upper[2], unsigned(i)};
  }
  return primitives;
}

} // namespace

struct EmbreeBuilder::Implementation {
  RTCDevice device = nullptr;
  RTCBVH tree = nullptr;

  void release_tree() {
    if (tree)
      rtcReleaseBVH(tree);
    tree = nullptr;
  }
  ~Implementation() {
    release_tree();
    if (device)
      rtcReleaseDevice(device);
  }
};

EmbreeBuilder::EmbreeBuilder() : implementation(new Implementation) {
  // A file of the user's can set Embree up; a library stays silent all the same.
  implementation->device = rtcNewDevice("verbose=0");
  if (!implementation->device)
    fail_embree(nullptr, "rtcNewDevice");
}

EmbreeBuilder::~EmbreeBuilder() = default;

BuildNode *EmbreeBuilder::build(const std::vector<Box> &boxes, const TreeLimits &limits) {
  if (boxes.empty())
    return nullptr;
  implementation->release_tree();
  implementation->tree = rtcNewBVH(implementation->device);
  if (!implementation->tree)
    fail_embree(implementation->device, "rtcNewBVH");

  std::vector<RTCBuildPrimitive> primitives = to_primitives(boxes);
  RTCBuildArguments arguments = rtcDefaultBuildArguments();
  arguments.buildQuality =
      RTC_BUILD_QUALITY_MEDIUM; // binned surface area heuristic; HIGH would only add spatial splits
  arguments.maxBranchingFactor = BuildNode::WIDTH;
  arguments.maxDepth = limits.max_depth + 1; // Embree counts the level of the leaves
  arguments.sahBlockSize = limits.block_size;
  arguments.minLeafSize = 1;
  arguments.maxLeafSize = limits.max_leaf_size;
  arguments.bvh = implementation->tree;
  arguments.primitives = primitives.data();
  arguments.primitiveCount = arguments.primitiveArrayCapacity = primitives.size();
  arguments.createNode = create_node;
  arguments.setNodeChildren = set_children;
  arguments.setNodeBounds = set_bounds;
  arguments.createLeaf = create_leaf;
  auto *root = static_cast<BuildNode *>(rtcBuildBVH(&arguments));
  if (!root)
    fail_embree(implementation->device, "rtcBuildBVH");
  put_in_order(root);
  return root;
}

} // namespace tyn
