// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "render/fresnel.hpp"

#include <cmath>

namespace tyn {
namespace {

// Fresnel's reflectance for unpolarized light from outside; as tyn_fresnel of kernels/interface.clh.
double fresnel(double cosine, double ior) {
  const double inside = std::sqrt(1 - (1 - cosine * cosine) / (ior * ior));
  const double parallel = (ior * cosine - inside) / (ior * cosine + inside);
  const double perpendicular = (cosine - ior * inside) / (cosine + ior * inside);
  return 0.5 * (parallel * parallel + perpendicular * perpendicular);
}

} // namespace

double mean_transmittance(double ior) {
  if (ior == 1)
    return 1;
  // Simpson's rule over x with mu = x^2: for an index near 1, F changes fast near mu = 0, where this puts the points.
  constexpr int intervals = 4096;
  double sum = 0;
  for (int i = 0; i <= intervals; i++) {
    const double x = double(i) / intervals;
    const double weight = i == 0 || i == intervals ? 1 : i % 2 ? 4 : 2;
    sum += weight * 4 * x * x * x * (1 - fresnel(x * x, ior));
  }
  return sum / (3 * intervals);
}

} // namespace tyn
