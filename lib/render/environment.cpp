// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "render/environment.hpp"

#include <algorithm>
#include <cmath>

#include "core/pi.hpp"
#include "render/alias.hpp"

namespace tyn {
namespace {

double mean_of(const float *rgb, const float *factor) {
  return (double(rgb[0]) * double(factor[0]) + double(rgb[1]) * double(factor[1]) +
          double(rgb[2]) * double(factor[2])) /
         3;
}

// Mean over each pixel of the bilinearly interpolated image: in each direction 1/8, 6/8, 1/8 of a pixel and its neighbours.
std::vector<double> interpolated(const Image &image, const float *factor) {
  const size_t w = image.width, h = image.height;
  const float *pixels = reinterpret_cast<const float *>(image.pixels.data());
  std::vector<double> rows(w * h), result(w * h);
  for (size_t y = 0; y < h; y++)
    for (size_t x = 0; x < w; x++) {
      const auto at = [&](size_t column) { return mean_of(pixels + 4 * (y * w + column), factor); };
      rows[y * w + x] = 0.75 * at(x) + 0.125 * (at(x == 0 ? w - 1 : x - 1) + at(x + 1 == w ? 0 : x + 1));
    }
  for (size_t y = 0; y < h; y++)
    for (size_t x = 0; x < w; x++) {
      const size_t above = y == 0 ? 0 : y - 1, below = std::min(y + 1, h - 1);
      result[y * w + x] = 0.75 * rows[y * w + x] + 0.125 * (rows[above * w + x] + rows[below * w + x]);
    }
  return result;
}

// Solid angle of a pixel in row y.
double solid_angle(const Image &image, size_t y) {
  const double top = std::cos(pi * double(y) / image.height), bottom = std::cos(pi * double(y + 1) / image.height);
  return 2 * pi * (top - bottom) / image.width;
}

} // namespace

EnvironmentSampling sample_environment(const TynScene &scene, uint32_t strategy) {
  EnvironmentSampling result;
  const TynEnvironment &environment = scene.environment;
  const bool lights_only = strategy == TYN_STRATEGY_LIGHTS;
  if (strategy == TYN_STRATEGY_LOBES)
    return result;
  if (environment.image == TYN_NONE) {
    const float ones[3] = {1, 1, 1};
    result.power = lights_only ? 4 * pi * mean_of(environment.radiance, ones) : 0;
    return result;
  }

  const Image &image = scene.images[environment.image];
  std::vector<double> weights = interpolated(image, environment.radiance);
  double total = 0;
  for (size_t i = 0; i < weights.size(); i++)
    total += weights[i] * solid_angle(image, i / image.width);
  const double floor = lights_only ? 0 : total / (4 * pi);
  for (size_t i = 0; i < weights.size(); i++) {
    weights[i] = std::max(0.0, weights[i] - floor) * solid_angle(image, i / image.width);
    result.power += weights[i];
  }
  // An even image leaves only rounding errors.
  if (!(result.power > 1e-6 * total)) {
    result.power = 0;
    return result;
  }
  const std::vector<AliasRow> rows = alias_table(weights);
  result.texels.reserve(rows.size());
  for (size_t i = 0; i < rows.size(); i++)
    result.texels.push_back({rows[i].threshold, rows[i].alias, float(weights[i] / result.power * double(rows.size()))});
  return result;
}

} // namespace tyn
