// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Vertices that share a position count as one when a mesh is checked: seams of normals and texture coordinates repeat
// them.
#pragma once

#include <vector>

#include "scene/scene.hpp"

namespace tyn {

struct Welded {
  std::vector<uint32_t> vertex; // for each vertex the number of its position, 0 .. count-1 in order of first appearance
  uint32_t count = 0;
};

// Equal means equal in every coordinate; -0 equals +0.
Welded weld(const std::vector<Vec3> &positions);

} // namespace tyn
