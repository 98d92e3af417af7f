// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Henyey and Greenstein's phase function against its closed forms.
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "core/opencl_shim.hpp"
#include "common/statistics.hpp"

namespace {

using namespace tyn_kernel;

class HenyeyGreenstein : public testing::TestWithParam<float> {};

// The share of deflections with cosine below c (the integral of the phase function over the sphere's cap).
double distribution(double c, double g) {
  if (g == 0)
    return 0.5 * (1 + c);
  return (1 - g * g) / (2 * g) * (1 / std::sqrt(1 + g * g - 2 * g * c) - 1 / (1 + g));
}

// The cosine below which the share p lies: the inverse of the above.
double quantile(double p, double g) {
  if (g == 0)
    return 2 * p - 1;
  double s = (1 - g * g) / (2 * g * p + 1 - g);
  return (1 + g * g - s * s) / (2 * g);
}

// A quadrature whose nodes follow the peak: the midpoints of shares of equal size.
TEST_P(HenyeyGreenstein, ValueIntegratesToOne) {
  const double pi = 3.14159265358979324;
  const double g = GetParam();
  const int n = 20000;
  double integral = 0;
  for (int i = 0; i < n; ++i) {
    double width = quantile((i + 1.0) / n, g) - quantile(double(i) / n, g);
    integral += 2 * pi * width * tyn_hg_value(static_cast<float>(quantile((i + 0.5) / n, g)), GetParam());
  }
  EXPECT_NEAR(integral, 1, 2e-6 / (1 - std::abs(g)));
}

// Over every number that lane_uniform can give: a sum, not an estimate.
TEST_P(HenyeyGreenstein, MeanCosineIsG) {
  const double g = GetParam();
  const uint n = 1u << 23;
  double sum = 0;
  for (uint i = 0; i < n; ++i)
    sum += lane_hg_one_minus_cos(lane_uniform(i << 9), GetParam());
  EXPECT_NEAR(sum / n, 1 - g, 2e-6 * (1 - g));
}

TEST_P(HenyeyGreenstein, SamplesInvertTheDistribution) {
  const double g = GetParam();
  std::mt19937 random(5);
  for (int i = 0; i < 200000; ++i) {
    float u = tyn_uniform(static_cast<uint>(random()));
    float away = lane_hg_one_minus_cos(u, GetParam());
    ASSERT_GE(away, 0.0f);
    ASSERT_LE(away, 2.0f + 0x1p-20f); // walk.cl takes sqrt(max(0, away (2 - away)))
    // the formula in double with the form that does not cancel; u counts from the forward direction
    double y = 2.0 * u, k = (1 - g) / (1 + g - g * y);
    double exact = 0.5 * y * (2 + 2 * g - g * y) * k * k;
    ASSERT_NEAR(away, exact, exact * (5e-7 + 3e-7 / (1 - std::abs(g)))) << u;
  }
}

// N = 1e6 in 100 bins of equal share, by the distribution above; false-alarm rate 1e-4 for each g. At g = -0.99 N = 2e4: a
// float near 2 resolves the backward peak, 5e-5 wide, to half a per cent, which more samples would show.
TEST_P(HenyeyGreenstein, SamplesFollowTheDensity) {
  const double g = GetParam();
  std::mt19937 random(6);
  const int n = g < -0.95 ? 20000 : 1000000;
  std::vector<double> observed(100), expected(100, n / 100.0);
  for (int i = 0; i < n; ++i) {
    double away = lane_hg_one_minus_cos(tyn_uniform(static_cast<uint>(random())), GetParam());
    double share = distribution(1 - away, g);
    observed[std::min<size_t>(99, static_cast<size_t>(std::max(0.0, share) * 100))] += 1;
  }
  EXPECT_GT(tyn_test::chi_square_test(observed, expected), 1e-4);
}

std::string test_name(const testing::TestParamInfo<float> &info) {
  std::string sign = info.param < 0 ? "Minus" : "";
  return "G" + sign + std::to_string(static_cast<int>(std::lround(std::abs(info.param) * 1000))) + "Thousandths";
}

INSTANTIATE_TEST_SUITE_P(ForAllAnisotropies, HenyeyGreenstein,
                         testing::Values(-0.99f, -0.9f, -0.5f, -0.1f, -1e-3f, 0.0f, 1e-3f, 0.1f, 0.5f, 0.8f, 0.95f,
                                         0.99f),
                         test_name);

} // namespace
