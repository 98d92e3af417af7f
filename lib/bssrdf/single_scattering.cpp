// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The source term of Hanrahan & Krueger 1993, not yet integrated over where the light leaves: of a beam that goes straight
// down, what is scattered at depth z towards a point of the surface, along the way s = sqrt(r^2 + z^2),
//   R(r) = int_0^d sigma_s exp(-sigma_t (z + s)) p(-z / s) (1 - F(z / s)) z / s^3 dz.
// Integrated over the angle instead, this is Seeliger's law.
#include "bssrdf/single_scattering.hpp"

#include <algorithm>
#include <cmath>

#include "bssrdf/integrate.hpp"
#include "core/pi.hpp"
#include "media/fresnel.hpp"
#include "media/phase.hpp"

namespace tyn {
namespace {

constexpr double TOLERANCE = 1e-7; // more than a float tells
constexpr double DARK = 100;       // optical thickness beyond which a float has nothing left

} // namespace

SingleScattering::SingleScattering(const BssrdfInput &input)
    : SingleScattering(input.sigma_s(), input.sigma_a(), input.ior(), input.top().thickness, input.top().phase) {}

SingleScattering::SingleScattering(double sigma_s_, double sigma_a, double eta_, double thickness_,
                                   const TynPhase &phase_)
    : sigma_s(sigma_s_), sigma_t(sigma_a + sigma_s_), eta(eta_), thickness(thickness_), phase(phase_density(phase_)) {}

// Over the angle from the normal, z = r / tan(angle): z / s^3 dz = cos(angle) / r dangle. Light that is reflected totally, and
// what would come from below the layer, is beyond the limits of the angle.
double SingleScattering::exitance_between(double r, double least, double most) const {
  if (sigma_s == 0 || sigma_t * r > DARK)
    return 0;
  const double flattest = angle_inside(least);
  const double lowest = std::isinf(thickness) ? 0 : std::atan2(r, thickness), steepest = angle_inside(most);
  // the same difference without its digits cancelling in thin layers
  const bool cancels = least == 0 && eta <= 1 && lowest > steepest;
  const double span = cancels ? std::atan2(thickness, r) : flattest - std::max(lowest, steepest);
  auto part = [&](double angle) {
    const double cosine = std::cos(angle), sine = std::sin(angle);
    if (!(sine > 0))
      return 0.0;
    return std::exp(-sigma_t * r / sine * (1 + cosine)) * phase(-cosine) * (1 - fresnel_reflectance(cosine, 1 / eta)) *
           cosine;
  };
  if (!(span > 0))
    return 0;
  // F has a square root at the critical angle; a substitution takes it away
  auto smooth = [&](double t) { return part(flattest - span * t * t) * 2 * span * t; };
  return sigma_s / r * integrate(smooth, 0, 1, TOLERANCE);
}

// Of light that leaves with that cosine outside (Snell).
double SingleScattering::angle_inside(double cosine) const {
  const double sine = std::sqrt((1 - cosine) * (1 + cosine)) / eta;
  return sine < 1 ? std::asin(sine) : pi / 2;
}

// Over the depth first: albedo 2 pi int_0^1 p(-mu) (1 - F(mu)) mu / (1 + mu) dmu, Seeliger's law.
double SingleScattering::half_space_albedo() const {
  const double flattest = angle_inside(0);
  auto part = [&](double t) {
    const double angle = flattest * (1 - t * t), mu = std::cos(angle);
    return phase(-mu) * (1 - fresnel_reflectance(mu, 1 / eta)) * mu / (1 + mu) * std::sin(angle) * 2 * flattest * t;
  };
  return sigma_s > 0 ? sigma_s / sigma_t * 2 * pi * integrate(part, 0, 1) : 0;
}

Profile single_scattering(const BssrdfInput &input) {
  const double sigma_t = input.sigma_a() + input.sigma_s();
  if (input.sigma_s() == 0)
    return black_profile();
  const SingleScattering single(input);
  const double length = std::min(1 / sigma_t, input.top().thickness);
  return profile_of_table(
      length, [&](double x) { return single.exitance(x * length) * length * length; }, true, sigma_t * length);
}

} // namespace tyn
