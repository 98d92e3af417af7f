// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "profile/radii.hpp"

#include "slab/parse.hpp"

#include <algorithm>
#include <cmath>

namespace profile {
namespace {

constexpr size_t kMostRadii = 10000;
constexpr size_t kDefaultRadii = 60;
constexpr double kLeastRadius = 1e-30, kMostRadius = 1e30;
constexpr double kBinsInARing = 4.0; // in the narrowest
constexpr double kLeastBins = 1000.0;
constexpr double kMostBins = 262144.0; // a channel
constexpr double kAllBins =
    4190000.0; // of all channels: with those of transmittance the 2^23 tallies that there may be

std::vector<double> equal_ratios(double lowest, double highest, size_t count) {
  std::vector<double> radii;
  for (size_t i = 0; i < count; ++i)
    radii.push_back(lowest * std::pow(highest / lowest, static_cast<double>(i) / static_cast<double>(count - 1)));
  radii.back() = highest;
  return radii;
}

} // namespace

std::vector<double> parse_radii(const std::string &text) {
  const std::vector<std::string> parts = slab::split(text, ':');
  double lowest = 0.0, highest = 0.0, count = 0.0;
  if (parts.size() != 3 || !slab::parse_number(parts[0], lowest) || !slab::parse_number(parts[1], highest) ||
      !slab::parse_number(parts[2], count) || !(lowest >= kLeastRadius && lowest < highest && highest <= kMostRadius) ||
      count != std::floor(count) || count < 2.0 || count > kMostRadii)
    slab::wrong("--radii", text,
                "MIN:MAX:N with 0 < MIN < MAX (1e-30 to 1e30) and 2 to 10000 radii, such as 0.01:20:60");
  return equal_ratios(lowest, highest, static_cast<size_t>(count));
}

std::vector<double> default_radii(const std::vector<slab::LayerArgument> &layers) {
  double longest = 0.0;
  for (const slab::LayerArgument &layer : layers)
    for (size_t c = 0; c < layer.sigma_a.size(); ++c) {
      const double extinction = layer.sigma_a[c] + layer.sigma_s[c] * (1.0 - layer.g);
      if (extinction > 0.0)
        longest = std::max(longest, 1.0 / extinction);
    }
  longest = longest > 0.0 ? std::clamp(longest, 100.0 * kLeastRadius, kMostRadius / 100.0) : 1.0;
  return equal_ratios(0.01 * longest, 20.0 * longest, kDefaultRadii);
}

std::vector<double> Rings::edges() const {
  std::vector<double> result;
  for (size_t i = 0; i < borders.size(); ++i)
    result.push_back(edge(i));
  return result;
}

// One run with bins that are narrow everywhere, put together to rings, and not a run for each decade: every photon counts at
// every radius, so that a few decades cost what one does. Ring borders are moved to the nearest border of a bin; models are
// integrated over the very same ring, so that nothing is lost by that.
Rings rings_around(const std::vector<double> &radii, size_t channels) {
  const double half_step = std::sqrt(radii[1] / radii[0]);
  const double narrowest = radii.front() * (half_step - 1.0 / half_step);
  Rings rings;
  rings.end = radii.back() * half_step;
  const double most = std::min(kMostBins, kAllBins / static_cast<double>(channels));
  const double wanted = std::max(kLeastBins, std::ceil(kBinsInARing * rings.end / narrowest));
  rings.bin_count = static_cast<uint32_t>(std::min(wanted, most));
  const double bins_a_length = rings.bin_count / rings.end;
  for (const double radius : radii)
    rings.borders.push_back(static_cast<uint32_t>(std::lround(radius / half_step * bins_a_length)));
  rings.borders.push_back(rings.bin_count);
  return rings;
}

} // namespace profile
