// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Chandrasekhar's H-function and the isotropically scattering half-space.
#include <cmath>

#include "core/argument.hpp"
#include "core/context.hpp"
#include "core/pi.hpp"
#include "tyndall/tyndall_exact.h"

namespace tyn {
namespace {

// 1 - atan(t) / t
double arc_defect(double t) {
  if (t > 0.1)
    return 1 - std::atan(t) / t;
  // The difference of two nearly equal numbers: t^2 / 3 - t^4 / 5 + ..., here to below 1e-17.
  double sum = 0, power = 1;
  for (int n = 1; n <= 8; n++) {
    power *= -t * t;
    sum -= power / (2 * n + 1);
  }
  return sum;
}

// The solution of the integral equation that is regular in the right half-plane, in closed form (Chandrasekhar 1950, chapter
// V; in this real form Stibbs & Weir 1959):
//   ln H(mu) = -1/pi int_0^inf ln(1 - W atan(t) / t) / (1 + v^2) dv,   t = v / mu.
// Over u = ln v the integrand is analytic in the strip |Im u| < pi/2 and falls off like exp(-|u|): the trapezoid rule of
// step h is good to exp(-pi^2 / h). No iteration, and no trouble where H behaves like mu ln mu or where W = 1.
double h_function(double albedo, double mu) {
  if (mu == 0)
    return 1;
  constexpr double step = 0.25;
  constexpr int reach = 160; // u = 40: exp(-40) is 4e-18
  double sum = 0;
  for (int i = -reach; i <= reach; i++) {
    const double v = std::exp(i * step);
    const double t = v / mu;
    const double loss = (1 - albedo) + albedo * arc_defect(t);
    sum += std::log(loss) * v / (1 + v * v);
  }
  return std::exp(-sum * step / pi);
}

void require_cosine(const char *name, double mu) {
  if (!(mu > 0 && mu <= 1))
    fail(TYN_ERROR_INVALID_ARGUMENT, "%s is %g; it must be in (0, 1]", name, mu);
}

} // namespace
} // namespace tyn

TynStatus tyn_chandrasekhar_h(double albedo, const double *mu, size_t count, double *h) {
  return tyn::guarded(nullptr, [&] {
    tyn::require_between("albedo", albedo, 0, 1);
    if (count == 0)
      return;
    tyn::require_pointer("mu", mu);
    tyn::require_pointer("h", h);
    for (size_t i = 0; i < count; i++)
      tyn::require_between("mu", mu[i], 0, 1);
    for (size_t i = 0; i < count; i++)
      h[i] = tyn::h_function(albedo, mu[i]);
  });
}

// The law of diffuse reflection, Chandrasekhar 1950, chapter III.
TynStatus tyn_half_space_brdf(double albedo, double mu_i, const double *mu_o, size_t count, double *brdf) {
  return tyn::guarded(nullptr, [&] {
    tyn::require_between("albedo", albedo, 0, 1);
    tyn::require_cosine("mu_i", mu_i);
    if (count == 0)
      return;
    tyn::require_pointer("mu_o", mu_o);
    tyn::require_pointer("brdf", brdf);
    for (size_t i = 0; i < count; i++)
      tyn::require_cosine("mu_o", mu_o[i]);
    const double h_i = tyn::h_function(albedo, mu_i);
    for (size_t i = 0; i < count; i++)
      brdf[i] = albedo / (4 * tyn::pi) * h_i * tyn::h_function(albedo, mu_o[i]) / (mu_i + mu_o[i]);
  });
}

TynStatus tyn_half_space_albedo(double albedo, double mu, double *directional_albedo) {
  return tyn::guarded(nullptr, [&] {
    tyn::require_between("albedo", albedo, 0, 1);
    tyn::require_cosine("mu", mu);
    tyn::require_pointer("directional_albedo", directional_albedo);
    *directional_albedo = 1 - tyn::h_function(albedo, mu) * std::sqrt(1 - albedo);
  });
}
