// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "common/bssrdf_paths.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace tyn_test {
namespace {

void draw_unit(std::mt19937_64 &random, double (&v)[3]) {
  std::normal_distribution<double> normal;
  double squared = 0;
  for (double &c : v)
    c = normal(random), squared += c * c;
  for (double &c : v)
    c /= std::sqrt(squared);
}

// A direction and a normal with `sign` times their product above 0.
void draw_side(std::mt19937_64 &random, double sign, float (&normal)[3], float (&direction)[3]) {
  double n[3], d[3];
  draw_unit(random, n);
  draw_unit(random, d);
  const double product = sign * (n[0] * d[0] + n[1] * d[1] + n[2] * d[2]);
  for (int k = 0; k < 3; ++k) {
    normal[k] = float(n[k]);
    direction[k] = float(product > 0 ? d[k] : -d[k]);
  }
}

} // namespace

double transmittance(double cosine, double ior) {
  const double sine = std::sqrt(1 - cosine * cosine) / ior;
  if (sine >= 1)
    return 0;
  const double refracted = std::sqrt(1 - sine * sine);
  const double s = 2 * cosine / (cosine + ior * refracted), p = 2 * cosine / (ior * cosine + refracted);
  return ior * refracted / cosine * 0.5 * (s * s + p * p);
}

TynBssrdfPath plane_path(double r, double entry, double exit) {
  return {{0, 0, 0},        {0, 0, 1}, {float(std::sin(entry)), 0, float(-std::cos(entry))},
          {float(r), 0, 0}, {0, 0, 1}, {float(std::sin(exit)), 0, float(std::cos(exit))}};
}

std::vector<TynBssrdfPath> random_paths(size_t count, uint64_t seed, double nearest, double farthest) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform;
  std::vector<TynBssrdfPath> paths(count);
  for (TynBssrdfPath &path : paths) {
    double offset[3];
    draw_unit(random, offset);
    const double length = nearest * std::pow(farthest / nearest, uniform(random));
    for (int k = 0; k < 3; ++k) {
      path.entry_position[k] = float(length * uniform(random));
      path.exit_position[k] = path.entry_position[k] + float(length * offset[k]);
    }
    draw_side(random, -1, path.entry_normal, path.entry_direction);
    draw_side(random, 1, path.exit_normal, path.exit_direction);
  }
  return paths;
}

TynBssrdfPath reversed(const TynBssrdfPath &path) {
  TynBssrdfPath back;
  for (int k = 0; k < 3; ++k) {
    back.entry_position[k] = path.exit_position[k];
    back.entry_normal[k] = path.exit_normal[k];
    back.entry_direction[k] = -path.exit_direction[k];
    back.exit_position[k] = path.entry_position[k];
    back.exit_normal[k] = path.entry_normal[k];
    back.exit_direction[k] = -path.entry_direction[k];
  }
  return back;
}

} // namespace tyn_test
