// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The error bounds that kernels/lane_math.clh states, against libm in double precision.
#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "core/opencl_shim.hpp"

namespace {

using namespace tyn_kernel;

double ulp(double value) {
  float nearest = std::fabs(static_cast<float>(value));
  return std::nextafter(nearest, INFINITY) - double(nearest);
}

// Error of lane_log over what is allowed.
double log_error(float x) {
  double exact = std::log(double(x));
  return std::abs(lane_log(x) - exact) / std::max(2 * ulp(exact), 1e-7);
}

double exp_error_in_ulp(float x) {
  double exact = std::exp(double(x));
  return std::abs(lane_exp(x) - exact) / ulp(exact);
}

TEST(LaneLog, KeepsItsBoundOverAllExponents) {
  double worst = 0;
  for (uint32_t bits = 0x00800000u; bits <= 0x7f000000u; bits += 1021)
    worst = std::max(worst, log_error(as_float(bits)));
  EXPECT_LT(worst, 1) << "of the bound of 2 ulp or 1e-7";
}

TEST(LaneLog, KeepsItsBoundAroundOne) {
  double worst = 0;
  for (uint32_t bits = as_uint(0.5f); bits <= as_uint(2.0f); bits += 13)
    worst = std::max(worst, log_error(as_float(bits)));
  EXPECT_LT(worst, 1);
  EXPECT_EQ(lane_log(1.0f), 0.0f);
}

TEST(LaneLog, KeepsItsBoundAtRandomArguments) {
  std::mt19937 random(1);
  std::uniform_int_distribution<uint32_t> bits(0x00800000u, 0x7f000000u);
  double worst = 0;
  for (int i = 0; i < 1000000; ++i)
    worst = std::max(worst, log_error(as_float(bits(random))));
  EXPECT_LT(worst, 1);
}

TEST(LaneLog, OfEveryUniformNumberIsAFiniteFreeFlight) {
  for (uint32_t bits : {0u, 1u, 511u, 0x7fffffffu, 0xfffffffeu, 0xffffffffu}) {
    float flight = -lane_log(lane_uniform_fine(bits));
    EXPECT_TRUE(std::isfinite(flight)) << bits;
    EXPECT_GE(flight, 0.0f) << bits;
  }
  EXPECT_NEAR(-lane_log(lane_uniform_fine(0)), 33 * std::log(2.0), 1e-5);
}

TEST(LaneExp, KeepsItsBoundOverItsRange) {
  double worst = 0;
  for (int i = 0; i <= 2000000; ++i)
    worst = std::max(worst, exp_error_in_ulp(-87.0f * static_cast<float>(i) / 2000000.0f));
  EXPECT_LT(worst, 2);
}

TEST(LaneExp, KeepsItsBoundAtRandomArgumentsOfAllMagnitudes) {
  std::mt19937 random(2);
  std::uniform_int_distribution<uint32_t> bits(as_uint(1e-30f), as_uint(87.0f));
  double worst = 0;
  for (int i = 0; i < 1000000; ++i)
    worst = std::max(worst, exp_error_in_ulp(-as_float(bits(random))));
  EXPECT_LT(worst, 2);
}

TEST(LaneExp, IsOneAtZeroAndZeroFarOut) {
  EXPECT_EQ(lane_exp(0.0f), 1.0f);
  EXPECT_EQ(lane_exp(-0.0f), 1.0f);
  EXPECT_EQ(lane_exp(std::nextafter(-87.0f, -100.0f)), 0.0f);
  EXPECT_EQ(lane_exp(-1e30f), 0.0f);
  EXPECT_EQ(lane_exp(-INFINITY), 0.0f);
}

TEST(LaneSincos, KeepsItsBoundOverTheWholeTurn) {
  const int steps = 1 << 21;
  const double two_pi = 6.283185307179586476925;
  double worst = 0;
  for (int i = 0; i <= steps; ++i) {
    float u = static_cast<float>(i) / static_cast<float>(steps), sine, cosine;
    lane_sincos_turn(u, &sine, &cosine);
    worst = std::max({worst, std::abs(sine - std::sin(two_pi * u)), std::abs(cosine - std::cos(two_pi * u))});
  }
  EXPECT_LT(worst, 2e-7);
}

TEST(LaneSincos, IsExactAtQuarterTurns) {
  const float expected[5][2] = {{0, 1}, {1, 0}, {0, -1}, {-1, 0}, {0, 1}};
  for (int quarter = 0; quarter <= 4; ++quarter) {
    float sine, cosine;
    lane_sincos_turn(0.25f * static_cast<float>(quarter), &sine, &cosine);
    EXPECT_EQ(sine, expected[quarter][0]) << quarter;
    EXPECT_EQ(cosine, expected[quarter][1]) << quarter;
  }
}

TEST(LaneAcos, KeepsItsBound) {
  const int steps = 1 << 21;
  double worst = 0;
  for (int i = 0; i <= steps; ++i) {
    float x = static_cast<float>(i) / static_cast<float>(steps);
    worst = std::max(worst, std::abs(lane_acos(x) - std::acos(static_cast<double>(x))));
  }
  EXPECT_LT(worst, 3e-7);
}

TEST(LaneRotate, TurnsByTheAngleAndKeepsTheLength) {
  const float directions[5][3] = {{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {0.6f, 0, -0.8f}, {0.48f, 0.64f, 0.6f}};
  for (auto &d : directions)
    for (float angle = 0; angle < 3.1f; angle += 0.1f)
      for (float azimuth = 0; azimuth < 6.2f; azimuth += 0.3f) {
        float x = d[0], y = d[1], z = d[2];
        lane_rotate(&x, &y, &z, std::cos(angle), std::sin(angle) * std::cos(azimuth),
                    std::sin(angle) * std::sin(azimuth));
        EXPECT_NEAR(x * x + y * y + z * z, 1, 3e-7);
        EXPECT_NEAR(x * d[0] + y * d[1] + z * d[2], std::cos(angle), 3e-7);
      }
}

TEST(LaneNormalize, GivesUnitVectorsOfAnyLength) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> component(-1, 1);
  double worst = 0;
  for (int exponent = -125; exponent <= 126; ++exponent)
    for (int i = 0; i < 100; ++i) {
      float v[3];
      double exact[3], squared = 0;
      for (int k = 0; k < 3; ++k) {
        v[k] = std::ldexp(component(random), exponent);
        exact[k] = std::ldexp(double(v[k]), -exponent);
        squared += exact[k] * exact[k];
      }
      lane_normalize(v);
      for (int k = 0; k < 3; ++k)
        worst = std::max(worst, std::abs(double(v[k]) - exact[k] / std::sqrt(squared)));
    }
  EXPECT_LT(worst, 2e-7);
}

TEST(LaneNormalize, DoesWhatTheFunctionForOneVectorDoes) {
  std::mt19937 random(4);
  std::uniform_real_distribution<float> component(-3, 3);
  for (int i = 0; i < 10000; ++i) {
    float v[3] = {component(random), component(random), component(random)};
    const float3 one = tyn_normalize(tyn_vec3(v[0], v[1], v[2]));
    lane_normalize(v);
    EXPECT_EQ(v[0], one.x);
    EXPECT_EQ(v[1], one.y);
    EXPECT_EQ(v[2], one.z);
  }
}

TEST(LaneNormalize, LeavesAZeroVector) {
  float v[3] = {0, -0.0f, 0};
  lane_normalize(v);
  EXPECT_EQ(v[0], 0);
  EXPECT_EQ(v[1], 0);
  EXPECT_EQ(v[2], 0);
}

TEST(LaneCross, IsPerpendicularAndRightHanded) {
  const float x[3] = {1, 0, 0}, y[3] = {0, 1, 0};
  float z[3];
  lane_cross(x, y, z);
  EXPECT_EQ(z[0], 0);
  EXPECT_EQ(z[1], 0);
  EXPECT_EQ(z[2], 1);
  const float a[3] = {1, 2, 3}, b[3] = {-4, 5, 7};
  float c[3];
  lane_cross(a, b, c);
  EXPECT_EQ(c[0], -1);
  EXPECT_EQ(c[1], -19);
  EXPECT_EQ(c[2], 13);
}

} // namespace
