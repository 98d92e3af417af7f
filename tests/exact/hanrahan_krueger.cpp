// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "common/exact_slab.hpp"

using tyn_test::ExactSlab;
using tyn_test::integral;

namespace {

TynPhase forward(double g) {
  TynPhase phase = tyn_phase();
  phase.kind = TYN_PHASE_HENYEY_GREENSTEIN;
  phase.g = g;
  return phase;
}

double henyey_greenstein(double g, double cosine) {
  return (1 - g * g) / (4 * M_PI * std::pow(1 + g * g - 2 * g * cosine, 1.5));
}

struct Pair {
  double brdf = NAN, btdf = NAN;
};

Pair evaluate(const TynSingleScattering &layer, double mu_i, double mu_o, double azimuth) {
  Pair pair;
  EXPECT_EQ(tyn_hanrahan_krueger(&layer, mu_i, mu_o, azimuth, &pair.brdf, &pair.btdf), TYN_OK);
  return pair;
}

TynSingleScattering make(double albedo, double thickness, double ior, const TynPhase *phase) {
  TynSingleScattering layer = tyn_single_scattering();
  layer.albedo = albedo;
  layer.optical_thickness = thickness;
  layer.ior = ior;
  layer.phase = phase;
  return layer;
}

// 1 - F from the two polarizations' amplitudes in terms of angles
double transmittance(double ior, double mu) {
  const double in = std::acos(mu), out = std::asin(std::sin(in) / ior);
  if (in < 1e-8)
    return 4 * ior / ((1 + ior) * (1 + ior));
  const double s = std::sin(in - out) / std::sin(in + out), p = std::tan(in - out) / std::tan(in + out);
  return 1 - (s * s + p * p) / 2;
}

} // namespace

TEST(HanrahanKrueger, AMatchedHalfSpaceFollowsSeeligersLaw) {
  const TynPhase phase = forward(0.6);
  const TynSingleScattering layer = make(0.8, INFINITY, 1, &phase);
  const double sines = std::sqrt(0.75) * 0.6; // mu_i = 0.5, mu_o = 0.8
  for (double azimuth : {0.0, 1.0, M_PI}) {
    const double cosine = -sines * std::cos(azimuth) - 0.4;
    const Pair pair = evaluate(layer, 0.5, 0.8, azimuth);
    EXPECT_NEAR(pair.brdf, tyn_seeliger_brdf(0.8, henyey_greenstein(0.6, cosine), 0.5, 0.8), 1e-15);
    EXPECT_EQ(pair.btdf, 0);
  }
}

// The azimuth's convention: light and viewer at the same place see scattering straight back, those that face each other
// across the slab straight on.
TEST(HanrahanKrueger, StraightBackAndStraightOn) {
  const TynPhase phase = forward(0.6);
  const TynSingleScattering layer = make(1, 0.5, 1, &phase);
  EXPECT_NEAR(evaluate(layer, 0.5, 0.5, 0).brdf, henyey_greenstein(0.6, -1) * -std::expm1(-2), 1e-15);
  // tau / mu^2 exp(-tau / mu), in the limit of equal cosines
  EXPECT_NEAR(evaluate(layer, 0.5, 0.5, M_PI).btdf, henyey_greenstein(0.6, 1) * 2 * std::exp(-1), 1e-12);
}

// The definition: source in depth, attenuation, Fresnel, and radiance that spreads by n^2.
TEST(HanrahanKrueger, IsTheIntegralOverDepth) {
  const double tau = 1.7, ior = 1.4, azimuth = 0.7, mu_i = 0.6, mu_o = 0.9;
  const TynPhase phase = forward(-0.3);
  const double sin_i = 0.8 / ior, sin_o = std::sqrt(1 - 0.81) / ior;
  const double in = std::sqrt(1 - sin_i * sin_i), out = std::sqrt(1 - sin_o * sin_o);
  const double factor = transmittance(ior, mu_i) * transmittance(ior, mu_o) / (ior * ior);
  const double back = henyey_greenstein(-0.3, -sin_i * sin_o * std::cos(azimuth) - in * out);
  const double on = henyey_greenstein(-0.3, -sin_i * sin_o * std::cos(azimuth) + in * out);
  const double up = integral([&](double x) { return std::exp(-tau * x / in) / in * std::exp(-tau * x / out) / out; });
  const double down =
      integral([&](double x) { return std::exp(-tau * x / in) / in * std::exp(-tau * (1 - x) / out) / out; });
  const Pair pair = evaluate(make(0.9, tau, ior, &phase), mu_i, mu_o, azimuth);
  EXPECT_NEAR(pair.brdf, 0.9 * back * factor * tau * up, 1e-12);
  EXPECT_NEAR(pair.btdf, 0.9 * on * factor * tau * down, 1e-12);
}

TEST(HanrahanKrueger, IsReciprocalAndSmoothWhereTheCosinesMeet) {
  const TynSingleScattering layer = make(0.9, 3, 1.5, nullptr);
  const Pair a = evaluate(layer, 0.3, 0.8, 2), b = evaluate(layer, 0.8, 0.3, 2);
  EXPECT_NEAR(a.brdf, b.brdf, 1e-16);
  EXPECT_NEAR(a.btdf, b.btdf, 1e-16);
  const double equal = evaluate(layer, 0.5, 0.5, 0).btdf;
  EXPECT_NEAR(evaluate(layer, 0.5, 0.5 + 1e-9, 0).btdf / equal, 1, 1e-7);
  EXPECT_NEAR(evaluate(layer, 0.5, 0.5 - 1e-9, 0).btdf / equal, 1, 1e-7);
}

// Thin and dark: all but single scattering vanishes.
TEST(HanrahanKrueger, IsTheLimitOfAddingDoubling) {
  const double albedo = 1e-3, tau = 1e-3;
  const std::vector<double> cosines{0.1, 0.5, 0.9, 1.0};
  const TynPhase phase = forward(0.5);
  ExactSlab slab({{1 - albedo, albedo, 0.5, 1, tau}});
  slab.angle(1.0).tolerance(1e-10).cosines(cosines).solve();
  const TynSingleScattering layer = make(albedo, tau, 1, &phase);
  for (size_t i = 0; i < cosines.size(); i++) {
    constexpr int steps = 256; // the mean over azimuth
    Pair mean{0, 0};
    for (int k = 0; k < steps; k++) {
      const Pair pair = evaluate(layer, std::cos(1.0), cosines[i], 2 * M_PI * k / steps);
      mean.brdf += pair.brdf / steps;
      mean.btdf += pair.btdf / steps;
    }
    EXPECT_NEAR(slab.reflected[i] / (mean.brdf * cosines[i]), 1, 2e-5) << cosines[i];
    EXPECT_NEAR(slab.transmitted[i] / (mean.btdf * cosines[i]), 1, 2e-5) << cosines[i];
  }
}
