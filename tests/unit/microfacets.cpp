// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// GGX microfacets: the distribution of normals, its projections and its samples, against quadrature.
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/opencl_shim.hpp"
#include "common/statistics.hpp"

namespace {

using namespace tyn_kernel;

const double pi = 3.14159265358979324;

// Coordinates for normals in which GGX is uniform: s = tan^2 / (tan^2 + alpha^2) and phi. With them D(m) cos(m) dm =
// ds dphi / (2 pi), by the integral of eq. 33 of Walter et al. 2007.
float3 normal_at(double s, double phi, double alpha) {
  double tan2 = alpha * alpha * s / (1 - s);
  double z = 1 / std::sqrt(1 + tan2), r = std::sqrt(tan2) * z;
  return tyn_vec3(static_cast<float>(r * std::cos(phi)), static_cast<float>(r * std::sin(phi)), static_cast<float>(z));
}

float3 direction_at(double angle) {
  return tyn_vec3(static_cast<float>(std::sin(angle)), 0.0f, static_cast<float>(std::cos(angle)));
}

class Ggx : public testing::TestWithParam<float> {};

// Trapezoid in cos(theta) by substitution, with nothing of the distribution assumed beyond where it is wide.
TEST_P(Ggx, NormalsCoverTheSurfaceOnce) {
  const float alpha = GetParam();
  const int n = 200000;
  double sum = 0;
  for (int i = 0; i < n; ++i) {
    double theta = 0.5 * pi * std::pow((i + 0.5) / n, 3); // dense near the normal, where small alphas live
    double width = 0.5 * pi * 3 * std::pow((i + 0.5) / n, 2) / n;
    sum += 2 * pi * std::sin(theta) * std::cos(theta) * width * tyn_ggx_d(direction_at(theta), alpha);
  }
  EXPECT_NEAR(sum, 1, 2e-5);
}

TEST_P(Ggx, ProjectedAreaIsTheIntegralOverVisibleNormals) {
  const float alpha = GetParam();
  const int n = 1000;
  for (double degrees : {0.0, 20.0, 60.0, 85.0, 89.9, 90.0, 95.0, 120.0, 160.0}) {
    float3 v = direction_at(degrees * pi / 180);
    double sum = 0;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        // s = 1 - t^2 resolves the flat normals, whose projected area is large
        double t = (i + 0.5) / n;
        float3 m = normal_at(1 - t * t, pi * (j + 0.5) / n, alpha);
        sum += 2 * t * std::fmax(0.0f, tyn_dot(v, m)) / m.z;
      }
    sum /= double(n) * n;
    EXPECT_NEAR(tyn_ggx_sigma(v, alpha), sum, 2e-3 * sum + 1e-6) << degrees;
  }
}

// The view from above less the view from below is the surface's own projection.
TEST_P(Ggx, ProjectedAreasDifferByTheCosine) {
  for (double degrees : {5.0, 45.0, 80.0, 89.0}) {
    float3 v = direction_at(degrees * pi / 180);
    EXPECT_NEAR(tyn_ggx_sigma(v, GetParam()) - tyn_ggx_sigma(-v, GetParam()), v.z, 1e-6) << degrees;
  }
}

TEST_P(Ggx, MaskingIsSmiths) {
  for (double degrees : {0.0, 30.0, 60.0, 85.0, 89.9}) {
    double tangent = std::tan(degrees * pi / 180), alpha = GetParam();
    double exact = 2 / (1 + std::sqrt(1 + alpha * alpha * tangent * tangent)); // Walter et al. 2007, eq. 34
    EXPECT_NEAR(tyn_ggx_g1(direction_at(degrees * pi / 180), GetParam()), exact, 1e-4 * exact) << degrees;
    EXPECT_EQ(tyn_ggx_g1(direction_at(pi - degrees * pi / 180), GetParam()), 0.0f) << degrees;
  }
}

// Counts over 12 x 12 bins in s and phi; the expectation by 16 x 16 midpoints in each bin.
double visible_normals_fit(double degrees, float alpha, int samples) {
  const int bins = 12, sub = 16;
  float3 v = direction_at(degrees * pi / 180);
  std::vector<double> observed(bins * bins), expected(bins * bins);
  for (int i = 0; i < bins * sub; ++i)
    for (int j = 0; j < bins * sub; ++j) {
      double t = (i + 0.5) / (bins * sub);
      float3 m = normal_at(1 - t * t, 2 * pi * (j + 0.5) / (bins * sub), alpha);
      expected[size_t(i / sub * bins + j / sub)] += 2 * t * std::fmax(0.0f, tyn_dot(v, m)) / m.z;
    }
  for (double &e : expected)
    e *= samples / (double(bins * sub) * (bins * sub)) / tyn_ggx_sigma(v, alpha);

  std::mt19937 random(11);
  auto uniform = [&] { return tyn_uniform(static_cast<uint>(random())); };
  for (int k = 0; k < samples; ++k) {
    float u0 = uniform(), u1 = uniform();
    float3 m = tyn_ggx_sample_visible(v, alpha, u0, u1);
    double tan2 = (double(m.x) * m.x + double(m.y) * m.y) / (double(m.z) * m.z);
    double t = std::sqrt(double(alpha) * alpha / (tan2 + double(alpha) * alpha));
    double phi = std::atan2(m.y, m.x) / (2 * pi);
    int i = std::min(bins - 1, int(t * bins)), j = std::min(bins - 1, int((phi < 0 ? phi + 1 : phi) * bins));
    observed[size_t(i * bins + j)] += 1;
  }
  return tyn_test::chi_square_test(observed, expected);
}

// N = 2e5 for each of six directions; false-alarm rate 1e-4 each.
TEST_P(Ggx, SamplesFollowTheVisibleNormals) {
  for (double degrees : {0.0, 30.0, 70.0, 88.0, 100.0, 150.0}) {
    // steeply from below, a nearly flat surface shows 1e-5 of itself, the rounding of the cap's height; no light gets there
    if (GetParam() < 0.05f && degrees > 120)
      continue;
    EXPECT_GT(visible_normals_fit(degrees, GetParam(), 200000), 1e-4) << degrees;
  }
}

INSTANTIATE_TEST_SUITE_P(ForAllRoughnesses, Ggx, testing::Values(0.01f, 0.1f, 0.4f, 1.0f), [](const auto &parameter) {
  return "Alpha" + std::to_string(int(std::lround(parameter.param * 1000))) + "Thousandths";
});

} // namespace
