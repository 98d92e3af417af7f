// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace tyn {

// Fraction of unpolarized light that a smooth dielectric interface reflects (Fresnel). cos_i >= 0; eta = index of the far side /
// index of the near side. Equal indices reflect nothing, exactly.
inline double fresnel_reflectance(double cos_i, double eta) {
  const double square = (eta - 1) * (eta + 1) + cos_i * cos_i; // (eta cos_t)^2
  if (square <= 0)
    return 1;
  const double eta_cos_t = std::sqrt(square);
  const double perpendicular = (cos_i - eta_cos_t) / (cos_i + eta_cos_t);
  const double parallel = (eta * eta * cos_i - eta_cos_t) / (eta * eta * cos_i + eta_cos_t);
  return 0.5 * (perpendicular * perpendicular + parallel * parallel);
}

} // namespace tyn
