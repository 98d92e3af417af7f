// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
//
// Radii in equal ratios, and the rings around them.
#pragma once

#include "slab/arguments.hpp"

namespace profile {

// MIN:MAX:N. Throws on wrong usage.
std::vector<double> parse_radii(const std::string &text);

// From 0.01 to 20 reduced mean free paths of the layer and channel where they are longest.
std::vector<double> default_radii(const std::vector<slab::LayerArgument> &layers);

// Rings made of bins as tyn_slab_simulate has them: `bin_count` equal steps of the radius from 0 to `end`. Ring i is
// borders[i] <= bin < borders[i + 1]; where radii are closer than bins it may have none.
struct Rings {
  double end = 0.0;
  uint32_t bin_count = 0;
  std::vector<uint32_t> borders;

  size_t count() const { return borders.size() - 1; }
  double edge(size_t i) const { return end * borders[i] / bin_count; }
  bool empty(size_t i) const { return borders[i] == borders[i + 1]; }
  std::vector<double> edges() const;
};

// Rings with borders half-way between the radii, in ratio.
Rings rings_around(const std::vector<double> &radii, size_t channels);

} // namespace profile
