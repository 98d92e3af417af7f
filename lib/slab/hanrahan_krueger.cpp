// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Single scattering in a finite slab (Hanrahan & Krueger 1993, the first-order terms).
#include <cmath>

#include "core/context.hpp"
#include "core/input.hpp"
#include "media/fresnel.hpp"
#include "slab/nodes.hpp"
#include "core/pi.hpp"
#include "tyndall/tyndall_exact.h"

namespace tyn {
namespace {

// A direction outside and its refraction.
struct Refracted {
  double mu, sine;      // inside
  double transmittance; // 1 - F
};

Refracted refract(double ior, double mu) {
  return {cosine_in({1, mu}, ior), std::sqrt((1 - mu) * (1 + mu)) / ior, 1 - fresnel_reflectance(mu, ior)};
}

TynSingleScattering read(const TynSingleScattering *given) {
  const TynSingleScattering layer = read_struct("TynSingleScattering", given, tyn_single_scattering());
  require_between("albedo", layer.albedo, 0, 1);
  if (!(layer.optical_thickness > 0))
    fail(TYN_ERROR_INVALID_ARGUMENT, "optical_thickness is %g; it must be > 0", layer.optical_thickness);
  require_between("ior", layer.ior, 1, 4);
  return layer;
}

double phase_value(const TynPhase *phase, double cosine) {
  if (!phase)
    return 1 / (4 * pi);
  double value = 0;
  const TynStatus status = tyn_phase_value(phase, &cosine, 1, &value);
  if (status != TYN_OK)
    fail(status, "phase is not a valid phase function");
  return value;
}

double clamped(double cosine) { return std::fmin(std::fmax(cosine, -1.0), 1.0); }

// int_0^tau exp(-t / mu_i) exp(-t / mu_o) dt / (mu_i mu_o)
double returned(double tau, double mu_i, double mu_o) {
  return -std::expm1(-tau * (1 / mu_i + 1 / mu_o)) / (mu_i + mu_o);
}

// int_0^tau exp(-t / mu_i) exp(-(tau - t) / mu_o) dt / (mu_i mu_o) = (exp(-tau / mu_i) - exp(-tau / mu_o)) / (mu_i - mu_o):
// symmetric, and tau / mu^2 exp(-tau / mu) where the two are equal.
double passed(double tau, double mu_i, double mu_o) {
  if (std::isinf(tau))
    return 0;
  const double steeper = std::fmax(mu_i, mu_o);
  const double difference = 1 / std::fmin(mu_i, mu_o) - 1 / steeper;
  const double length = difference > 0 ? -std::expm1(-tau * difference) / difference : tau;
  return std::exp(-tau / steeper) * length / (mu_i * mu_o);
}

} // namespace
} // namespace tyn

// The flux T(mu_i) E that gets in is a beam of T(mu_i) E / mu_i' across itself; it leaves W p of that per optical depth, of
// which T(mu_o) gets out, where radiance falls by 1 / ior^2 as the same flux fills a wider cone.
TynStatus tyn_hanrahan_krueger(const TynSingleScattering *given, double mu_i, double mu_o, double azimuth, double *brdf,
                               double *btdf) {
  return tyn::guarded(nullptr, [&] {
    const TynSingleScattering layer = tyn::read(given);
    tyn::require_positive("mu_i", mu_i);
    tyn::require_positive("mu_o", mu_o);
    tyn::require_between("mu_i", mu_i, 0, 1);
    tyn::require_between("mu_o", mu_o, 0, 1);
    tyn::require_finite("azimuth", azimuth);

    const tyn::Refracted in = tyn::refract(layer.ior, mu_i), out = tyn::refract(layer.ior, mu_o);
    // The light travels away from the azimuth that it comes from.
    const double sideways = -in.sine * out.sine * std::cos(azimuth);
    const double up = tyn::phase_value(layer.phase, tyn::clamped(sideways - in.mu * out.mu));
    const double down = tyn::phase_value(layer.phase, tyn::clamped(sideways + in.mu * out.mu));
    const double factor = layer.albedo * in.transmittance * out.transmittance / (layer.ior * layer.ior);
    if (brdf)
      *brdf = factor * up * tyn::returned(layer.optical_thickness, in.mu, out.mu);
    if (btdf)
      *btdf = factor * down * tyn::passed(layer.optical_thickness, in.mu, out.mu);
  });
}
