// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Fresnel's equations and Snell's law against exact values.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "core/opencl_shim.hpp"

namespace {

using namespace tyn_kernel;

const double indices[] = {0.4, 1 / 1.5, 1 / 1.33, 1.01, 1.33, 1.4, 1.5, 2.4, 4.0};

// Fraction of the energy that is transmitted, from the transmitted amplitudes (Hecht, Optics, 4.62 to 4.65), not as 1 - R.
double transmittance(double cos_i, double eta) {
  double cos_t = std::sqrt(1 - (1 - cos_i * cos_i) / (eta * eta));
  double perpendicular = 2 * cos_i / (cos_i + eta * cos_t);
  double parallel = 2 * cos_i / (eta * cos_i + cos_t);
  return eta * cos_t / cos_i * 0.5 * (perpendicular * perpendicular + parallel * parallel);
}

TEST(Fresnel, AtNormalIncidenceIsTheTextbookRatio) {
  for (double eta : indices) {
    double r = (eta - 1) / (eta + 1);
    EXPECT_NEAR(tyn_fresnel(1.0f, static_cast<float>(eta)), r * r, 2e-7) << eta;
  }
}

TEST(Fresnel, AtBrewstersAngleReflectsOnlyPerpendicularLight) {
  for (double eta : indices) {
    double angle = std::atan(eta);
    // there R_parallel = 0 and R_perpendicular = cos^2(2 angle)
    double expected = 0.5 * std::pow(std::cos(2 * angle), 2);
    EXPECT_NEAR(tyn_fresnel(static_cast<float>(std::cos(angle)), static_cast<float>(eta)), expected, 1e-6) << eta;
  }
}

TEST(Fresnel, BeyondTheCriticalAngleReflectsEverything) {
  for (double eta : indices) {
    if (eta >= 1)
      continue;
    double critical = std::asin(eta);
    for (double angle : {critical + 1e-3, 0.5 * (critical + 1.5707), 1.5707})
      EXPECT_EQ(tyn_fresnel(static_cast<float>(std::cos(angle)), static_cast<float>(eta)), 1.0f) << eta;
    EXPECT_LT(tyn_fresnel(static_cast<float>(std::cos(critical - 1e-3)), static_cast<float>(eta)), 1.0f) << eta;
  }
}

TEST(Fresnel, ReflectedAndTransmittedEnergyAreOne) {
  for (double eta : indices)
    for (int i = 1; i <= 1000; ++i) {
      double cos_i = i / 1000.0;
      if ((1 - cos_i * cos_i) / (eta * eta) > 0.9999)
        continue;
      ASSERT_NEAR(tyn_fresnel(static_cast<float>(cos_i), static_cast<float>(eta)) + transmittance(cos_i, eta), 1, 5e-6)
          << eta << " " << cos_i;
    }
}

TEST(Fresnel, IsTheSameFromBothSides) {
  for (double eta : indices)
    for (int i = 1; i <= 200; ++i) {
      double cos_i = i / 200.0, sin2_t = (1 - cos_i * cos_i) / (eta * eta);
      if (cos_i < 0.05 || sin2_t > 0.997) // where one angle's rounding is large in the other's cosine
        continue;
      ASSERT_NEAR(tyn_fresnel(static_cast<float>(cos_i), static_cast<float>(eta)),
                  tyn_fresnel(static_cast<float>(std::sqrt(1 - sin2_t)), static_cast<float>(1 / eta)), 1e-4)
          << eta << " " << cos_i;
    }
}

TEST(Fresnel, AtGrazingIncidenceIsOne) {
  for (double eta : indices)
    EXPECT_EQ(tyn_fresnel(0.0f, static_cast<float>(eta)), 1.0f) << eta;
}

TEST(Fresnel, OfMatchedMediaIsZero) {
  for (float cos_i : {1.0f, 0.7f, 0.3f, 0.1f})
    EXPECT_LT(tyn_fresnel(cos_i, 1.0f), 1e-9f);
}

float3 random_direction(std::mt19937 &random) {
  std::normal_distribution<float> normal;
  return tyn_normalize(tyn_vec3(normal(random), normal(random), normal(random)));
}

TEST(Refraction, ObeysSnellsLawInThePlaneOfIncidence) {
  std::mt19937 random(8);
  for (double eta_value : indices) {
    float eta = static_cast<float>(eta_value);
    for (int i = 0; i < 2000; ++i) {
      float3 d = random_direction(random), n = random_direction(random);
      if (tyn_dot(d, n) > 0)
        n = -n;
      if (tyn_fresnel(-tyn_dot(d, n), eta) >= 1)
        continue;
      float3 o = tyn_refract(d, n, eta);
      float3 sine_i = tyn_cross(n, d), sine_t = tyn_cross(n, o) * eta;
      float3 difference = sine_i - sine_t;
      ASSERT_LT(std::sqrt(tyn_dot(difference, difference)), 2e-6f);
      ASSERT_LE(tyn_dot(o, n), 0.0f);
      ASSERT_NEAR(tyn_dot(o, o), 1, 1e-6);
    }
  }
}

TEST(Reflection, MirrorsTheNormalComponent) {
  std::mt19937 random(9);
  for (int i = 0; i < 2000; ++i) {
    float3 d = random_direction(random), n = random_direction(random), o = tyn_reflect(d, n);
    ASSERT_NEAR(tyn_dot(o, n), -tyn_dot(d, n), 1e-6);
    float3 difference = tyn_cross(n, o) - tyn_cross(n, d);
    ASSERT_LT(tyn_dot(difference, difference), 1e-12f);
  }
}

TEST(Frame, IsOrthonormalAndRightHandedForEveryNormal) {
  std::mt19937 random(10);
  for (int i = 0; i < 100000; ++i) {
    float3 n = i == 0 ? tyn_vec3(0, 0, 1) : i == 1 ? tyn_vec3(0, 0, -1) : random_direction(random);
    TynFrame frame = tyn_frame(n);
    float3 z = tyn_cross(frame.x, frame.y) - n;
    ASSERT_LT(std::sqrt(tyn_dot(z, z)), 1e-6f);
    ASSERT_NEAR(tyn_dot(frame.x, frame.x), 1, 1e-6);
    ASSERT_NEAR(tyn_dot(frame.y, frame.y), 1, 1e-6);
    ASSERT_NEAR(tyn_dot(frame.x, frame.y), 0, 1e-6);
  }
}

TEST(Normalize, WorksOverTheWholeRangeOfFloats) {
  for (float scale : {1e-38f, 1e-30f, 1e-10f, 1.0f, 1e10f, 1e30f, 1e38f}) {
    float3 n = tyn_normalize(tyn_vec3(scale, -2 * scale, 2 * scale));
    EXPECT_NEAR(n.x, 1.0 / 3, 1e-6) << scale;
    EXPECT_NEAR(n.y, -2.0 / 3, 1e-6) << scale;
    EXPECT_NEAR(n.z, 2.0 / 3, 1e-6) << scale;
  }
  float3 zero = tyn_normalize(tyn_vec3(0, 0, 0));
  EXPECT_EQ(tyn_dot(zero, zero), 0.0f);
}

} // namespace
