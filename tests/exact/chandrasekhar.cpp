// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// H(mu) and the isotropic half-space against Chandrasekhar 1950.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "common/exact_slab.hpp"

using tyn_test::integral;

namespace {

constexpr double albedos[] = {1e-3, 0.1, 0.5, 0.9, 0.99, 0.999999, 1.0};

double h_of(double albedo, double mu) {
  double h = NAN;
  EXPECT_EQ(tyn_chandrasekhar_h(albedo, &mu, 1, &h), TYN_OK);
  return h;
}

} // namespace

// Table XI, W = 1.
TEST(Chandrasekhar, PublishedValues) {
  EXPECT_NEAR(h_of(1, 0.1), 1.24735, 5e-6);
  EXPECT_NEAR(h_of(1, 0.2), 1.45035, 5e-6);
  EXPECT_NEAR(h_of(1, 0.5), 2.01278, 5e-6);
  EXPECT_NEAR(h_of(1, 1.0), 2.90781, 5e-6);
}

TEST(Chandrasekhar, WithoutScatteringAndAtTheHorizonItIsOne) {
  EXPECT_EQ(h_of(0, 0.7), 1);
  EXPECT_EQ(h_of(1, 0), 1);
  EXPECT_NEAR(h_of(1, 1e-300), 1, 1e-15);
}

// 1 / H(mu) = sqrt(1 - W) + W/2 int_0^1 x H(x) / (mu + x) dx
TEST(Chandrasekhar, SolvesTheIntegralEquation) {
  for (double albedo : albedos)
    for (double mu : {1e-6, 1e-3, 0.03, 0.3, 0.7, 1.0}) {
      const double sum = integral([&](double x) { return x * h_of(albedo, x) / (mu + x); });
      EXPECT_NEAR(h_of(albedo, mu) * (std::sqrt(1 - albedo) + albedo / 2 * sum), 1, 1e-12) << albedo << " " << mu;
    }
}

// Chapter V: alpha_0 = 2/W (1 - sqrt(1 - W)); alpha_1 = 2/sqrt(3) for W = 1.
TEST(Chandrasekhar, Moments) {
  for (double albedo : albedos) {
    const double zeroth = integral([&](double x) { return h_of(albedo, x); });
    EXPECT_NEAR(zeroth, 2 / (1 + std::sqrt(1 - albedo)), 1e-12) << albedo;
  }
  EXPECT_NEAR(integral([](double x) { return x * h_of(1, x); }), 2 / std::sqrt(3.0), 1e-12);
}

TEST(Chandrasekhar, TheDirectionalAlbedoIsTheIntegralOfTheBrdf) {
  for (double albedo : albedos)
    for (double mu : {0.01, 0.4, 1.0}) {
      const double sum = integral([&](double x) {
        double brdf = NAN;
        EXPECT_EQ(tyn_half_space_brdf(albedo, mu, &x, 1, &brdf), TYN_OK);
        return 2 * M_PI * brdf * x;
      });
      double directional = NAN;
      ASSERT_EQ(tyn_half_space_albedo(albedo, mu, &directional), TYN_OK);
      EXPECT_NEAR(directional, sum, 1e-12) << albedo << " " << mu;
    }
}
