// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The edges of a mesh, by welded vertices.
#pragma once

#include <cstdint>
#include <vector>

namespace tyn {

// One side of one triangle. Sorted, all sides of one edge are neighbours, in the order of their triangles.
struct EdgeSide {
  uint64_t edge; // the two welded vertices, the lower one in the high half
  uint32_t triangle;
  uint32_t forward; // 1: the triangle runs along it from the lower vertex to the higher
};

// Three welded vertices a triangle.
std::vector<EdgeSide> sorted_edge_sides(const std::vector<uint32_t> &corners);

// Calls visit(first, last) for the sides of each edge.
template <class Visit>
void for_each_edge(const std::vector<EdgeSide> &sides, Visit visit) {
  const EdgeSide *first = sides.data(), *end = first + sides.size();
  while (first != end) {
    const EdgeSide *last = first;
    while (last != end && last->edge == first->edge)
      ++last;
    visit(first, last);
    first = last;
  }
}

// Whether a triangle has three distinct vertices. Others have no edges.
inline bool distinct(const uint32_t *corner) {
  return corner[0] != corner[1] && corner[1] != corner[2] && corner[2] != corner[0];
}

} // namespace tyn
