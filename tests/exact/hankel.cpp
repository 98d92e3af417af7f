// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Inverse Hankel transforms against known pairs, and against an integration along the real axis.
#include "bssrdf/hankel.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "bssrdf/decaying.hpp"
#include "bssrdf/diffusion.hpp"
#include "bssrdf/layer_stack.hpp"
#include "slab/gauss.hpp"

namespace {

using namespace tyn;
using Complex = std::complex<double>;

constexpr double FIRST = 1.0 / 4096;
constexpr size_t COUNT = 268; // to beyond 4096

double radius(size_t i) { return FIRST * std::exp(double(i) * HANKEL_STEP); }

// Abramowitz & Stegun 1964, table 9.12.
TEST(Kelvin, HasTheTabulatedValues) {
  const double rows[3][3] = {
      {1, 0.2867062087, -0.4949946365}, {2, -0.0416645140, -0.2024000678}, {5, -0.0115117272, 0.0111875865}};
  for (auto &row : rows) {
    EXPECT_NEAR(kelvin(row[0]).real(), row[1], 1e-10);
    EXPECT_NEAR(kelvin(row[0]).imag(), row[2], 1e-10);
  }
}

struct Pair {
  double scale; // of r
  HankelTransform transform;
  std::function<double(double)> function;
};

// Gaussians are not among them: they do not stay bounded where the integral is taken.
std::vector<Pair> pairs() {
  std::vector<Pair> all;
  for (double a : {0.01, 1.0, 100.0})
    all.push_back({a, [=](Complex s) { return std::exp(-a * s); },
                   [=](double r) { return a / (2 * M_PI) / std::pow(a * a + r * r, 1.5); }});
  for (double b : {0.01, 1.0, 100.0}) // beyond some radius the function does not hold what K_0 is
    all.push_back({1 / b, [=](Complex s) { return 1.0 / (s * s + b * b); },
                   [=](double r) { return b * r < 600 ? std::cyl_bessel_k(0.0, b * r) / (2 * M_PI) : 0.0; }});
  for (double k : {0.03, 1.0}) // the fluence's gradient over a source at depth 1
    all.push_back({1, [=](Complex s) { return std::exp(-std::sqrt(s * s + k * k)); },
                   [=](double r) {
                     const double d = std::hypot(r, 1);
                     return (1 + k * d) * std::exp(-k * d) / (2 * M_PI * d * d * d);
                   }});
  return all;
}

TEST(InverseHankel, OfKnownPairs) {
  for (const Pair &pair : pairs()) {
    const std::vector<HankelValue> values = inverse_hankel(pair.transform, FIRST, COUNT);
    ASSERT_EQ(values.size(), COUNT);
    for (size_t i = 0; i < COUNT; ++i)
      EXPECT_NEAR(values[i].value, pair.function(radius(i)), 1e-12 * values[i].magnitude) << radius(i);
  }
}

// Between the radii of the transform: right over six decades of the function, falling beyond.
TEST(DecayingFunction, OfKnownPairs) {
  for (const Pair &pair : pairs()) {
    const DecayingFunction function(FIRST, inverse_hankel(pair.transform, FIRST, COUNT));
    double before = INFINITY;
    for (double r = FIRST; r < 4096; r *= 1.0173) {
      const double value = function(r), expected = pair.function(r);
      if (expected > 1e-6 * pair.function(pair.scale)) {
        EXPECT_NEAR(value, expected, 1e-5 * expected) << r;
      }
      EXPECT_TRUE(value < before * (1 + 1e-12) || value < 1e-300) << value << " at " << r;
      before = value;
    }
  }
}

TEST(DecayingFunction, IsZeroIfThereIsNothing) {
  const DecayingFunction function(FIRST, inverse_hankel([](Complex) { return 0.0; }, FIRST, COUNT));
  EXPECT_EQ(function(FIRST), 0);
  EXPECT_EQ(function(100), 0);
}

// Along the real axis, where the integrand oscillates. Where layers are barely thicker than the depth of their source it falls
// off like exp(-0.3 s) only.
double along_the_real_axis(const HankelTransform &transform, double r) {
  const Quadrature rule = gauss_legendre(16);
  double sum = 0, from = 0, step = 1e-6;
  while (from < 150) {
    step = std::min(1.3 * step, 2 / std::max(r, 5.0));
    for (size_t i = 0; i < rule.points.size(); ++i) {
      const double s = from + step * rule.points[i];
      sum += rule.weights[i] * step * s * transform(s).real() * std::cyl_bessel_j(0.0, s * r) / (2 * M_PI);
    }
    from += step;
  }
  return sum;
}

// No pole between the real axis and the line of integration: stacks of two to six layers, thin and thick, with and without
// absorption, with mean free paths and indices of refraction that differ.
TEST(InverseHankel, OfStacksIsTheIntegralAlongTheRealAxis) {
  const double indices[] = {1.4, 1, 1.33, 3, 1.5, 1.8, 1.1}, albedos[] = {1, 0.999, 0.9, 0.5};
  const double lengths[] = {1, 0.2, 4, 30}, thicknesses[] = {1.05, 8, 1.3, 2.5, 40};
  for (size_t variant = 0; variant < 30; ++variant) {
    std::vector<DiffusionLayer> layers;
    auto index = [&](size_t i) { return indices[(variant + 2 * i) % 7]; };
    for (size_t i = 0; i < 2 + variant % 5; ++i)
      layers.emplace_back(albedos[(variant + 3 * i) % 4], thicknesses[(2 * variant + i) % 5],
                          internal_reflection_fit(index(i + 1) / index(i)),
                          internal_reflection_fit(index(i + 1) / index(i + 2)),
                          i == 0 ? 1 : lengths[(variant / 2 + i) % 4]);
    const HankelTransform transform = [&](Complex s) { return stack_response(layers, s).reflected; };
    const std::vector<HankelValue> values = inverse_hankel(transform, FIRST, COUNT);
    for (size_t i : {96u, 132u, 158u}) // 0.1, 0.93, 4.7
      EXPECT_NEAR(values[i].value, along_the_real_axis(transform, radius(i)), 1e-11 * values[i].magnitude)
          << variant << " at " << radius(i);
  }
}

} // namespace
