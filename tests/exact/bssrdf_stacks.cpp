// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The multipole of layer stacks against closed forms: totals, limits in which one layer is all there is, and far falloffs.
#include <cmath>
#include <complex>

#include <gtest/gtest.h>

#include "bssrdf/bssrdf.hpp"
#include "common/bssrdf_model.hpp"

namespace {

using namespace tyn_test;

// Of Donner & Jensen 2005, written out once more.
double z_b(double eta) {
  const double f = eta < 1 ? -0.4399 + 0.7099 / eta - 0.3319 / (eta * eta) + 0.0636 / (eta * eta * eta)
                           : -1.440 / (eta * eta) + 0.710 / eta + 0.668 + 0.0636 * eta;
  return 2.0 / 3 * (1 + f) / (1 - f);
}

BssrdfModel stack(const std::vector<ExactLayer> &layers, bool transmitted, double above = 1, double below = 1) {
  TynBssrdfOptions options = tyn_bssrdf_options();
  options.model = TYN_BSSRDF_MULTIPOLE;
  options.transmitted = transmitted;
  ExactSlab slab(layers, above, below);
  return BssrdfModel(slab.view(), options);
}

double total(const std::vector<ExactLayer> &layers, bool transmitted, double above = 1, double below = 1) {
  return stack(layers, transmitted, above, below).albedo()[0];
}

// What one side of a layer does at spatial frequency 0, all in reduced mean free paths, by hyperbolic functions as they are.
struct Side {
  double reflected, transmitted;

  Side(double albedo, double d, double near, double far) {
    const double k = std::sqrt(3 * (1 - albedo)), a = 1 + near, length = d + near + far;
    reflected = albedo * std::cosh(k * near) * std::sinh(k * (length - a)) / std::sinh(k * length);
    transmitted = albedo * std::cosh(k * far) * std::sinh(k * a) / std::sinh(k * length);
  }
};

// Two layers, with indices of refraction that fall, rise and stay, in units of 1/3 of the first layer's mean free path.
TEST(MultipoleStack, HasTheTotalsOfTheAddingEquations) {
  const double indices[4][4] = {{1, 1, 1, 1}, {1, 1.4, 1.4, 1}, {1, 1.5, 1.3, 1}, {1.2, 1.1, 1.6, 1.8}};
  for (auto &n : indices)
    for (double first : {0.9, 0.99})
      for (double second : {0.7, 0.999}) {
        const double up = z_b(n[1] / n[0]), between_1 = z_b(n[1] / n[2]), between_2 = z_b(n[2] / n[1]);
        const double down = z_b(n[2] / n[3]), d_1 = 1.5, d_2 = 4;
        const Side from_above(first, d_1, up, between_1), from_below(first, d_1, between_1, up);
        const Side beneath(second, d_2, between_2, down);
        const double left = 1 - from_below.reflected * beneath.reflected;
        const std::vector<ExactLayer> layers = {{3 * (1 - first), 3 * first, 0, n[1], d_1 / 3},
                                                {0.4 * (1 - second), 4 * second, 0.9, n[2], d_2 / 0.4}};
        const double reflected =
            from_above.reflected + from_above.transmitted * beneath.reflected * from_below.transmitted / left;
        const double transmitted = from_above.transmitted * beneath.transmitted / left;
        EXPECT_NEAR(total(layers, false, n[0], n[3]), reflected, 1e-4 * reflected);
        EXPECT_NEAR(total(layers, true, n[0], n[3]), transmitted, 1e-4 * transmitted);
      }
}

// Each white layer adds 1 / T - 1 to the stack's: 64 equal ones in one go.
TEST(MultipoleStack, OfManyWhiteLayersLosesNothing) {
  for (size_t count : {2u, 5u, 64u})
    for (double d : {1.01, 3.0}) {
      const std::vector<ExactLayer> layers(count, {0, 2, 0, 1, d / 2});
      const double one = (1 + z_b(1)) / (d + 2 * z_b(1)), through = 1 / (1 + double(count) * (1 / one - 1));
      EXPECT_NEAR(total(layers, true), through, 1e-4 * through) << count << " " << d;
      EXPECT_NEAR(total(layers, false), 1 - through, 1e-4) << count << " " << d;
    }
}

TEST(MultipoleStack, OnAWhiteHalfSpaceLosesNothing) {
  EXPECT_NEAR(total({{0, 1, 0, 1.4, 3}, {0, 0.3, 0, 1.4, INFINITY}}, false), 1, 3e-4);
}

// What two layers of one medium are off one of twice the thickness, in Donner & Jensen's scheme: not 0, as light enters the
// second one as if it were collimated. By the ratio of 2 d + 2 z_b to 2 d + 3 z_b - 1 where nothing is absorbed.
TEST(MultipoleStack, OfOneMediumIsNearlyOneLayer) {
  for (double d : {2.0, 10.0, 50.0}) {
    const double through = total({{0, 1, 0, 1, 2 * d}}, true);
    EXPECT_NEAR(total({{0, 1, 0, 1, d}, {0, 1, 0, 1, d}}, true) / through,
                (2 * d + 2 * z_b(1)) / (2 * d + 3 * z_b(1) - 1), 2e-3);
  }
}

void expect_same_profile(const BssrdfModel &model, const BssrdfModel &expected, double least) {
  EXPECT_NEAR(model.albedo()[0], expected.albedo()[0], 1e-4 * expected.albedo()[0]);
  const double one = double(expected.profile({1})[0]);
  for (float r : {1e-5f, 0.01f, 0.1f, 0.5f, 1.0f, 2.0f, 5.0f, 10.0f, 20.0f, 50.0f, 100.0f, 1000.0f}) {
    const double value = double(expected.profile({r})[0]);
    if (value > least * one) {
      EXPECT_NEAR(double(model.profile({r})[0]), value, 1e-4 * value) << r;
    }
  }
}

// A black half-space below, and as much as nothing to see of what is below: one layer, which is a sum over images.
TEST(MultipoleStack, OnBlackIsItsTopLayer) {
  for (double albedo : {0.8, 0.999})
    for (double d : {1.6, 4.0}) {
      const std::vector<ExactLayer> top = {{1 - albedo, albedo, 0, 1.4, d}};
      expect_same_profile(stack({top[0], {1, 0, 0, 1.4, INFINITY}}, false), stack(top, false, 1, 1.4), 1e-6);
    }
}

TEST(MultipoleStack, UnderAThickLayerIsNotSeen) {
  const BssrdfModel dipole = half_space_model(TYN_BSSRDF_STANDARD_DIPOLE, 0.9, 1.4);
  const BssrdfModel model = stack({{0.1, 0.9, 0, 1.4, 40}, {0, 0.02, 0, 1.4, INFINITY}}, false);
  EXPECT_NEAR(model.albedo()[0], dipole.albedo()[0], 1e-4);
  expect_same_profile(model, dipole, 1e-6);
}

// Where no boundary reflects, each layer transmits as much upwards as downwards, and so does a stack.
TEST(MultipoleStack, TransmitsAsMuchEitherWayWhereNothingRefracts) {
  const ExactLayer a = {0.02, 3, 0, 1, 0.6}, b = {0.1, 0.9, 0, 1, 5}, c = {0, 0.4, 0, 1, 9};
  const BssrdfModel down = stack({a, b, c}, true), up = stack({c, b, a}, true);
  EXPECT_NEAR(down.albedo()[0], up.albedo()[0], 1e-6 * up.albedo()[0]);
  for (float r : {0.01f, 1.0f, 5.0f, 30.0f, 80.0f})
    EXPECT_NEAR(double(down.profile({r})[0]), double(up.profile({r})[0]), 2e-5 * double(up.profile({r})[0])) << r;
}

// R1' R2 at the imaginary frequency i gamma, where hyperbolic functions become circular ones beyond each layer's falloff.
double loop(double gamma) {
  auto reflected = [gamma](double albedo, double d, double length) {
    const std::complex<double> k = std::sqrt(std::complex<double>(3 * (1 - albedo) - gamma * gamma * length * length));
    const double z = z_b(1);
    return (albedo * std::cosh(k * z) * std::sinh(k * (d - 1 + z)) / std::sinh(k * (d + 2 * z))).real();
  };
  return reflected(0.95, 3, 1) * reflected(0.99, 5, 2);
}

// Far away R and T fall off like K_0 of the slowest mode across the stack: the first gamma where light that goes back and forth
// between the layers makes up for what is lost.
TEST(MultipoleStack, FallsOffLikeItsSlowestMode) {
  double low = 0, high = 0.25; // below the poles of either layer
  ASSERT_LT(loop(low), 1);
  while (loop(high) < 1 && high < 1)
    high *= 1.01;
  for (int i = 0; i < 60; ++i)
    (loop((low + high) / 2) < 1 ? low : high) = (low + high) / 2;
  for (bool transmitted : {false, true}) {
    const BssrdfModel model = stack({{0.05, 0.95, 0, 1, 3}, {0.005, 0.495, 0, 1, 10}}, transmitted);
    for (double r : {30.0, 45.0}) {
      const std::vector<float> values = model.profile({float(r), float(r + 5)});
      const double expected = std::cyl_bessel_k(0.0, low * (r + 5)) / std::cyl_bessel_k(0.0, low * r);
      EXPECT_NEAR(double(values[1]) / double(values[0]), expected, 2e-3 * expected) << transmitted << " " << r;
    }
  }
}

// On an infinite layer, like exp(-falloff r) / r^2 of that one.
TEST(MultipoleStack, OnAHalfSpaceFallsOffLikeIt) {
  const BssrdfModel model = stack({{0.5, 0.5, 0, 1, 2}, {0.01, 0.99, 0, 1, INFINITY}}, false);
  const double falloff = std::sqrt(3 * 0.01);
  const std::vector<float> values = model.profile({60, 70});
  const double expected = std::exp(-10 * falloff) * std::pow(60.0 / 70, 2);
  EXPECT_NEAR(double(values[1]) / double(values[0]), expected, 0.04 * expected);
}

TEST(MultipoleStack, IntegratesToItsAlbedo) {
  for (bool transmitted : {false, true}) {
    const BssrdfModel model = stack({{0.02, 3, 0, 1.4, 0.6}, {0.05, 0.5, 0.3, 1.3, 6}}, transmitted);
    EXPECT_NEAR(plane_integral(model, false), model.albedo()[0], 1e-4 * model.albedo()[0]);
    EXPECT_NEAR(plane_integral(model, true), 1, 1e-4);
  }
}

TEST(MultipoleStack, HasNoScaleOfItsOwn) {
  auto scaled = [](double scale, bool transmitted) {
    return stack({{0.02 / scale, 3 / scale, 0, 1.4, 0.6 * scale}, {0.05 / scale, 0.5 / scale, 0.3, 1.3, 6 * scale}},
                 transmitted);
  };
  for (bool transmitted : {false, true})
    for (float r : {0.01f, 1.0f, 20.0f}) {
      const float expected = scaled(1, transmitted).profile({r})[0];
      EXPECT_EQ(scaled(0x1p20, transmitted).profile({r * 0x1p20f})[0] * 0x1p40f, expected);
      for (double scale : {1e-9, 1e9}) {
        const double value = double(scaled(scale, transmitted).profile({float(double(r) * scale)})[0]) * scale * scale;
        EXPECT_NEAR(value, double(expected), 1e-5 * double(expected)) << scale;
      }
    }
}

// Layers with mean free paths, thicknesses, albedos and indices as far apart as they may be.
TEST(MultipoleStack, IsFiniteAtItsLimits) {
  for (double ratio : {1e-9, 1e-3, 1e3, 1e9})
    for (double albedo : {1e-6, 0.5, 1.0})
      for (double thick : {1.001, 1e3, 1e15})
        for (double ior : {1.0, 4.0})
          for (bool transmitted : {false, true}) {
            const BssrdfModel model = stack({{1 - albedo, albedo, 0, ior, thick},
                                             {0, ratio, 0, 5 - ior, 3 / ratio},
                                             {0.1 * ratio, 0.9 * ratio, 0, 1.2, 1e6 / ratio}},
                                            transmitted);
            EXPECT_GE(model.albedo()[0], 0);
            EXPECT_LE(model.albedo()[0], 1.002) << ratio << " " << albedo << " " << thick << " " << ior;
            float before = INFINITY;
            for (float value : model.profile({1e-30f, 1e-6f, 1e-3f, 1.0f, 1e3f, 1e6f, 1e12f, 1e37f})) {
              EXPECT_TRUE(value >= 0 && value <= before * 1.0001f)
                  << value << " after " << before << ": " << ratio << " " << albedo << " " << thick << " " << ior;
              before = value;
            }
          }
}

TEST(MultipoleStack, LetsNothingThroughAHalfSpace) {
  EXPECT_EQ(total({{0.1, 1, 0, 1, 3}, {0.1, 1, 0, 1, INFINITY}}, true), 0);
}

// Each channel has its own layers.
TEST(MultipoleStack, KeepsChannelsApart) {
  const double absorbing[2][2] = {{0.1, 0.02}, {0.3, 0.01}}, scattering[2][2] = {{2, 3}, {5, 1}};
  TynSlabLayer layers[2] = {tyn_slab_layer(), tyn_slab_layer()};
  for (int i : {0, 1}) {
    layers[i].sigma_a = absorbing[i];
    layers[i].sigma_s = scattering[i];
    layers[i].thickness = 2;
  }
  TynSlab slab = tyn_slab();
  slab.channel_count = slab.layer_count = 2;
  slab.layers = layers;
  TynBssrdfOptions options = tyn_bssrdf_options();
  options.model = TYN_BSSRDF_MULTIPOLE;
  const BssrdfModel both(slab, options);
  for (size_t c : {0u, 1u})
    EXPECT_EQ(
        both.albedo()[c],
        total({{absorbing[0][c], scattering[0][c], 0, 1, 2}, {absorbing[1][c], scattering[1][c], 0, 1, 2}}, false));
}

// A single layer on what refracts more, which other models have no boundary for: the ratio of linear diffusion.
TEST(MultipoleStack, TakesADenserMediumBelow) {
  const double through = (1 + z_b(1.3)) / (4 + z_b(1.3) + z_b(1.3 / 1.7));
  EXPECT_NEAR(total({{0, 1, 0, 1.3, 4}}, true, 1, 1.7), through, 2e-3 * through);
}

} // namespace
