// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "slab/interface.hpp"

#include "media/fresnel.hpp"

namespace tyn {

Interface interface_between(const Direction &direction, double n1, double n2) {
  const double mu1 = cosine_in(direction, n1), mu2 = cosine_in(direction, n2);
  if (!(mu1 > 0 && mu2 > 0))
    return {mu1 > 0 ? 1.0 : 0.0, mu2 > 0 ? 1.0 : 0.0, 0};
  // from the thinner side, where nothing cancels
  const double f = n1 < n2 ? fresnel_reflectance(mu1, n2 / n1) : fresnel_reflectance(mu2, n1 / n2);
  return {f, f, 1 - f};
}

} // namespace tyn
