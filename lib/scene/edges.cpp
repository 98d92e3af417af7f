// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/edges.hpp"

#include <algorithm>

namespace tyn {

std::vector<EdgeSide> sorted_edge_sides(const std::vector<uint32_t> &corners) {
  std::vector<EdgeSide> sides;
  sides.reserve(corners.size());
  for (size_t i = 0; i < corners.size(); i += 3) {
    if (!distinct(&corners[i]))
      continue;
    for (size_t k = 0; k < 3; k++) {
      const uint64_t a = corners[i + k], b = corners[i + (k + 1) % 3];
      sides.push_back({std::min(a, b) << 32 | std::max(a, b), uint32_t(i / 3), a < b});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const EdgeSide &a, const EdgeSide &b) {
    return a.edge != b.edge ? a.edge < b.edge : a.triangle < b.triangle;
  });
  return sides;
}

} // namespace tyn
