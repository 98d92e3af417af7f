// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "common/plot.hpp"

#include <algorithm>
#include <iterator>

namespace tool {
namespace {

// Okabe & Ito's palette without its black and with a darker yellow.
const Color kPalette[] = {{0.000, 0.447, 0.698}, {0.835, 0.369, 0.000}, {0.000, 0.620, 0.451}, {0.800, 0.475, 0.655},
                          {0.902, 0.624, 0.000}, {0.337, 0.706, 0.914}, {0.750, 0.700, 0.100}, {0.400, 0.400, 0.400}};

// Five points of the colour map viridis.
const Color kMap[] = {
    {0.267, 0.005, 0.329}, {0.231, 0.318, 0.545}, {0.128, 0.567, 0.551}, {0.369, 0.789, 0.383}, {0.880, 0.850, 0.110}};

double mix(double a, double b, double t) { return a + (b - a) * t; }

} // namespace

Color distinct_color(size_t index, size_t count) {
  if (count <= std::size(kPalette))
    return kPalette[index % std::size(kPalette)];
  const double at = static_cast<double>(index) / static_cast<double>(count - 1) * (std::size(kMap) - 1);
  const auto below = std::min(static_cast<size_t>(at), std::size(kMap) - 2);
  const Color &a = kMap[below], &b = kMap[below + 1];
  const double t = std::min(at - static_cast<double>(below), 1.0);
  return {mix(a.red, b.red, t), mix(a.green, b.green, t), mix(a.blue, b.blue, t)};
}

} // namespace tool
