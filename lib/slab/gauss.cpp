// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "core/pi.hpp"
#include "slab/gauss.hpp"

#include <cmath>

namespace tyn {
namespace {

struct Legendre {
  double value, slope;
};

Legendre legendre(unsigned degree, double x) {
  double before = 1, value = x;
  for (unsigned l = 2; l <= degree; l++) {
    const double next = ((2 * l - 1) * x * value - (l - 1) * before) / l;
    before = value;
    value = next;
  }
  return {value, degree * (before - x * value) / ((1 - x) * (1 + x))};
}

} // namespace

// Newton's method from Tricomi's estimate of the roots.
Quadrature gauss_legendre(unsigned count) {
  Quadrature rule{std::vector<double>(count), std::vector<double>(count)};
  for (unsigned i = 0; i < count; i++) {
    double x = std::cos(pi * (i + 0.75) / (count + 0.5));
    if (count == 1)
      x = 0;
    Legendre p = legendre(count, x);
    for (double step = 1; std::abs(step) > 1e-15 && count > 1;) {
      step = p.value / p.slope;
      x -= step;
      p = legendre(count, x);
    }
    rule.points[count - 1 - i] = 0.5 * (1 + x);
    rule.weights[count - 1 - i] = 1 / ((1 - x) * (1 + x) * p.slope * p.slope);
  }
  return rule;
}

} // namespace tyn
