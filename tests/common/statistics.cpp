// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "common/statistics.hpp"

#include <cmath>

namespace tyn_test {

void Mean::add(double value) {
  ++n;
  double delta = value - average;
  average += delta / double(n);
  squares += delta * (value - average);
}

double Mean::standard_error() const { return n < 2 ? INFINITY : std::sqrt(squares / (double(n) * double(n - 1))); }

namespace {

// Regularized incomplete gamma functions: the series for P(a, x), good for x < a + 1, and the continued fraction for
// Q(a, x) by Lentz's method, good beyond (DLMF 8.11.4 and 8.9.2).
double gamma_series(double a, double x) {
  double term = 1 / a, sum = term;
  for (int k = 1; k < 100000 && term > sum * 1e-16; ++k) {
    term *= x / (a + k);
    sum += term;
  }
  return sum * std::exp(a * std::log(x) - x - std::lgamma(a));
}

double gamma_fraction(double a, double x) {
  double b = x + 1 - a, c = 1e300, d = 1 / b, h = d;
  for (int k = 1; k < 100000; ++k) {
    double factor = -k * (k - a);
    b += 2;
    d = 1 / (factor * d + b);
    c = b + factor / c;
    h *= c * d;
    if (std::abs(c * d - 1) < 1e-15)
      break;
  }
  return h * std::exp(a * std::log(x) - x - std::lgamma(a));
}

} // namespace

double chi_square_tail(double statistic, double degrees) {
  double a = degrees / 2, x = statistic / 2;
  if (x <= 0)
    return 1;
  return x < a + 1 ? 1 - gamma_series(a, x) : gamma_fraction(a, x);
}

double chi_square_test(const std::vector<double> &observed, const std::vector<double> &expected) {
  double statistic = 0, pooled_observed = 0, pooled_expected = 0;
  int bins = 0;
  auto add = [&](double o, double e) {
    statistic += (o - e) * (o - e) / e;
    ++bins;
  };
  for (size_t i = 0; i < observed.size(); ++i) {
    if (expected[i] >= 10) {
      add(observed[i], expected[i]);
    } else {
      pooled_observed += observed[i];
      pooled_expected += expected[i];
    }
  }
  if (pooled_expected >= 1)
    add(pooled_observed, pooled_expected);
  else if (pooled_observed > 20)
    return 0; // where next to nothing is expected
  return bins < 2 ? 0 : chi_square_tail(statistic, bins - 1);
}

} // namespace tyn_test
