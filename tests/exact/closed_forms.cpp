// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "common/exact_slab.hpp"

using tyn_test::integral;

TEST(ClosedForms, ReducedIntensity) {
  EXPECT_DOUBLE_EQ(tyn_reduced_intensity(1, 1), 0.36787944117144233);
  EXPECT_DOUBLE_EQ(tyn_reduced_intensity(1, 0.5), 0.1353352832366127);
  EXPECT_EQ(tyn_reduced_intensity(0, 0.3), 1);
  EXPECT_EQ(tyn_reduced_intensity(INFINITY, 0.3), 0);
}

TEST(ClosedForms, EffectiveSource) {
  EXPECT_DOUBLE_EQ(tyn_effective_source(0.5, 0.1, 2, 0.5), 0.05 * std::exp(-4.0));
  EXPECT_EQ(tyn_effective_source(0, 0.1, 2, 0.5), 0);
}

// Light of unit irradiance on the surface is 1 / mu_i across the beam; the source is seen through exp(-tau / mu_o).
TEST(ClosedForms, SeeligersLawIsTheEffectiveSourceSeenFromOutside) {
  for (double mu_i : {0.1, 0.5, 1.0})
    for (double mu_o : {0.2, 1.0}) {
      const double sum = integral([&](double x) { // tau = x / (1 - x)
        const double tau = x / (1 - x);
        return tyn_effective_source(0.7, 0.05, tau, mu_i) / mu_i * tyn_reduced_intensity(tau, mu_o) / mu_o /
               ((1 - x) * (1 - x));
      });
      EXPECT_NEAR(tyn_seeliger_brdf(0.7, 0.05, mu_i, mu_o), sum, 1e-13);
    }
}

TEST(ClosedForms, SeeligersLawByHand) { EXPECT_DOUBLE_EQ(tyn_seeliger_brdf(0.8, 0.25, 0.5, 0.3), 0.25); }
