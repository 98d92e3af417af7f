// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
//
// Triangle meshes: simple ones written down, and a check that one is closed.
#pragma once

#include "demo/vec.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace demo {

struct Mesh {
  std::vector<Vec> positions;
  std::vector<Vec> normals;
  std::vector<uint32_t> indices; // 3 a triangle, counter-clockwise seen from outside

  void triangle(uint32_t a, uint32_t b, uint32_t c) { indices.insert(indices.end(), {a, b, c}); }
  size_t triangle_count() const { return indices.size() / 3; }
};

// Every edge is passed once in each direction. Vertices must be shared between the triangles that meet in them.
inline bool is_closed(const Mesh &mesh) {
  std::vector<std::pair<uint32_t, uint32_t>> forward, backward;
  for (size_t i = 0; i < mesh.indices.size(); i += 3) {
    for (int j = 0; j < 3; ++j) {
      const uint32_t a = mesh.indices[i + j], b = mesh.indices[i + (j + 1) % 3];
      forward.emplace_back(a, b);
      backward.emplace_back(b, a);
    }
  }
  std::sort(forward.begin(), forward.end());
  std::sort(backward.begin(), backward.end());
  const bool unique = std::adjacent_find(forward.begin(), forward.end()) == forward.end();
  return unique && forward == backward;
}

inline void append(Mesh &mesh, const Mesh &other) {
  const uint32_t first = static_cast<uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
  mesh.normals.insert(mesh.normals.end(), other.normals.begin(), other.normals.end());
  for (uint32_t index : other.indices)
    mesh.indices.push_back(first + index);
}

// Corners counter-clockwise seen from the side that is lit or gives light.
inline Mesh quad(Vec a, Vec b, Vec c, Vec d) {
  const Vec normal = normalize(cross(b - a, d - a));
  return {{a, b, c, d}, {normal, normal, normal, normal}, {0, 1, 2, 0, 2, 3}};
}

// A profile (radius, height) turned about the Y axis. It begins and ends on the axis, so the surface is closed; it goes
// up on the outside.
inline Mesh lathe(const std::vector<std::pair<float, float>> &profile, int segments) {
  Mesh mesh;
  const int rings = static_cast<int>(profile.size());
  const auto vertex = [&](int ring, int segment) -> uint32_t {
    if (ring == 0)
      return 0;
    if (ring == rings - 1)
      return 1;
    return 2 + (ring - 1) * segments + segment % segments;
  };
  const auto profile_normal = [&](int ring) { // of the smooth curve through the points
    const auto &a = profile[std::max(ring - 1, 0)], &b = profile[std::min(ring + 1, rings - 1)];
    return std::make_pair(b.second - a.second, a.first - b.first);
  };
  const auto add = [&](int ring, float angle) {
    const auto [r, y] = profile[ring];
    const auto [nr, ny] = profile_normal(ring);
    const float c = std::cos(angle), s = std::sin(angle);
    mesh.positions.push_back({r * c, y, -r * s});
    const bool pole = ring == 0 || ring == rings - 1;
    mesh.normals.push_back(pole ? Vec{0, ring ? 1.0f : -1.0f, 0} : normalize({nr * c, ny, -nr * s}));
  };
  add(0, 0);
  add(rings - 1, 0);
  for (int ring = 1; ring + 1 < rings; ++ring)
    for (int segment = 0; segment < segments; ++segment)
      add(ring, 2 * kPi * segment / segments);
  for (int ring = 0; ring + 1 < rings; ++ring) {
    for (int segment = 0; segment < segments; ++segment) {
      const uint32_t a = vertex(ring, segment), b = vertex(ring, segment + 1);
      const uint32_t c = vertex(ring + 1, segment + 1), d = vertex(ring + 1, segment);
      if (a != b)
        mesh.triangle(a, b, c);
      if (c != d)
        mesh.triangle(a, c, d);
    }
  }
  return mesh;
}

inline Mesh placed(Mesh mesh, const Frame &frame) {
  for (Vec &position : mesh.positions)
    position = frame.to_world(position);
  for (Vec &normal : mesh.normals)
    normal = frame.direction_to_world(normal);
  return mesh;
}

} // namespace demo
