// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "render/fresnel.hpp"

#include "media/fresnel.hpp"

namespace tyn {
double mean_transmittance(double ior) {
  if (ior == 1)
    return 1;
  // Simpson's rule over x with mu = x^2: for an index near 1, F changes fast near mu = 0, where this puts the points.
  constexpr int intervals = 4096;
  double sum = 0;
  for (int i = 0; i <= intervals; i++) {
    const double x = double(i) / intervals;
    const double weight = i == 0 || i == intervals ? 1 : i % 2 ? 4 : 2;
    sum += weight * 4 * x * x * x * (1 - fresnel_reflectance(x * x, ior));
  }
  return sum / (3 * intervals);
}

} // namespace tyn
