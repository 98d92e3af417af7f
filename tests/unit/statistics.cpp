// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The tests' own statistics.
#include "common/statistics.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace {

using namespace tyn_test;

TEST(Statistics, ChiSquareTailsAreThoseOfTheTables) {
  // NIST/SEMATECH e-Handbook of Statistical Methods, table 1.3.6.7.4, upper-tail critical values
  EXPECT_NEAR(chi_square_tail(3.841, 1), 0.05, 5e-5);
  EXPECT_NEAR(chi_square_tail(10.828, 1), 0.001, 1e-5);
  EXPECT_NEAR(chi_square_tail(18.307, 10), 0.05, 5e-5);
  EXPECT_NEAR(chi_square_tail(149.449, 100), 0.001, 1e-5);
  EXPECT_NEAR(chi_square_tail(77.929, 100), 0.95, 5e-5);
}

TEST(Statistics, MeanAndStandardErrorAreTheTextbookOnes) {
  Mean mean;
  for (double value : {2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0})
    mean.add(value);
  EXPECT_DOUBLE_EQ(mean.mean(), 5.0);
  EXPECT_DOUBLE_EQ(mean.standard_error(), std::sqrt(32.0 / 7.0 / 8.0));
}

} // namespace
