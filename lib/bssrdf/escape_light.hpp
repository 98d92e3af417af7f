// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// From counted walks to light at an albedo: sum over the orders n of albedo^n, and what the walks that were not followed to
// their ends would have added.
#pragma once

#include <vector>

#include "slab/escapes.hpp"

namespace tyn {

// What comes back scattered twice or more, per power that gets in, in each ring of the radii and each step of the angle. There
// are more rings than the walks are counted in: farther out there are only walks that were not followed so far.
struct EscapeLight {
  uint32_t radii;
  std::vector<double> power;    // [radius * TYN_ESCAPE_ANGLES + angle]
  std::vector<double> variance; // squared standard errors

  double sum() const;
};

// The borders of ring `radius`; the last one has no end.
double ring_begin(const EscapeGrid &grid, uint32_t radius);
double ring_end(const EscapeGrid &grid, uint32_t radius);

// `mean_cosine` of the phase function; `absorption` = 1 - albedo.
EscapeLight light_of(const Escapes &escapes, double mean_cosine, double absorption);

} // namespace tyn
