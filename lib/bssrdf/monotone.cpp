// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "bssrdf/monotone.hpp"

#include <cstddef>

namespace tyn {

std::vector<double> monotone_slopes(const std::vector<double> &x, const std::vector<double> &y) {
  const size_t n = x.size();
  std::vector<double> secant(n - 1), slope(n);
  for (size_t i = 0; i + 1 < n; i++)
    secant[i] = (y[i + 1] - y[i]) / (x[i + 1] - x[i]);
  slope[0] = secant[0];
  slope[n - 1] = secant[n - 2];
  for (size_t i = 1; i + 1 < n; i++) {
    const double h0 = x[i] - x[i - 1], h1 = x[i + 1] - x[i], a = (h0 + 2 * h1) / (3 * (h0 + h1));
    const double product = secant[i - 1] * secant[i];
    slope[i] = product > 0 ? product / (a * secant[i] + (1 - a) * secant[i - 1]) : 0;
  }
  return slope;
}

double hermite(const double x[2], const double y[2], const double slope[2], double at) {
  const double width = x[1] - x[0], t = (at - x[0]) / width;
  const double rise = y[1] - y[0], rise_0 = slope[0] * width, rise_1 = slope[1] * width;
  const double c2 = 3 * rise - 2 * rise_0 - rise_1, c3 = rise_0 + rise_1 - 2 * rise;
  return ((c3 * t + c2) * t + rise_0) * t + y[0];
}

} // namespace tyn
