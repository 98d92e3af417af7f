// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "bssrdf/diffusion.hpp"

#include <cmath>

#include "bssrdf/integrate.hpp"
#include "media/fresnel.hpp"
#include "media/phase.hpp"

namespace tyn {

ReducedMedium reduced(const SlabLayer &layer, uint32_t channel) {
  ReducedMedium medium;
  medium.sigma_s = layer.sigma_s[channel] * (1 - phase_mean_cosine(layer.phase));
  medium.sigma_t = layer.sigma_a[channel] + medium.sigma_s;
  medium.albedo = medium.sigma_t > 0 ? medium.sigma_s / medium.sigma_t : 0;
  return medium;
}

// Below the critical cosine all is reflected; above it F has a square root, which mu = critical + (1 - critical) t^2 takes
// away.
FresnelMoments fresnel_moments(double eta) {
  const double critical = eta > 1 ? std::sqrt((1 - 1 / eta) * (1 + 1 / eta)) : 0;
  auto moment = [&](int power) {
    auto part = [&](double t) {
      const double mu = critical + (1 - critical) * t * t;
      return fresnel_reflectance(mu, 1 / eta) * std::pow(mu, power) * 2 * (1 - critical) * t;
    };
    return std::pow(critical, power + 1) / (power + 1) + (eta == 1 ? 0 : integrate(part, 0, 1));
  };
  return {moment(1), moment(2)};
}

double internal_reflection_fit(double eta) {
  const double above_1 = -1.440 / (eta * eta) + 0.710 / eta + 0.668 + 0.0636 * eta;
  const double below_1 = -0.4399 + 0.7099 / eta - 0.3319 / (eta * eta) + 0.0636 / (eta * eta * eta);
  const bool fits = eta >= 0.5 && eta <= 2;
  const double f_dr = fits ? (eta < 1 ? below_1 : above_1) : 2 * fresnel_moments(eta).c1;
  return (1 + f_dr) / (1 - f_dr);
}

ExitanceBoundary exitance_boundary(double eta) {
  const FresnelMoments m = fresnel_moments(eta);
  return {0.25 * (1 - 2 * m.c1), 0.5 * (1 - 3 * m.c2), (1 + 3 * m.c2) / (1 - 2 * m.c1)};
}

GrosjeanDiffusion::GrosjeanDiffusion(double reduced_albedo)
    : d((2 - reduced_albedo) / 3), falloff(std::sqrt((1 - reduced_albedo) / d)) {}

} // namespace tyn
