// SPDX-License-Identifier: Apache-2.0
// The distance from a point to a triangle, in units of a grid's cells: with one rounding error or two of a float, and never
// more than that too large, slivers included.
#pragma once

#include <algorithm>
#include <cmath>

#include "scene/vector.hpp"

namespace tyn {

struct CellTriangle {
  float corner[3][3];
  float edge[3][3]; // from corner i to the next
  float inverse[3]; // 1 / squared length of the edge; 0 for none
  float side[3][3]; // unit, in the plane, across the edge and inwards
  float normal[3];  // unit; 0, like `side`, without area
  bool has_area;

  // Corners in cells, from the grid's lowest corner.
  explicit CellTriangle(const Double3 (&p)[3]) {
    const Double3 n = cross(p[1] - p[0], p[2] - p[0]);
    const double area = length(n);
    has_area = area > 0;
    put(normal, n, has_area ? 1 / area : 0);
    for (int i = 0; i < 3; i++) {
      const Double3 e = p[(i + 1) % 3] - p[i], across = cross(n, e);
      const double squared = dot(e, e);
      put(corner[i], p[i], 1);
      put(edge[i], e, 1);
      inverse[i] = squared > 1e-30 ? float(1 / squared) : 0;
      put(side[i], across, has_area ? 1 / length(across) : 0);
    }
  }

  float squared_distance(float x, float y, float z) const {
    float nearest = INFINITY, height = 0;
    bool above = has_area; // the point is above or below the triangle
    for (int i = 0; i < 3; i++) {
      const float rx = x - corner[i][0], ry = y - corner[i][1], rz = z - corner[i][2];
      const float *e = edge[i], *s = side[i];
      const float along = std::min(1.0f, std::max(0.0f, (rx * e[0] + ry * e[1] + rz * e[2]) * inverse[i]));
      const float dx = rx - along * e[0], dy = ry - along * e[1], dz = rz - along * e[2];
      nearest = std::min(nearest, dx * dx + dy * dy + dz * dz);
      // a little beyond the edge the plane is still taken: it is nearer
      above &= rx * s[0] + ry * s[1] + rz * s[2] >= -1e-3f;
      height = rx * normal[0] + ry * normal[1] + rz * normal[2];
    }
    return above ? std::min(nearest, height * height) : nearest;
  }

private:
  static void put(float (&to)[3], const Double3 &v, double scale) {
    to[0] = float(v.x * scale), to[1] = float(v.y * scale), to[2] = float(v.z * scale);
  }
};

} // namespace tyn
