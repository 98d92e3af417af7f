// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Statistics for tests with fixed seeds. Such a test never flakes; its false-alarm rate is the chance that a right program
// would have failed with the seed that was picked.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tyn_test {

// Four standard errors on both sides are exceeded by chance once in 16 000 times.
constexpr double four_sigma = 4.0;

// Mean and its standard error, in one pass (Welford 1962).
class Mean {
public:
  void add(double value);
  double mean() const { return average; }
  double standard_error() const;
  uint64_t count() const { return n; }

private:
  uint64_t n = 0;
  double average = 0, squares = 0;
};

// Chance that a chi-square variable with `degrees` degrees of freedom exceeds `statistic`.
double chi_square_tail(double statistic, double degrees);

// Pearson's test of `observed` counts against `expected` ones: the chance of a worse fit if the expectation is right. Bins
// that expect fewer than 10 are pooled.
double chi_square_test(const std::vector<double> &observed, const std::vector<double> &expected);

} // namespace tyn_test
