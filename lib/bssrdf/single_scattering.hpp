// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "bssrdf/model.hpp"

namespace tyn {

// Light that was scattered once in the top layer, for perpendicular incidence, per power that gets in: exact, but for light
// that boundaries reflect back inside.
class SingleScattering {
public:
  explicit SingleScattering(const BssrdfInput &input);
  // `eta`: inside over outside. The phase function's table stays the caller's.
  SingleScattering(double sigma_s, double sigma_a, double eta, double thickness, const TynPhase &phase);

  // At radius r > 0, 1/length^2.
  double exitance(double r) const { return exitance_between(r, 0, 1); }
  // The part of it that leaves with a cosine from `least` to `most`.
  double exitance_between(double r, double least, double most) const;

  // Of a half-space: int 2 pi r exitance(r) dr.
  double half_space_albedo() const;

private:
  double angle_inside(double cosine) const;

  const double sigma_s, sigma_t, eta, thickness;
  const std::function<double(double)> phase;
};

} // namespace tyn
