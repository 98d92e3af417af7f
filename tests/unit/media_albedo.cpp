// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "tyndall/tyndall.h"

TEST(Albedo, BlackAbsorbsAndWhiteScatters) {
  for (float g : {-0.9f, 0.0f, 0.5f, 0.9f}) {
    EXPECT_NEAR(tyn_albedo_from_color(0.0f, g), 0.0f, 1e-4f);
    EXPECT_NEAR(tyn_albedo_from_color(1.0f, g), 1.0f, 1e-6f);
    EXPECT_EQ(tyn_color_from_albedo(0.0f, g), 0.0f);
    EXPECT_EQ(tyn_color_from_albedo(1.0f, g), 1.0f);
  }
}

TEST(Albedo, IsKullaAndContysFormula) {
  // By hand: C = 0.5, s = 4.09712 + 2.104315 - sqrt(9.59217 + 20.8404 + 4.42815) = 0.297138.
  EXPECT_NEAR(tyn_albedo_from_color(0.5f, 0.0f), 0.911709f, 1e-5f);
  EXPECT_NEAR(tyn_albedo_from_color(0.5f, 0.5f), 0.911709f / (1.0f - 0.5f * 0.088291f), 1e-5f);
}

TEST(Albedo, ColorIsVanDeHulstsFormula) {
  // By hand: W = 0.75, g = 0, s = 0.5: C = 0.5 * 0.9305 / 1.585.
  EXPECT_NEAR(tyn_color_from_albedo(0.75f, 0.0f), 0.46525f / 1.585f, 1e-6f);
}

// An index-matched isotropic half-space under diffuse light reflects 1 - 2 sqrt(1 - W) int_0^1
// H(mu) mu dmu (Chandrasekhar 1950).
TEST(Albedo, ColorIsNearTheExactDiffuseAlbedoOfAHalfSpace) {
  // H by iteration of 1/H(mu) = sqrt(1 - W) + (W/2) int_0^1 x H(x) / (mu + x) dx on midpoints.
  for (double albedo : {0.3, 0.6, 0.9, 0.99}) {
    constexpr int n = 400;
    double h[n], next[n];
    for (double &value : h)
      value = 1.0;
    for (int round = 0; round < 200; ++round) {
      for (int i = 0; i < n; ++i) {
        double sum = 0.0;
        for (int j = 0; j < n; ++j) {
          const double x = (j + 0.5) / n;
          sum += x * h[j] / ((i + 0.5) / n + x);
        }
        next[i] = 1.0 / (std::sqrt(1.0 - albedo) + 0.5 * albedo * sum / n);
      }
      for (int i = 0; i < n; ++i)
        h[i] = next[i];
    }
    double moment = 0.0;
    for (int i = 0; i < n; ++i)
      moment += h[i] * (i + 0.5) / n / n;
    const double exact = 1.0 - 2.0 * std::sqrt(1.0 - albedo) * moment;
    EXPECT_NEAR(tyn_color_from_albedo(static_cast<float>(albedo), 0.0f), exact, 0.003) << albedo;
  }
}

TEST(Albedo, ColorSurvivesTheRoundTrip) {
  for (float g : {-0.9f, -0.3f, 0.0f, 0.5f, 0.9f})
    for (int i = 0; i <= 100; ++i) {
      const float color = static_cast<float>(i) / 100.0f;
      EXPECT_NEAR(tyn_color_from_albedo(tyn_albedo_from_color(color, g), g), color, 2e-4f)
          << "color " << color << ", g " << g;
    }
}

TEST(Albedo, GrowsWithTheColor) {
  for (float g : {-0.9f, 0.0f, 0.9f}) {
    float last = -1.0f;
    for (int i = 0; i <= 1000; ++i) {
      const float albedo = tyn_albedo_from_color(static_cast<float>(i) / 1000.0f, g);
      EXPECT_GE(albedo, last);
      last = albedo;
    }
  }
}

TEST(Albedo, AnythingOutsideIsClamped) {
  EXPECT_EQ(tyn_albedo_from_color(-3.0f, 0.0f), tyn_albedo_from_color(0.0f, 0.0f));
  EXPECT_EQ(tyn_albedo_from_color(7.0f, 0.0f), tyn_albedo_from_color(1.0f, 0.0f));
  EXPECT_EQ(tyn_color_from_albedo(2.0f, 0.5f), 1.0f);
  EXPECT_EQ(tyn_color_from_albedo(-2.0f, 0.5f), 0.0f);
  EXPECT_FALSE(std::isnan(tyn_albedo_from_color(NAN, 0.0f)));
  EXPECT_FALSE(std::isnan(tyn_color_from_albedo(NAN, 0.0f)));
}
