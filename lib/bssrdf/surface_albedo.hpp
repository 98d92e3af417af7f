// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tyndall/tyndall_phase.h"

namespace tyn {

struct HalfSpace {
  const TynPhase &phase;
  double ior, ior_above;
  double sigma_a, sigma_s;
};

// The light that comes back scattered from a half-space, over that which gets in, to about 1e-6 (adding and doubling): of light
// that arrives perpendicularly, or from everywhere.
double surface_albedo(const HalfSpace &medium, bool diffuse);

// The same of light that arrives with each of these cosines, in (0, 1].
std::vector<double> surface_albedos(const HalfSpace &medium, const std::vector<double> &cosines);

} // namespace tyn
