// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

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

} // namespace tyn
