// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "tyndall/tyndall.h"

namespace {

TynMedium make_medium(float sigma_a, float sigma_s, float g) {
  TynMedium medium = tyn_medium();
  for (int channel = 0; channel < 3; ++channel) {
    medium.sigma_a[channel] = sigma_a;
    medium.sigma_s[channel] = sigma_s;
  }
  medium.g = g;
  return medium;
}

} // namespace

TEST(Describe, LengthsAreThoseOfTheDefinitions) {
  // sigma_a 2, sigma_s 8, g 0.75 per unit of 1 cm: sigma_t 10, sigma_t' 4, sigma_tr sqrt(24).
  const TynMedium medium = make_medium(2.0f, 8.0f, 0.75f);
  TynMediumDescription d;
  ASSERT_EQ(tyn_medium_describe(&medium, 0.01, 5.0, &d), TYN_OK);
  for (int channel = 0; channel < 3; ++channel) {
    EXPECT_FLOAT_EQ(d.albedo[channel], 0.8f);
    EXPECT_DOUBLE_EQ(d.mean_free_path_mm[channel], 1.0);
    EXPECT_DOUBLE_EQ(d.transport_mean_free_path_mm[channel], 2.5);
    EXPECT_DOUBLE_EQ(d.diffusion_length_mm[channel], 10.0 / std::sqrt(24.0));
    EXPECT_DOUBLE_EQ(d.mean_free_path_fraction[channel], 0.02);
    EXPECT_DOUBLE_EQ(d.transport_mean_free_path_fraction[channel], 0.05);
    EXPECT_DOUBLE_EQ(d.diffusion_length_fraction[channel], 0.2 / std::sqrt(24.0));
    EXPECT_FLOAT_EQ(d.diffuse_albedo[channel], tyn_color_from_albedo(0.8f, 0.75f));
  }
}

TEST(Describe, ChannelsAreTheirOwn) {
  TynMedium medium = make_medium(1.0f, 1.0f, 0.0f);
  medium.sigma_s[1] = 3.0f;
  medium.sigma_s[2] = 7.0f;
  TynMediumDescription d;
  ASSERT_EQ(tyn_medium_describe(&medium, 0.001, 1.0, &d), TYN_OK);
  EXPECT_DOUBLE_EQ(d.mean_free_path_mm[0], 0.5);
  EXPECT_DOUBLE_EQ(d.mean_free_path_mm[1], 0.25);
  EXPECT_DOUBLE_EQ(d.mean_free_path_mm[2], 0.125);
}

TEST(Describe, AnEmptyMediumHasInfiniteLengths) {
  const TynMedium medium = tyn_medium();
  TynMediumDescription d;
  ASSERT_EQ(tyn_medium_describe(&medium, 1.0, 1.0, &d), TYN_OK);
  EXPECT_EQ(d.albedo[0], 0.0f);
  EXPECT_EQ(d.diffuse_albedo[0], 0.0f);
  EXPECT_TRUE(std::isinf(d.mean_free_path_mm[0]));
  EXPECT_TRUE(std::isinf(d.transport_mean_free_path_fraction[0]));
  EXPECT_TRUE(std::isinf(d.diffusion_length_mm[0]));
}

TEST(Describe, WithoutAbsorptionLightDiffusesForEver) {
  const TynMedium medium = make_medium(0.0f, 4.0f, 0.5f);
  TynMediumDescription d;
  ASSERT_EQ(tyn_medium_describe(&medium, 0.001, 1.0, &d), TYN_OK);
  EXPECT_EQ(d.albedo[0], 1.0f);
  EXPECT_EQ(d.diffuse_albedo[0], 1.0f);
  EXPECT_DOUBLE_EQ(d.mean_free_path_mm[0], 0.25);
  EXPECT_DOUBLE_EQ(d.transport_mean_free_path_mm[0], 0.5);
  EXPECT_TRUE(std::isinf(d.diffusion_length_mm[0]));
}

TEST(Describe, BadArgumentsAreRefusedAndNothingIsWritten) {
  const TynMedium good = make_medium(1.0f, 1.0f, 0.0f);
  const TynMedium bad = make_medium(-1.0f, 1.0f, 0.0f);
  TynMediumDescription d, before;
  std::memset(&d, 1, sizeof d);
  before = d;
  EXPECT_EQ(tyn_medium_describe(nullptr, 1.0, 1.0, &d), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_medium_describe(&good, 1.0, 1.0, nullptr), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_medium_describe(&bad, 1.0, 1.0, &d), TYN_ERROR_INVALID_ARGUMENT);
  for (double value : {0.0, -1.0, static_cast<double>(NAN), static_cast<double>(INFINITY)}) {
    EXPECT_EQ(tyn_medium_describe(&good, value, 1.0, &d), TYN_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(tyn_medium_describe(&good, 1.0, value, &d), TYN_ERROR_INVALID_ARGUMENT);
  }
  EXPECT_EQ(std::memcmp(&d, &before, sizeof d), 0);
}
