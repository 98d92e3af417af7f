// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
//
// Three floats, and what is done with them.
#pragma once

#include <cmath>

namespace demo {

constexpr float kPi = 3.14159265f;

struct Vec {
  float x, y, z;
};

inline Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec operator-(Vec a) { return {-a.x, -a.y, -a.z}; }
inline Vec operator*(float s, Vec a) { return {s * a.x, s * a.y, s * a.z}; }
inline Vec operator*(Vec a, Vec b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
inline float dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec cross(Vec a, Vec b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
inline float length(Vec a) { return std::sqrt(dot(a, a)); }
inline Vec normalize(Vec a) { return (1.0f / length(a)) * a; }
inline Vec mix(Vec a, Vec b, float t) { return a + t * (b - a); }
inline Vec abs(Vec a) { return {std::fabs(a.x), std::fabs(a.y), std::fabs(a.z)}; }
inline float radians(float degrees) { return degrees * (kPi / 180.0f); }

// A rotation and a move: local axes and origin in the world.
struct Frame {
  Vec x, y, z, origin;

  Vec to_world(Vec p) const { return origin + p.x * x + p.y * y + p.z * z; }
  Vec direction_to_world(Vec d) const { return d.x * x + d.y * y + d.z * z; }
  Vec to_local(Vec p) const {
    const Vec d = p - origin;
    return {dot(d, x), dot(d, y), dot(d, z)};
  }
};

// Local +Z points against `forward` and local +Y as far up as it can: how glTF cameras and lights look.
inline Frame looking(Vec from, Vec forward, Vec up = {0, 1, 0}) {
  const Vec z = -normalize(forward);
  const Vec x = normalize(cross(up, z));
  return {x, cross(z, x), z, from};
}

// Turns about +Y, counter-clockwise seen from above, and moves.
inline Frame turned(Vec origin, float degrees) {
  const float c = std::cos(radians(degrees)), s = std::sin(radians(degrees));
  return {{c, 0, -s}, {0, 1, 0}, {s, 0, c}, origin};
}

} // namespace demo
