// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Affine maps in double precision, for baking nodes into world space.
#pragma once

#include <array>
#include <cmath>

namespace tyn::io {

using Vector = std::array<double, 3>;

inline Vector operator+(const Vector &a, const Vector &b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Vector operator-(const Vector &a, const Vector &b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Vector operator*(const Vector &a, double s) { return {a[0] * s, a[1] * s, a[2] * s}; }
inline double dot(const Vector &a, const Vector &b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Vector cross(const Vector &a, const Vector &b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double length(const Vector &a) { return std::sqrt(dot(a, a)); }
inline bool finite(const Vector &a) { return std::isfinite(a[0]) && std::isfinite(a[1]) && std::isfinite(a[2]); }

// p -> x p[0] + y p[1] + z p[2] + origin
struct Affine {
  Vector x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, origin{0, 0, 0};

  Vector direction(const Vector &v) const { return x * v[0] + y * v[1] + z * v[2]; }
  Vector point(const Vector &p) const { return direction(p) + origin; }
  bool is_finite() const { return finite(x) && finite(y) && finite(z) && finite(origin); }
  double determinant() const { return dot(x, cross(y, z)); }
  // The inverse transpose times |determinant|: turns normals with the surface, and also works where a scale is 0.
  Vector normal(const Vector &n) const {
    const Vector result = cross(y, z) * n[0] + cross(z, x) * n[1] + cross(x, y) * n[2];
    return determinant() < 0 ? result * -1 : result;
  }
};

// First b, then a.
inline Affine operator*(const Affine &a, const Affine &b) {
  return {a.direction(b.x), a.direction(b.y), a.direction(b.z), a.point(b.origin)};
}

} // namespace tyn::io
