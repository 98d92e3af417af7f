// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "bssrdf/integrate.hpp"

#include <cmath>

#include "slab/gauss.hpp"

namespace tyn {
namespace {

constexpr int DEEPEST = 12;

double gauss(const std::function<double(double)> &f, double a, double b) {
  static const Quadrature rule = gauss_legendre(16);
  double sum = 0;
  for (size_t i = 0; i < rule.points.size(); i++)
    sum += rule.weights[i] * f(a + (b - a) * rule.points[i]);
  return sum * (b - a);
}

double refine(const std::function<double(double)> &f, double a, double b, double whole, int depth, double tolerance) {
  const double middle = 0.5 * (a + b), left = gauss(f, a, middle), right = gauss(f, middle, b);
  if (depth == DEEPEST || !(std::abs(left + right - whole) > tolerance * std::abs(left + right)))
    return left + right;
  return refine(f, a, middle, left, depth + 1, tolerance) + refine(f, middle, b, right, depth + 1, tolerance);
}

} // namespace

double integrate(const std::function<double(double)> &f, double a, double b, double tolerance) {
  return refine(f, a, b, gauss(f, a, b), 0, tolerance);
}

} // namespace tyn
