// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Between the colour of a medium and its single-scattering albedo.
#include <cmath>

#include "tyndall/tyndall.h"

namespace {

// Into [0, 1]; NaN becomes 0.
double unit(double value) { return std::fmin(std::fmax(value, 0.0), 1.0); }

// The similarity parameter s = sqrt((1 - W) / (1 - W g)) that belongs to a diffuse albedo: the
// inverse of C = (1 - s) (1 - 0.139 s) / (1 + 1.17 s) (van de Hulst 1980), as Kulla & Conty 2017
// write it.
double similarity(double color) {
  return 4.09712 + 4.20863 * color - std::sqrt(9.59217 + 41.6808 * color + 17.7126 * color * color);
}

} // namespace

// Kulla & Conty, "Revisiting Physically Based Shading at Imageworks", 2017: W = (1 - s^2) / (1 - g
// s^2).
float tyn_albedo_from_color(float color, float g) {
  // The rounded constants give s = 1.00001 for black and 0.0000x for white.
  const double s = unit(similarity(unit(static_cast<double>(color))));
  const double albedo = (1.0 - s * s) / (1.0 - static_cast<double>(g) * s * s);
  return static_cast<float>(unit(albedo));
}

// van de Hulst, "Multiple Light Scattering", 1980: the diffuse albedo of an index-matched
// half-space.
float tyn_color_from_albedo(float albedo, float g) {
  const double w = unit(static_cast<double>(albedo));
  const double s = std::sqrt((1.0 - w) / (1.0 - w * static_cast<double>(g)));
  return static_cast<float>(unit((1.0 - s) * (1.0 - 0.139 * s) / (1.0 + 1.17 * s)));
}
