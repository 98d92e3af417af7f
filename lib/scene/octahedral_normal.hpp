// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Directions in 14 bits, for kernels/distance_bound.clh.
#pragma once

#include <cmath>
#include <cstdint>

#include "scene/vector.hpp"

namespace tyn {

struct Float3 {
  float x, y, z;
};

// Octahedral code of a direction (Cigolle et al. 2014, "A Survey of Efficient Representations for Independent Unit Vectors");
// decoded as the kernel does it, within rounding: the vector's components sum to 1, so that its length is between 0.57 and 1.
struct OctahedralNormal {
  int32_t u, v; // -63 .. 63

  explicit OctahedralNormal(const Double3 &n) {
    const double sum = std::abs(n.x) + std::abs(n.y) + std::abs(n.z);
    double a = n.x / sum, b = n.y / sum;
    if (n.z < 0) {
      const double folded = (1 - std::abs(b)) * std::copysign(1.0, a);
      b = (1 - std::abs(a)) * std::copysign(1.0, b);
      a = folded;
    }
    u = int32_t(std::lround(63 * a));
    v = int32_t(std::lround(63 * b));
  }

  Float3 decoded() const {
    const float a = float(u) / 63, b = float(v) / 63, c = 1 - std::abs(a) - std::abs(b);
    if (c >= 0)
      return {a, b, c};
    return {std::copysign(1 - std::abs(b), a), std::copysign(1 - std::abs(a), b), c};
  }
};

} // namespace tyn
