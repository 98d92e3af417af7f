// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "media/mie.hpp"

namespace tyn {

struct MieMeans {
  TynMieCrossSections cross_sections;
  std::vector<double> values; // p at each cosine
};

// Throws INVALID_ARGUMENT for a distribution out of range, or one that reaches beyond the largest size parameter.
MieMeans mie_lognormal(const TynMieDistribution &distribution, const double *cosines, size_t count);

} // namespace tyn
