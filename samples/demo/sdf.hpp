// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
//
// Signed distance functions: negative inside. Some are bounds rather than distances; none grows faster than distance by
// more than the mesher allows for.
#pragma once

#include "demo/vec.hpp"

#include <algorithm>

namespace demo {

inline float sphere(Vec p, Vec centre, float radius) { return length(p - centre) - radius; }

// First-order distance to an ellipsoid: exact on its surface.
inline float ellipsoid(Vec p, Vec centre, Vec radii) {
  const Vec d = p - centre;
  const Vec scaled = {d.x / radii.x, d.y / radii.y, d.z / radii.z};
  const Vec gradient = {scaled.x / radii.x, scaled.y / radii.y, scaled.z / radii.z};
  const float k0 = length(scaled), k1 = length(gradient);
  if (k1 < 1e-6f)
    return -std::min({radii.x, radii.y, radii.z});
  return k0 * (k0 - 1.0f) / k1;
}

inline float box(Vec p, Vec centre, Vec half, float rounding) {
  const Vec q = abs(p - centre) - half + Vec{rounding, rounding, rounding};
  const Vec outside = {std::max(q.x, 0.0f), std::max(q.y, 0.0f), std::max(q.z, 0.0f)};
  return length(outside) + std::min(std::max({q.x, q.y, q.z}), 0.0f) - rounding;
}

// The hull of two spheres.
inline float round_cone(Vec p, Vec a, Vec b, float radius_a, float radius_b) {
  const Vec ab = b - a, ap = p - a;
  const float l2 = dot(ab, ab), dr = radius_a - radius_b;
  const float a2 = l2 - dr * dr;
  const float y = dot(ap, ab), z = y - l2;
  const Vec side = l2 * ap - y * ab;
  const float x2 = dot(side, side);
  const float y2 = y * y * l2, z2 = z * z * l2;
  const float k = (dr > 0 ? 1.0f : -1.0f) * dr * dr * x2;
  if ((z > 0 ? 1.0f : -1.0f) * a2 * z2 > k)
    return std::sqrt(x2 + z2) / l2 - radius_b;
  if ((y > 0 ? 1.0f : -1.0f) * a2 * y2 < k)
    return std::sqrt(x2 + y2) / l2 - radius_a;
  return (std::sqrt(x2 * a2 / l2) + y * dr) / l2 - radius_a;
}

inline float capsule(Vec p, Vec a, Vec b, float radius) {
  const Vec ab = b - a, ap = p - a;
  const float t = std::clamp(dot(ap, ab) / dot(ab, ab), 0.0f, 1.0f);
  return length(ap - t * ab) - radius;
}

// Upright, y from `bottom` to `top`.
inline float cylinder(Vec p, float radius, float bottom, float top, float rounding) {
  const float r = std::sqrt(p.x * p.x + p.z * p.z) - radius + rounding;
  const float y = std::fabs(p.y - 0.5f * (bottom + top)) - 0.5f * (top - bottom) + rounding;
  const float outside = std::sqrt(std::max(r, 0.0f) * std::max(r, 0.0f) + std::max(y, 0.0f) * std::max(y, 0.0f));
  return outside + std::min(std::max(r, y), 0.0f) - rounding;
}

// Union, difference and intersection whose edges are rounded over a width of about k.
inline float join(float a, float b, float k) {
  const float h = std::max(k - std::fabs(a - b), 0.0f) / k;
  return std::min(a, b) - 0.25f * h * h * k;
}
inline float cut(float a, float b, float k) { return -join(-a, b, k); }
inline float meet(float a, float b, float k) { return -join(-a, -b, k); }

} // namespace demo
