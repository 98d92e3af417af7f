// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// One run for a whole sweep: every row against adding-doubling, within 4 standard errors (once in 16 000 times by chance, 100
// comparisons).
#include <cmath>

#include <gtest/gtest.h>

#include "common/slab_run.hpp"

namespace {

using namespace tyn_test;

void expect_row(const SlabOutcome &outcome, size_t row, const TynAddingDoublingResult &exact) {
  const double expected[3] = {exact.reflectance, exact.transmittance, exact.absorbed};
  for (uint32_t i = 0; i < 3; ++i) {
    const double value = outcome.value(TYN_SLAB_SWEEP_REFLECTANCE + i)[row];
    const double error = outcome.error(TYN_SLAB_SWEEP_REFLECTANCE + i)[row];
    EXPECT_NEAR(value, expected[i], 4 * error + 2e-6) << "row " << row << " quantity " << i;
    EXPECT_LT(error, 2e-3) << row;
  }
}

TEST(SlabSweep, OfAlbedosInAHalfSpace) {
  ExactSlab slab({{0.001, 0.999, 0.3, 1.4, INFINITY}});
  std::vector<double> sigma_a, sigma_s;
  for (double albedo : {0.0, 0.01, 0.1, 0.3, 0.5, 0.7, 0.8, 0.9, 0.95, 0.98, 0.99, 0.995, 0.999}) {
    sigma_s.push_back(albedo);
    sigma_a.push_back(1 - albedo);
  }
  TynSlabOptions options = slab_options(2000000, 21);
  options.sweep_count = uint32_t(sigma_a.size());
  options.sweep_sigma_a = sigma_a.data();
  options.sweep_sigma_s = sigma_s.data();
  const SlabOutcome outcome = simulate(slab.view(), options);
  for (size_t row = 0; row < sigma_a.size(); ++row) {
    ExactSlab other({{sigma_a[row], sigma_s[row], 0.3, 1.4, INFINITY}});
    expect_row(outcome, row, other.solve());
  }
  // the last row is the slab itself, from the same photons
  EXPECT_NEAR(outcome.value(TYN_SLAB_SWEEP_REFLECTANCE).back(), outcome.totals[0].reflectance.value, 1e-6);
}

TEST(SlabSweep, OfAbsorptionInAStack) {
  ExactSlab slab({{0, 3, 0.5, 1.4, 0.4}, {0.1, 5, -0.2, 1, 0.5}}, 1, 1.3);
  const double levels[] = {0, 0.01, 0.1, 1, 10};
  std::vector<double> sigma_a, sigma_s;
  for (double level : levels) {
    sigma_a.insert(sigma_a.end(), {level, 0.1 + 2 * level});
    sigma_s.insert(sigma_s.end(), {3, 5});
  }
  TynSlabOptions options = slab_options(2000000, 22);
  options.sweep_count = 5;
  options.sweep_sigma_a = sigma_a.data();
  options.sweep_sigma_s = sigma_s.data();
  const SlabOutcome outcome = simulate(slab.view(), options);
  for (size_t row = 0; row < 5; ++row) {
    ExactSlab other({{levels[row], 3, 0.5, 1.4, 0.4}, {0.1 + 2 * levels[row], 5, -0.2, 1, 0.5}}, 1, 1.3);
    expect_row(outcome, row, other.solve());
  }
}

TEST(SlabSweep, UnderDiffuseLight) {
  ExactSlab slab({{0.1, 0.9, 0, 1.5, 2}});
  const double sigma_a[] = {0.1, 0.5}, sigma_s[] = {0.9, 0.5};
  TynSlabOptions options = slab_options(1000000, 23);
  options.incidence = TYN_INCIDENCE_DIFFUSE;
  options.sweep_count = 2;
  options.sweep_sigma_a = sigma_a;
  options.sweep_sigma_s = sigma_s;
  const SlabOutcome outcome = simulate(slab.view(), options);
  for (size_t row = 0; row < 2; ++row) {
    ExactSlab other({{sigma_a[row], sigma_s[row], 0, 1.5, 2}});
    expect_row(outcome, row, other.diffuse().solve());
  }
}

} // namespace
