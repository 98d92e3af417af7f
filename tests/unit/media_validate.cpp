// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/status.hpp"
#include "media/media.hpp"

namespace {

std::string refusal(const TynMedium &medium) {
  try {
    tyn::validate(medium);
  } catch (const tyn::Failure &failure) {
    EXPECT_EQ(failure.status, TYN_ERROR_INVALID_ARGUMENT);
    return failure.what();
  }
  return "accepted";
}

template <class Change>
std::string refusal_after(Change change) {
  TynMedium medium = tyn_medium();
  change(medium);
  return refusal(medium);
}

} // namespace

TEST(Validate, TheDefaultMediumIsFine) { EXPECT_EQ(refusal(tyn_medium()), "accepted"); }

TEST(Validate, TheEdgesOfTheRangesAreFine) {
  EXPECT_EQ(refusal_after([](TynMedium &m) { m.g = std::nextafter(1.0f, 0.0f); }), "accepted");
  EXPECT_EQ(refusal_after([](TynMedium &m) { m.g = std::nextafter(-1.0f, 0.0f); }), "accepted");
  EXPECT_EQ(refusal_after([](TynMedium &m) { m.ior = 4.0f; }), "accepted");
  EXPECT_EQ(refusal_after([](TynMedium &m) { m.sigma_s[0] = 1e30f; }), "accepted");
}

TEST(Validate, AMessageNamesFieldValueAndRange) {
  EXPECT_EQ(refusal_after([](TynMedium &m) { m.sigma_a[1] = -0.5f; }),
            "TynMedium::sigma_a[1] is -0.5; allowed: finite, >= 0");
  EXPECT_EQ(refusal_after([](TynMedium &m) { m.sigma_s[2] = INFINITY; }),
            "TynMedium::sigma_s[2] is inf; allowed: finite, >= 0");
  EXPECT_EQ(refusal_after([](TynMedium &m) { m.g = 1.0f; }), "TynMedium::g is 1; allowed: -1 < g < 1");
  EXPECT_EQ(refusal_after([](TynMedium &m) { m.ior = 0.5f; }), "TynMedium::ior is 0.5; allowed: 1 to 4");
}

TEST(Validate, NothingOutsideTheRangesIsAccepted) {
  EXPECT_NE(refusal_after([](TynMedium &m) { m.sigma_a[0] = NAN; }), "accepted");
  EXPECT_NE(refusal_after([](TynMedium &m) { m.sigma_s[0] = NAN; }), "accepted");
  EXPECT_NE(refusal_after([](TynMedium &m) { m.sigma_s[1] = -1e-30f; }), "accepted");
  EXPECT_NE(refusal_after([](TynMedium &m) { m.sigma_a[0] = m.sigma_s[0] = 3e38f; }), "accepted");
  EXPECT_NE(refusal_after([](TynMedium &m) { m.g = NAN; }), "accepted");
  EXPECT_NE(refusal_after([](TynMedium &m) { m.g = -1.0f; }), "accepted");
  EXPECT_NE(refusal_after([](TynMedium &m) { m.ior = 4.5f; }), "accepted");
  EXPECT_NE(refusal_after([](TynMedium &m) { m.ior = NAN; }), "accepted");
  EXPECT_NE(refusal_after([](TynMedium &m) { m.size = 0; }), "accepted");
}
