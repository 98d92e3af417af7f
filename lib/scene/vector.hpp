// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Vectors in double, for what is measured on the host.
#pragma once

#include <cmath>

#include "scene/scene.hpp"

namespace tyn {

struct Double3 {
  double x, y, z;
};

inline Double3 to_double(const Vec3 &v) { return {v.x, v.y, v.z}; }
inline Double3 operator-(const Double3 &a, const Double3 &b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Double3 operator+(const Double3 &a, const Double3 &b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline double dot(const Double3 &a, const Double3 &b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline double length(const Double3 &v) { return std::sqrt(dot(v, v)); }

inline Double3 cross(const Double3 &a, const Double3 &b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// Along the normal of a triangle, twice as long as its area.
inline Double3 area_vector(const Mesh &mesh, size_t triangle) {
  const uint32_t *index = &mesh.indices[3 * triangle];
  const Double3 p0 = to_double(mesh.positions[index[0]]);
  return cross(to_double(mesh.positions[index[1]]) - p0, to_double(mesh.positions[index[2]]) - p0);
}

} // namespace tyn
