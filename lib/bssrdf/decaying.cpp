// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "bssrdf/decaying.hpp"

#include <algorithm>
#include <cmath>

namespace tyn {
namespace {

constexpr double LEAST = 1e-9; // of the magnitude: seven digits
constexpr size_t POINTS = 6;   // that one polynomial goes through

} // namespace

DecayingFunction::DecayingFunction(double first_, const std::vector<HankelValue> &values)
    : first(first_), last(first_) {
  for (const HankelValue &one : values) {
    if (!(one.value > LEAST * one.magnitude))
      break;
    logarithms.push_back(std::log(one.value));
  }
  const size_t n = logarithms.size();
  all = n == values.size();
  if (n < 2)
    return;
  last = radius(double(n - 1));
  slope = std::max((logarithms[n - 2] - logarithms[n - 1]) / (last - radius(double(n - 2))), 0.0);
}

double DecayingFunction::operator()(double r) const {
  if (logarithms.empty())
    return 0;
  if (r >= last)
    return std::exp(logarithms.back() - slope * (r - last));
  return std::exp(interpolate(std::max(std::log(r / first) / HANKEL_STEP, 0.0)));
}

// Where all values have digits left there may be hardly any exponential beside the power: that of r between the last two radii,
// not that of the last one, is what the slope is compared with.
double DecayingFunction::falloff() const {
  if (!all || logarithms.size() < 2)
    return slope;
  const double power = (logarithms.end()[-2] - logarithms.back()) / HANKEL_STEP;
  return std::max(power - 3, 0.0) / last;
}

double DecayingFunction::radius(double i) const { return first * std::exp(i * HANKEL_STEP); }

// Lagrange's polynomial of ln f over ln r, as much on either side as there is.
double DecayingFunction::interpolate(double i) const {
  const size_t n = logarithms.size(), points = std::min(POINTS, n), whole = size_t(i);
  const size_t begin = std::min(whole - std::min(whole, points / 2 - 1), n - points);
  double sum = 0;
  for (size_t j = 0; j < points; j++) {
    double weight = 1;
    for (size_t m = 0; m < points; m++)
      weight *= m == j ? 1 : (i - double(begin + m)) / (double(j) - double(m));
    sum += weight * logarithms[begin + j];
  }
  return sum;
}

} // namespace tyn
