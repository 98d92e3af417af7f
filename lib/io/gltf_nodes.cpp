// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "io/gltf_nodes.hpp"

namespace tyn::io {
namespace {

constexpr int NO_PARENT = -1;

Affine from_matrix(const std::vector<double> &m, int index) { // column-major 4 x 4
  if (m[3] != 0 || m[7] != 0 || m[11] != 0 || m[15] != 1)
    fail(TYN_ERROR_FORMAT, "nodes[%d].matrix is not affine: its last row is %g %g %g %g", index, m[3], m[7], m[11],
         m[15]);
  return {{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}, {m[12], m[13], m[14]}};
}

Affine from_quaternion(const std::vector<double> &q, int index) { // x y z w
  const double norm = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  if (!(norm > 1e-6) || !std::isfinite(norm))
    fail(TYN_ERROR_FORMAT, "nodes[%d].rotation is %g %g %g %g; it must be a unit quaternion", index, q[0], q[1], q[2],
         q[3]);
  const double x = q[0] / norm, y = q[1] / norm, z = q[2] / norm, w = q[3] / norm;
  Affine result;
  result.x = {1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)};
  result.y = {2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)};
  result.z = {2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)};
  return result;
}

Affine local_transform(const tinygltf::Node &node, int index) {
  if (!node.matrix.empty())
    return from_matrix(node.matrix, index);
  Affine result;
  if (!node.rotation.empty())
    result = from_quaternion(node.rotation, index);
  if (!node.scale.empty()) {
    result.x = result.x * node.scale[0];
    result.y = result.y * node.scale[1];
    result.z = result.z * node.scale[2];
  }
  if (!node.translation.empty())
    result.origin = {node.translation[0], node.translation[1], node.translation[2]};
  return result;
}

std::vector<int> find_parents(const tinygltf::Model &model) {
  std::vector<int> parents(model.nodes.size(), NO_PARENT);
  for (size_t i = 0; i < model.nodes.size(); i++)
    for (const int child : model.nodes[i].children) {
      int &parent = parents[size_t(child)];
      if (parent != NO_PARENT)
        fail(TYN_ERROR_FORMAT, "nodes[%d] is a child of nodes[%d] and again of nodes[%zu]; a node has one parent",
             child, parent, i);
      parent = int(i);
    }
  return parents;
}

// With one parent each, a node that no root leads to is in a cycle or below one.
void check_cycles(const tinygltf::Model &model, const std::vector<int> &parents) {
  std::vector<bool> reached(parents.size(), false);
  std::vector<int> waiting;
  for (size_t i = 0; i < parents.size(); i++)
    if (parents[i] == NO_PARENT)
      waiting.push_back(int(i));
  while (!waiting.empty()) {
    const size_t node = size_t(waiting.back());
    waiting.pop_back();
    reached[node] = true;
    waiting.insert(waiting.end(), model.nodes[node].children.begin(), model.nodes[node].children.end());
  }
  for (size_t i = 0; i < reached.size(); i++)
    if (!reached[i])
      fail(TYN_ERROR_FORMAT, "nodes[%zu] is in a cycle: following its parents leads back to it or to another cycle", i);
}

std::vector<int> scene_roots(const tinygltf::Model &model, const std::vector<int> &parents) {
  std::vector<int> roots;
  if (model.scenes.empty()) {
    for (size_t i = 0; i < parents.size(); i++)
      if (parents[i] == NO_PARENT)
        roots.push_back(int(i));
    return roots;
  }
  const size_t scene = model.defaultScene >= 0 ? size_t(model.defaultScene) : 0;
  std::vector<bool> listed(parents.size(), false);
  for (const int node : model.scenes[scene].nodes) {
    if (parents[size_t(node)] != NO_PARENT)
      fail(TYN_ERROR_FORMAT, "scenes[%zu] lists nodes[%d], which is no root: it is a child of nodes[%d]", scene, node,
           parents[size_t(node)]);
    if (listed[size_t(node)])
      fail(TYN_ERROR_FORMAT, "scenes[%zu] lists nodes[%d] twice", scene, node);
    listed[size_t(node)] = true;
    roots.push_back(node);
  }
  return roots;
}

} // namespace

std::vector<PlacedNode> place_nodes(const tinygltf::Model &model) {
  const std::vector<int> parents = find_parents(model);
  check_cycles(model, parents);
  const std::vector<int> roots = scene_roots(model, parents);
  // A stack of its own instead of recursion: a file may nest nodes as deeply as it likes.
  std::vector<PlacedNode> waiting, placed;
  for (auto root = roots.rbegin(); root != roots.rend(); ++root)
    waiting.push_back({*root, Affine()});
  while (!waiting.empty()) {
    PlacedNode node = waiting.back();
    waiting.pop_back();
    const tinygltf::Node &source = model.nodes[size_t(node.index)];
    node.world = node.world * local_transform(source, node.index);
    if (!node.world.is_finite())
      fail(TYN_ERROR_FORMAT, "nodes[%d]: its transform in world space is not finite", node.index);
    placed.push_back(node);
    for (auto child = source.children.rbegin(); child != source.children.rend(); ++child)
      waiting.push_back({*child, node.world});
  }
  return placed;
}

} // namespace tyn::io
