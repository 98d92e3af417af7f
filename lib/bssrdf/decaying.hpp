// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "bssrdf/hankel.hpp"

namespace tyn {

// A positive function that falls off with the radius, from its values at radii of equal ratios as inverse_hankel gives them:
// joined smoothly where they have digits left, continued as an exponential beyond.
class DecayingFunction {
public:
  DecayingFunction(double first, const std::vector<HankelValue> &values);

  // r > 0. 0 everywhere if not even the first values mean anything.
  double operator()(double r) const;

  // The rate at which it falls off beyond the last radius, if it is taken to fall off like exp(-rate r) / r^3 there.
  double falloff() const;

private:
  double radius(double i) const;
  double interpolate(double i) const;

  double first, last, slope = 0; // slope: -d ln f / dr at the last value that means something
  std::vector<double> logarithms;
  bool all; // whether all of them do
};

} // namespace tyn
