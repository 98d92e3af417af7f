// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <string>

#include "tyndall/tyndall.h"

namespace {

struct Row {
  const char *name;
  double sigma_s[3], sigma_a[3];
  double ior;
};

// Jensen, Marschner, Levoy, Hanrahan 2001, figure 5; 1/mm.
const Row rows[] = {
    {"apple", {2.29, 2.39, 1.97}, {0.0030, 0.0034, 0.046}, 1.3},
    {"chicken1", {0.15, 0.21, 0.38}, {0.015, 0.077, 0.19}, 1.3},
    {"chicken2", {0.19, 0.25, 0.32}, {0.018, 0.088, 0.20}, 1.3},
    {"cream", {7.38, 5.47, 3.15}, {0.0002, 0.0028, 0.0163}, 1.3},
    {"ketchup", {0.18, 0.07, 0.03}, {0.061, 0.97, 1.45}, 1.3},
    {"marble", {2.19, 2.62, 3.00}, {0.0021, 0.0041, 0.0071}, 1.5},
    {"potato", {0.68, 0.70, 0.55}, {0.0024, 0.0090, 0.12}, 1.3},
    {"skimmilk", {0.70, 1.22, 1.90}, {0.0014, 0.0025, 0.0142}, 1.3},
    {"skin1", {0.74, 0.88, 1.01}, {0.032, 0.17, 0.48}, 1.3},
    {"skin2", {1.09, 1.59, 1.79}, {0.013, 0.070, 0.145}, 1.3},
    {"spectralon", {11.6, 20.4, 14.9}, {0, 0, 0}, 1.3},
    {"wholemilk", {2.55, 3.21, 3.77}, {0.0011, 0.0024, 0.014}, 1.3},
};

} // namespace

TEST(Presets, AreThePublishedTable) {
  ASSERT_EQ(tyn_medium_preset_count(), 12u);
  for (uint32_t i = 0; i < 12; ++i) {
    const Row &row = rows[i];
    EXPECT_STREQ(tyn_medium_preset_name(i), row.name);
    TynMedium medium = tyn_medium();
    ASSERT_EQ(tyn_medium_preset(row.name, 0.001, &medium), TYN_OK);
    EXPECT_STREQ(medium.name, row.name);
    EXPECT_EQ(medium.size, sizeof medium);
    EXPECT_EQ(medium.g, 0.0f);
    EXPECT_EQ(medium.ior, static_cast<float>(row.ior));
    for (int channel = 0; channel < 3; ++channel) {
      EXPECT_FLOAT_EQ(medium.sigma_s[channel], static_cast<float>(row.sigma_s[channel])) << row.name;
      EXPECT_FLOAT_EQ(medium.sigma_a[channel], static_cast<float>(row.sigma_a[channel])) << row.name;
    }
  }
}

TEST(Presets, AreConvertedToTheScenesUnit) {
  TynMedium medium = tyn_medium();
  ASSERT_EQ(tyn_medium_preset("skin1", 1.0, &medium), TYN_OK);
  EXPECT_FLOAT_EQ(medium.sigma_s[0], 740.0f);
  EXPECT_FLOAT_EQ(medium.sigma_a[2], 480.0f);
  ASSERT_EQ(tyn_medium_preset("skin1", 0.01, &medium), TYN_OK);
  EXPECT_FLOAT_EQ(medium.sigma_s[0], 7.4f);
}

TEST(Presets, EndWithNull) {
  EXPECT_EQ(tyn_medium_preset_name(12), nullptr);
  EXPECT_EQ(tyn_medium_preset_name(UINT32_MAX), nullptr);
}

TEST(Presets, RefuseWhatIsNotThereAndLeaveTheMediumAlone) {
  TynMedium medium = tyn_medium();
  medium.g = 0.25f;
  const TynMedium before = medium;
  for (const char *name : {"granite", "", "Skin1", "skin"})
    EXPECT_EQ(tyn_medium_preset(name, 1.0, &medium), TYN_ERROR_INVALID_ARGUMENT) << name;
  EXPECT_EQ(tyn_medium_preset(nullptr, 1.0, &medium), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_medium_preset("skin1", 1.0, nullptr), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(std::memcmp(&medium, &before, sizeof medium), 0);
}

TEST(Presets, RefuseAnImpossibleUnit) {
  TynMedium medium = tyn_medium();
  for (double unit : {0.0, -1.0, static_cast<double>(NAN), static_cast<double>(INFINITY), 1e300})
    EXPECT_EQ(tyn_medium_preset("skin1", unit, &medium), TYN_ERROR_INVALID_ARGUMENT) << unit;
}
