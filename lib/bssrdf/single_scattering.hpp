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

  // At radius r > 0, 1/length^2.
  double exitance(double r) const;

private:
  const double sigma_s, sigma_t, eta, thickness;
  const std::function<double(double)> phase;
};

} // namespace tyn
