// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
//
// What stands on the table, in centimetres, each on its own origin with the table at y = 0.
#pragma once

#include "demo/sdf.hpp"

namespace demo {

// A burnt candle: a hollow with a lit rim, runs of wax down the side, a pool at the foot.
class Candle {
public:
  static constexpr float kRadius = 2.15f;
  static constexpr float kHeight = 7.3f;
  static constexpr float kHollow = 6.6f; // the lowest point of the hollow

  Vec lower() const { return {-4.6f, -0.4f, -4.6f}; }
  Vec upper() const { return {4.6f, 10.2f, 4.6f}; }

  float operator()(Vec p) const {
    const float angle = std::atan2(p.z, p.x);
    const float rim = 0.22f * std::sin(2 * angle + 0.6f) + 0.12f * std::sin(5 * angle + 1.0f);
    const float bulge = 0.07f * std::sin(3 * angle + 0.4f * p.y) + 0.05f * std::sin(7 * angle - 0.5f * p.y);
    float d = cylinder(p, kRadius + bulge, 0, kHeight + rim, 0.35f);
    d = cut(d, ellipsoid(p, {0, kHollow + 2.0f, 0}, {2.05f, 2.0f, 2.05f}), 0.35f);
    d = join(d, foot(p, angle), 0.6f);
    for (const Run &run : kRuns)
      d = join(d, drip(p, run), 0.45f);
    return std::max(d, -p.y);
  }

private:
  struct Run {
    float angle, bottom, radius;
  };
  static constexpr Run kRuns[7] = {{35, 3.4f, 0.30f},  {80, 5.4f, 0.26f},  {112, 1.6f, 0.33f}, {165, 4.2f, 0.29f},
                                   {-28, 5.0f, 0.26f}, {-75, 2.6f, 0.31f}, {-140, 4.7f, 0.28f}};

  static float drip(Vec p, const Run &run) {
    const float a = radians(run.angle);
    const float r = kRadius + 0.08f;
    const Vec top = {(r - 0.25f) * std::cos(a), kHeight - 0.1f, (r - 0.25f) * std::sin(a)};
    const Vec bottom = {r * std::cos(a), run.bottom, r * std::sin(a)};
    return round_cone(p, top, bottom, 0.7f * run.radius, run.radius);
  }

  static float foot(Vec p, float angle) {
    const float r = 2.7f + 0.3f * std::sin(2 * angle + 2.0f) + 0.17f * std::sin(5 * angle);
    return ellipsoid(p, {0, 0, 0}, {r, 0.55f, r});
  }
};

// A head after the marble figures of the Cyclades: a shield on a neck, a nose, and nothing else.
class Muse {
public:
  Vec lower() const { return {-5, -0.4f, -5}; }
  Vec upper() const { return {5, 17.5f, 5}; }

  float operator()(Vec p) const {
    const float base = ellipsoid(p, {0, -1.2f, 0}, {3.4f, 2.6f, 2.4f});
    const float neck = round_cone({p.x, p.y, 1.1f * p.z}, {0, 0, 0}, {0, 8.0f, -0.2f}, 1.55f, 1.3f);
    const float d = join(join(base, neck, 1.6f), head(tilted(p)), 0.8f);
    return std::max(d, -p.y);
  }

private:
  // The chin is the origin; the face looks a little upwards.
  static Vec tilted(Vec p) {
    const float a = radians(13), c = std::cos(a), s = std::sin(a);
    const Vec q = p - Vec{0, 5.6f, 1.0f};
    return {q.x, c * q.y - s * q.z, s * q.y + c * q.z};
  }

  static float head(Vec q) {
    // Wide at the brow, narrow at the chin, and flat from front to back.
    const float t = std::clamp(q.y / 9.0f, 0.0f, 1.0f);
    const float width = 0.58f + 0.62f * t - 0.12f * t * t;
    const Vec shield = {q.x / width, q.y, q.z};
    float d = 0.75f * ellipsoid(shield, {0, 4.6f, 0}, {3.35f, 5.0f, 1.9f});
    d = meet(d, (q.y - 8.9f + 0.5f * q.z) * 0.9f, 0.9f); // the crown slopes back
    const float face = q.z - 1.35f + 0.025f * q.x * q.x;
    d = meet(d, face, 0.9f);
    const float nose = round_cone(q, {0, 6.6f, 1.15f}, {0, 3.3f, 1.75f}, 0.25f, 0.55f);
    d = join(d, nose, 0.5f);
    const Vec m = {std::fabs(q.x), q.y, q.z};
    const float brow = capsule(m, {0, 6.75f, 1.2f}, {2.2f, 6.5f, 0.75f}, 0.3f);
    d = join(d, brow, 0.8f);
    const float mouth = capsule(m, {0, 1.75f, 1.25f}, {0.75f, 1.78f, 1.15f}, 0.05f);
    return cut(d, mouth, 0.3f);
  }
};

// A crouching hare with its ears up, as carved for a pocket; it looks towards +X.
class Hare {
public:
  Vec lower() const { return {-5.4f, -0.4f, -3.2f}; }
  Vec upper() const { return {5.4f, 9.0f, 3.2f}; }

  float operator()(Vec p) const {
    const Vec m = {p.x, p.y, std::fabs(p.z)}; // left and right alike
    float d = ellipsoid(p, {-0.9f, 2.25f, 0}, {3.3f, 2.15f, 2.05f});
    d = join(d, ellipsoid(m, {-1.9f, 1.6f, 1.45f}, {1.9f, 1.75f, 0.85f}), 0.35f);             // haunch
    d = join(d, ellipsoid(m, {-1.0f, 0.3f, 1.7f}, {1.7f, 0.45f, 0.55f}), 0.25f);              // hind foot
    d = join(d, round_cone(m, {1.7f, 1.9f, 0.75f}, {2.7f, 0.35f, 0.85f}, 0.8f, 0.42f), 0.4f); // fore leg
    d = join(d, sphere(p, {-4.2f, 2.1f, 0}, 0.75f), 0.4f);                                    // tail
    d = join(d, ellipsoid(p, {1.7f, 2.9f, 0}, {1.5f, 1.9f, 1.4f}), 0.9f);                     // chest
    d = join(d, head(p, m), 0.6f);
    return std::max(d, -p.y);
  }

private:
  static float head(Vec p, Vec m) {
    float d = ellipsoid(p, {2.7f, 4.6f, 0}, {1.55f, 1.25f, 1.15f});
    d = join(d, ellipsoid(p, {3.75f, 4.25f, 0}, {0.85f, 0.72f, 0.7f}), 0.5f);
    d = join(d, ellipsoid(m, {3.1f, 4.2f, 0.65f}, {0.8f, 0.6f, 0.5f}), 0.4f);
    d = cut(d, sphere(m, {3.25f, 4.95f, 1.18f}, 0.28f), 0.1f);
    d = join(d, sphere(m, {3.22f, 4.95f, 1.0f}, 0.2f), 0.04f);
    return join(d, ear(m), 0.4f);
  }

  // Thin, and hollowed towards the front: light comes through.
  static float ear(Vec m) {
    const Vec root = {2.1f, 5.4f, 0.5f}, tip = {-0.6f, 8.35f, 1.35f};
    const Vec along = normalize(tip - root);
    const Vec side = normalize(cross(along, {0.74f, 0.62f, 0.25f}));
    const Frame frame = {side, along, cross(side, along), mix(root, tip, 0.52f)};
    const Vec q = frame.to_local(m);
    const float shell = ellipsoid(q, {0, 0, 0}, {0.78f, 2.1f, 0.42f});
    const float hollow = ellipsoid(q, {0, 0.05f, 0.42f}, {0.55f, 1.75f, 0.42f});
    return cut(shell, hollow, 0.15f);
  }
};

} // namespace demo
