// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The slab engine against published and exact totals at 1e8 photons: within 3 standard errors. Each comparison is exceeded by
// chance once in 370 times; the seeds are fixed.
#include <cmath>

#include <gtest/gtest.h>

#include "common/slab_run.hpp"

namespace {

using namespace tyn_test;

constexpr uint64_t photons = 100000000;

// van de Hulst 1980 (0.09739, 0.66096), with the digits of an independent exact solver.
TEST(PublishedSlab, OfVanDeHulst) {
  ExactSlab slab({{1, 9, 0.75, 1, 0.2}});
  const TynSlabTotals totals = simulate(slab.view(), slab_options(photons, 1)).totals[0];
  EXPECT_LT(std::abs(deviation(totals.reflectance, 0.097395)), 3);
  EXPECT_LT(std::abs(deviation(totals.transmittance, 0.660958)), 3);
  EXPECT_LT(std::abs(deviation(totals.direct_transmittance, std::exp(-2.0))), 3);
  EXPECT_LT(totals.reflectance.standard_error, 3e-5);
}

// Giovanelli 1955 (0.2600), the specular 0.04 included.
TEST(PublishedSlab, OfGiovanelli) {
  ExactSlab slab({{1, 9, 0, 1.5, INFINITY}});
  const TynSlabTotals totals = simulate(slab.view(), slab_options(photons, 2)).totals[0];
  EXPECT_LT(std::abs(deviation(totals.reflectance, 0.259919)), 3);
  EXPECT_NEAR(totals.specular_reflectance.value, 0.04, 1e-7);
  EXPECT_LT(totals.reflectance.standard_error, 4e-5);
}

TEST(PublishedSlab, OfGiovanelliUnderDiffuseLight) {
  ExactSlab slab({{1, 9, 0, 1.5, INFINITY}});
  TynSlabOptions options = slab_options(photons / 2, 3);
  options.incidence = TYN_INCIDENCE_DIFFUSE;
  const TynSlabTotals totals = simulate(slab.view(), options).totals[0];
  EXPECT_LT(std::abs(deviation(totals.reflectance, 0.307890)), 3);
}

} // namespace
