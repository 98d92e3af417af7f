// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
//
// A right hand with its forearm, in centimetres: the wrist at the origin, fingers up (+Y), the back of the hand towards
// +Z, the thumb towards -X.
#pragma once

#include "demo/sdf.hpp"

#include <array>

namespace demo {

class Hand {
public:
  Hand() {
    //               knuckle              fan   bend of the three joints   lengths         radius
    fingers_[0] = finger({-2.95f, 9.0f, 0.05f}, -9, {16, 20, 14}, {4.3f, 2.6f, 1.55f}, 0.93f);
    fingers_[1] = finger({-0.95f, 9.5f, 0.25f}, -2, {12, 18, 12}, {4.8f, 3.0f, 1.65f}, 0.97f);
    fingers_[2] = finger({1.05f, 9.15f, 0.15f}, 5, {15, 20, 14}, {4.5f, 2.8f, 1.65f}, 0.92f);
    fingers_[3] = finger({2.85f, 8.2f, -0.20f}, 14, {20, 22, 16}, {3.5f, 2.0f, 1.4f}, 0.80f);
    thumb_ = {Vec{-1.5f, 2.1f, -0.9f}, {-4.5f, 5.3f, -1.7f}, {-6.1f, 8.1f, -1.9f}, {-6.75f, 10.2f, -1.75f}};
  }

  Vec lower() const { return {-9, -17, -9}; }
  Vec upper() const { return {14, 21, 6}; }

  float operator()(Vec p) const {
    float digits = 1e9f;
    for (const Finger &each : fingers_)
      digits = join(digits, finger_distance(p, each), 0.22f);
    float d = join(join(palm(p), arm(p), 2.2f), digits, 0.75f);
    d = join(d, thumb(p), 1.1f);
    d = join(d, tendons(p), 0.55f);
    for (const Finger &each : fingers_)
      d = nail(p, each.joints[2], each.joints[3], each.back, 0.78f * each.radius, d);
    return nail(p, thumb_[2], thumb_[3], normalize({-0.45f, 0.05f, 0.9f}), 0.80f, d);
  }

private:
  struct Finger {
    std::array<Vec, 4> joints; // knuckle, two joints, centre of the tip
    Vec back;                  // unit, the side of the nail
    float radius;              // at the knuckle
  };

  static Finger finger(Vec knuckle, float fan, Vec bends, Vec lengths, float radius) {
    Finger result = {{knuckle}, {0, 0, 1}, radius};
    const float bend[3] = {bends.x, bends.y, bends.z}, length[3] = {lengths.x, lengths.y, lengths.z};
    const float f = radians(fan);
    float flex = 0;
    for (int i = 0; i < 3; ++i) {
      flex += radians(bend[i]);
      const float c = std::cos(flex);
      const Vec direction = {std::sin(f) * c, std::cos(f) * c, -std::sin(flex)};
      result.joints[i + 1] = result.joints[i] + length[i] * direction;
      result.back = normalize(Vec{0, 0, 1} - direction.z * direction);
    }
    return result;
  }

  // Bones, thicker joints, and the pad of the fingertip on the palm's side.
  static float finger_distance(Vec p, const Finger &f) {
    const float r = f.radius;
    const float bound = sphere(p, f.joints[1], 6.5f);
    if (bound > 1.5f)
      return bound;
    float d = round_cone(p, f.joints[0], f.joints[1], r, 0.88f * r);
    d = join(d, round_cone(p, f.joints[1], f.joints[2], 0.88f * r, 0.80f * r), 0.25f);
    d = join(d, round_cone(p, f.joints[2], f.joints[3], 0.79f * r, 0.66f * r), 0.25f);
    d = join(d, sphere(p, f.joints[1] + 0.06f * f.back, 0.93f * r), 0.35f);
    d = join(d, sphere(p, f.joints[2] + 0.02f * f.back, 0.83f * r), 0.3f);
    const Vec pad = mix(f.joints[2], f.joints[3], 0.72f) - 0.16f * f.back;
    d = join(d, sphere(p, pad, 0.66f * r), 0.35f);
    return creases(p, f.joints[1], f.back, r, creases(p, f.joints[2], f.back, 0.9f * r, d));
  }

  // Shallow wrinkles across the back of a joint.
  static float creases(Vec p, Vec joint, Vec back, float r, float d) {
    const Vec q = p - joint;
    const float out = dot(q, back);
    const float reach = length(q) / (1.15f * r);
    if (out < 0 || reach > 1)
      return d;
    const float fade = (1 - reach * reach) * out / r;
    return d + 0.035f * fade * std::cos(9.0f * q.y / r);
  }

  float palm(Vec p) const {
    static const float wrist[4] = {-1.35f, -0.45f, 0.5f, 1.35f};
    float d = 1e9f;
    for (int i = 0; i < 4; ++i) {
      const Vec knuckle = fingers_[i].joints[0] - Vec{0, 0.2f, 0.22f};
      d = join(d, round_cone(p, {wrist[i], 0.6f, -0.15f}, knuckle, 1.5f, 1.02f), 1.0f);
    }
    d = join(d, round_cone(p, {-1.7f, 2.0f, -1.0f}, {-3.6f, 5.2f, -1.5f}, 1.35f, 1.15f), 1.0f);
    d = join(d, round_cone(p, {1.9f, 2.2f, -0.9f}, {2.6f, 6.6f, -0.9f}, 1.25f, 0.95f), 1.0f);
    for (const Finger &each : fingers_)
      d = join(d, sphere(p, each.joints[0] + Vec{0, -0.05f, 0.28f}, 0.74f), 0.45f);
    return d;
  }

  // The hand is bent towards the little finger, so that the arm can come in low.
  static float arm(Vec p) {
    const float radius = round_cone(p, {-0.9f, 1.2f, -0.25f}, {6.6f, -13.4f, -0.9f}, 1.5f, 3.0f);
    const float ulna = round_cone(p, {1.0f, 1.3f, -0.2f}, {9.6f, -11.4f, -0.9f}, 1.4f, 2.9f);
    const float bump = sphere(p, {2.3f, -0.6f, 0.75f}, 0.85f);
    const float d = join(join(radius, ulna, 1.3f), bump, 1.0f);
    return std::max(d, dot(p, {0.55f, -0.83f, 0}) - 14.0f); // ends outside the picture
  }

  // The thumb's own web is thin: light comes through it first.
  float thumb(Vec p) const {
    float d = round_cone(p, thumb_[0], thumb_[1], 1.3f, 1.12f);
    d = join(d, round_cone(p, thumb_[1], thumb_[2], 1.08f, 0.96f), 0.4f);
    d = join(d, round_cone(p, thumb_[2], thumb_[3], 0.98f, 0.76f), 0.3f);
    d = join(d, sphere(p, mix(thumb_[2], thumb_[3], 0.6f) + Vec{0.12f, 0, -0.12f}, 0.88f), 0.3f);
    const float web = round_cone(p, {-3.5f, 5.6f, -0.9f}, {-3.0f, 7.4f, -0.4f}, 0.55f, 0.5f);
    return join(d, web, 1.2f);
  }

  float tendons(Vec p) const {
    static const float wrist[4] = {-0.5f, -0.15f, 0.2f, 0.55f};
    float d = 1e9f;
    for (int i = 0; i < 4; ++i) {
      const Vec to = fingers_[i].joints[0] + Vec{0, 0.1f, 0.62f};
      const Vec from = {wrist[i], 1.2f, 0.85f};
      d = std::min(d, capsule(p, from, to, 0.28f));
    }
    return d;
  }

  // A plate let into the back of the fingertip, with a groove around it.
  static float nail(Vec p, Vec joint, Vec tip, Vec back, float r, float d) {
    const Vec along = normalize(tip - joint);
    const Vec up = normalize(back - dot(back, along) * along);
    const Frame frame = {cross(along, up), along, up, tip + 0.05f * along};
    const Vec q = frame.to_local(p);
    if (length(q) > 2.0f)
      return d;
    const Vec plate = {0.70f * r, 0.98f * r, 0.98f * r};
    const float nail_plate = ellipsoid(q, {0, 0.08f * r, 0}, plate);
    const float outline = std::max(ellipsoid({q.x, q.y, 0}, {0, 0.05f, 0}, {0.62f * r, 0.85f * r, 1.0f}), -q.z);
    const float groove = std::fabs(outline) - 0.05f;
    if (q.z > 0)
      d = cut(d, std::max(groove, std::fabs(d) - 0.05f), 0.06f);
    return std::min(d, std::max(nail_plate, outline + 0.04f));
  }

  std::array<Finger, 4> fingers_;
  std::array<Vec, 4> thumb_;
};

} // namespace demo
