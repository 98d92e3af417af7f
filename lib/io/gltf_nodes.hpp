// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The node hierarchy.
#pragma once

#include <vector>

#include <tiny_gltf.h>

#include "io/affine.hpp"
#include "io/failure.hpp"

namespace tyn::io {

struct PlacedNode {
  int index;    // in the file
  Affine world; // from the node's space
};

// The nodes of the default scene (the first if none is chosen; all root nodes if there is no scene), parents first. Throws
// FORMAT for a hierarchy that is not a forest: a cycle, a node with two parents, a scene that lists a node that is no root.
std::vector<PlacedNode> place_nodes(const tinygltf::Model &model);

} // namespace tyn::io
