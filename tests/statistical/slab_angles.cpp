// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// R(angle) and T(angle) against closed forms and adding-doubling. With 90 bins of 4.5 standard errors each, a right program
// fails once in 1600 times; seeds are fixed.
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "common/slab_run.hpp"

namespace {

using namespace tyn_test;

constexpr double pi = 3.14159265358979324;
constexpr uint32_t bins = 30;

// The cosines at which a bin's mean over its solid angle is taken (Gauss, 3 points, in the cosine), bin after bin.
std::vector<double> bin_cosines() {
  const double node = std::sqrt(0.6);
  std::vector<double> cosines;
  for (uint32_t i = 0; i < bins; ++i) {
    const double a = std::cos((i + 1) * pi / 2 / bins), b = std::cos(i * pi / 2 / bins);
    for (double x : {-node, 0.0, node})
      cosines.push_back(0.5 * (a + b) + 0.5 * (b - a) * x);
  }
  return cosines;
}

double bin_mean(const std::vector<double> &values, uint32_t bin) {
  return (5 * values[3 * bin] + 8 * values[3 * bin + 1] + 5 * values[3 * bin + 2]) / 18;
}

void expect_angles(const SlabOutcome &outcome, uint32_t quantity, const std::vector<double> &expected,
                   double tolerance = 1e-6) {
  for (uint32_t i = 0; i < bins; ++i)
    EXPECT_NEAR(outcome.value(quantity)[i], bin_mean(expected, i),
                4.5 * outcome.error(quantity)[i] + tolerance + 2e-3 * bin_mean(expected, i) * (i + 1 == bins))
        << "bin " << i;
}

SlabOutcome run(const ExactSlab &slab, double angle, uint64_t seed, uint32_t max_order = 0) {
  TynSlabOptions options = slab_options(4000000, seed);
  options.angle = angle;
  options.angular_bins = bins;
  options.max_order = max_order;
  return simulate(slab.view(), options);
}

TEST(SlabAngles, OfTheIsotropicHalfSpaceFollowChandrasekhar) {
  for (double angle : {0.0, 1.0}) {
    ExactSlab slab({{1, 9, 0, 1, INFINITY}});
    const std::vector<double> cosines = bin_cosines();
    std::vector<double> expected(cosines.size());
    ASSERT_EQ(tyn_half_space_brdf(0.9, std::cos(angle), cosines.data(), cosines.size(), expected.data()), TYN_OK);
    for (size_t i = 0; i < cosines.size(); ++i)
      expected[i] *= cosines[i];
    expect_angles(run(slab, angle, 11), TYN_SLAB_ANGULAR_REFLECTANCE, expected);
  }
}

TEST(SlabAngles, OfALayeredDielectricFollowAddingDoubling) {
  ExactSlab slab({{0.2, 4, 0.6, 1.4, 0.5}, {0.5, 3, -0.3, 1.3, 0.4}}, 1, 1.5);
  slab.angle(0.7).cosines(bin_cosines()).solve();
  const SlabOutcome outcome = run(slab, 0.7, 12);
  expect_angles(outcome, TYN_SLAB_ANGULAR_REFLECTANCE, slab.reflected, 1e-5);
  // below, total reflection cuts the range of angles in the middle of a bin: that one is left out
  const std::vector<double> &value = outcome.value(TYN_SLAB_ANGULAR_TRANSMITTANCE);
  const std::vector<double> &error = outcome.error(TYN_SLAB_ANGULAR_TRANSMITTANCE);
  for (uint32_t i = 0; i < bins; ++i) {
    const double low = i * pi / 2 / bins, high = (i + 1) * pi / 2 / bins, edge = std::asin(1.3 / 1.5);
    if (low < edge && high > edge)
      continue;
    EXPECT_NEAR(value[i], bin_mean(slab.transmitted, i), 4.5 * error[i] + 2e-5 + 0.01 * value[i] * (high > 0.9 * edge))
        << "bin " << i;
  }
}

// Scattering order 1 alone: Seeliger's law.
TEST(SlabAngles, OfTheFirstOrderFollowSeeliger) {
  ExactSlab slab({{1, 4, 0, 1, INFINITY}});
  std::vector<double> expected;
  for (double mu : bin_cosines())
    expected.push_back(mu * tyn_seeliger_brdf(0.8, 1 / (4 * pi), 1, mu));
  const SlabOutcome outcome = run(slab, 0, 13, 1);
  expect_angles(outcome, TYN_SLAB_ANGULAR_REFLECTANCE, expected);
  // integrated: W / 2 (1 - ln 2)
  EXPECT_LT(std::abs(deviation(outcome.totals[0].diffuse_reflectance, 0.4 * (1 - std::log(2.0)))), 4);
  EXPECT_GT(outcome.totals[0].cut.value, 0.1);
}

// With a refracting boundary and a forward phase function: Hanrahan and Krueger. In a half-space what the boundary reflects back
// inside after one scattering event does not come out without another.
TEST(SlabAngles, OfTheFirstOrderFollowHanrahanAndKrueger) {
  ExactSlab slab({{1, 4, 0.5, 1.4, INFINITY}});
  TynPhase phase = tyn_phase();
  phase.kind = TYN_PHASE_HENYEY_GREENSTEIN;
  phase.g = 0.5;
  TynSingleScattering layer = tyn_single_scattering();
  layer.albedo = 0.8;
  layer.ior = 1.4;
  layer.phase = &phase;
  const double angle = 0.6;
  std::vector<double> expected;
  for (double mu : bin_cosines()) {
    double mean = 0;
    const int steps = 64; // of azimuth: the trapezoidal rule, exact for periodic functions
    for (int i = 0; i < steps; ++i) {
      double brdf = 0;
      ASSERT_EQ(tyn_hanrahan_krueger(&layer, std::cos(angle), mu, 2 * pi * i / steps, &brdf, nullptr), TYN_OK);
      mean += brdf / steps;
    }
    expected.push_back(mu * mean);
  }
  expect_angles(run(slab, angle, 14, 1), TYN_SLAB_ANGULAR_REFLECTANCE, expected);
}

} // namespace
