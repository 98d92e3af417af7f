// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// From counted walks to light at an albedo: sum over the orders n of albedo^n, and what the walks that were not followed to
// their ends would have added.
#pragma once

#include <vector>

#include "slab/escapes.hpp"

namespace tyn {

// What comes back scattered twice or more, per power that gets in, in each ring of the radii and each step of the angle.
struct EscapeLight {
  std::vector<double> power;    // [radius * TYN_ESCAPE_ANGLES + angle]
  std::vector<double> variance; // squared standard errors

  double sum() const;
};

// `mean_cosine` of the phase function; `absorption` = 1 - albedo.
EscapeLight light_of(const Escapes &escapes, double mean_cosine, double absorption);

} // namespace tyn
