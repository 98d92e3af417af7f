// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Draws from phase functions follow their densities; the seeds are fixed.
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "common/phases.hpp"

namespace {

using namespace tyn_test;

std::vector<double> sample(const TynPhase &phase, uint64_t seed, uint64_t first, size_t count) {
  std::vector<double> cosines(count);
  EXPECT_EQ(tyn_phase_sample(&phase, seed, first, count, cosines.data()), TYN_OK);
  return cosines;
}

class PhaseSamples : public testing::TestWithParam<PhaseCase> {
protected:
  const tyn::OwnedPhase owned = GetParam().make();
  const TynPhase &phase = owned.get();
};

// N = 1e6 in 100 bins of about equal share; false-alarm rate 1e-4 each.
TEST_P(PhaseSamples, FollowTheDensity) { EXPECT_GT(PhaseBins(phase, 100).test(sample(phase, 7, 0, 1000000)), 1e-4); }

// The mean of 1e6 cosines within four standard errors, false-alarm rate 6e-5 each.
TEST_P(PhaseSamples, HaveTheMeanCosine) {
  double moments[3], sum = 0;
  ASSERT_EQ(tyn_phase_moments(&phase, 3, moments), TYN_OK);
  const double variance = (1 + 2 * moments[2]) / 3 - moments[1] * moments[1];
  for (double cosine : sample(phase, 8, 0, 1000000))
    sum += cosine;
  EXPECT_NEAR(sum / 1e6, moments[1], 4 * std::sqrt(variance / 1e6));
}

TEST_P(PhaseSamples, AreCosinesThatDependOnTheirNumberAlone) {
  const std::vector<double> whole = sample(phase, 9, (uint64_t(1) << 32) - 50, 100);
  const std::vector<double> part = sample(phase, 9, uint64_t(1) << 32, 50);
  for (size_t i = 0; i < 50; i++)
    EXPECT_EQ(whole[50 + i], part[i]);
  EXPECT_NE(sample(phase, 10, 0, 50), sample(phase, 9, 0, 50));
  for (double cosine : whole)
    EXPECT_LE(std::abs(cosine), 1.0);
}

INSTANTIATE_TEST_SUITE_P(OfAllKinds, PhaseSamples, testing::ValuesIn(phase_cases()),
                         [](const auto &parameter) { return parameter.param.name; });

// A diffraction peak 1e-5 wide: a float cosine is 1 or 1 - 6e-8 there, which is an angle of 3.5e-4. The share of 1e6 draws within
// 4.5e-5 is right to four standard errors and the 0.2 % that floats of the table cost, and they are not a few angles only.
TEST(PhaseSample, ResolvesAnglesFarBelowTheRoundingOfACosine) {
  const tyn::OwnedPhase phase = mie_phase(1e5, 1.33, 0, 20000);
  size_t within = 0;
  std::vector<double> distinct;
  for (double cosine : sample(phase.get(), 11, 0, 1000000))
    if (1 - cosine < 1e-9) {
      within++;
      distinct.push_back(1 - cosine);
    }
  const double share = phase_integral(phase.get(), [](double c) { return 1 - c < 1e-9 ? 1.0 : 0.0; });
  EXPECT_NEAR(double(within), 1e6 * share, 4 * std::sqrt(1e6 * share) + 1e6 * 0.002);
  std::sort(distinct.begin(), distinct.end());
  distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
  EXPECT_GT(distinct.size(), 100000u);
}

} // namespace
