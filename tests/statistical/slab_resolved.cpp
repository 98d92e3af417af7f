// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// What the slab engine resolves against an independent program (tests/common/plain_slab.c) and against closed forms. Bins are
// compared at 5 standard errors: of 2000 bins one is beyond by chance once in 870 times.
#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "common/plain_slab.h"
#include "common/slab_run.hpp"

namespace {

using namespace tyn_test;

constexpr double pi = 3.14159265358979324;
constexpr uint64_t photons = 2000000;

TynSlabOptions resolved_options(uint64_t seed) {
  TynSlabOptions options = slab_options(photons, seed);
  options.radial_max = options.depth_max = options.path_max = 2;
  options.radial_bins = PLAIN_RINGS;
  options.angular_bins = PLAIN_ANGLES;
  options.radial_angular = 1;
  options.depth_bins = PLAIN_DEPTHS;
  options.path_bins = PLAIN_PATHS;
  options.order_bins = PLAIN_ORDERS;
  return options;
}

// A fraction that the other program counted from `photons` walks has about the error of a count of the same mean, which is what
// the engine's own error is; empty bins have none.
void expect_alike(double value, double error, double other, double size, const char *what, size_t bin) {
  const double floor = 8 / double(photons) / size; // a few photons: bins that expect one may hold none, or eight
  EXPECT_NEAR(value, other / double(photons) / size, 5 * std::sqrt(2.0) * error + floor) << what << " bin " << bin;
}

TEST(ResolvedSlab, AgreesWithAPlainWalk) {
  ExactSlab slab({{1, 9, 0.75, 1.4, INFINITY}});
  const SlabOutcome outcome = simulate(slab.view(), resolved_options(31));
  auto plain = std::make_unique<PlainTallies>();
  const PlainSlab medium = {1, 9, 0.75, 1.4};
  plain_slab(&medium, photons, 32, 1, plain.get());

  auto compare = [&](uint32_t quantity, size_t bin, double other, double size, const char *what) {
    expect_alike(outcome.value(quantity)[bin], outcome.error(quantity)[bin], other, size, what, bin);
  };
  const double width = 2.0 / PLAIN_RINGS;
  for (size_t i = 0; i < PLAIN_RINGS; ++i)
    compare(TYN_SLAB_RADIAL_REFLECTANCE, i, plain->radial[i], pi * width * width * double(2 * i + 1), "radius");
  std::vector<double> solid_angles;
  for (size_t i = 0; i < PLAIN_ANGLES; ++i) {
    const double step = pi / 2 / PLAIN_ANGLES;
    solid_angles.push_back(2 * pi * (std::cos(double(i) * step) - std::cos(double(i + 1) * step)));
    compare(TYN_SLAB_ANGULAR_REFLECTANCE, i, plain->angular[i], solid_angles[i], "angle");
  }
  for (size_t i = 0; i < PLAIN_RINGS; ++i)
    for (size_t k = 0; k < PLAIN_ANGLES; ++k)
      compare(TYN_SLAB_RADIAL_ANGULAR_REFLECTANCE, i * PLAIN_ANGLES + k, plain->both[i][k],
              pi * width * width * double(2 * i + 1) * solid_angles[k], "radius and angle");
  for (size_t i = 0; i < PLAIN_DEPTHS; ++i)
    compare(TYN_SLAB_DEPTH_ABSORBED, i, plain->depth[i], width, "depth");
  for (size_t i = 0; i < PLAIN_PATHS; ++i)
    compare(TYN_SLAB_PATH_REFLECTANCE, i, plain->path[i], width, "path length");
  for (size_t i = 1; i < PLAIN_ORDERS; ++i)
    compare(TYN_SLAB_ORDER_REFLECTANCE, i, plain->order[i], 1, "order");
}

// The parts add up to the whole: photons are the same, so this holds to rounding.
TEST(ResolvedSlab, BinsAddUpToTheTotals) {
  ExactSlab slab({{0.5, 9, 0.5, 1.4, 0.1}, {1, 4, 0, 1, 0.2}}, 1, 1.5);
  TynSlabOptions options = resolved_options(33);
  options.photons = 200000;
  options.radial_max = options.path_max = 1000;
  options.depth_max = 0.3;
  options.order_bins = 5000;
  const SlabOutcome outcome = simulate(slab.view(), options);
  const TynSlabTotals &totals = outcome.totals[0];
  auto sum = [&](uint32_t quantity, const std::function<double(size_t)> &size) {
    double all = 0;
    for (size_t i = 0; i < outcome.value(quantity).size(); ++i)
      all += outcome.value(quantity)[i] * size(i);
    return all;
  };
  const double ring = 1000.0 / PLAIN_RINGS;
  auto area = [&](size_t i) { return pi * ring * ring * double(2 * i + 1); };
  auto solid_angle = [&](size_t i) {
    const double step = pi / 2 / PLAIN_ANGLES;
    return 2 * pi * (std::cos(double(i) * step) - std::cos(double(i + 1) * step));
  };
  auto both = [&](size_t i) { return area(i / PLAIN_ANGLES) * solid_angle(i % PLAIN_ANGLES); };
  auto one = [](size_t) { return 1.0; };
  const double diffuse[2] = {totals.diffuse_reflectance.value, totals.diffuse_transmittance.value};
  const double all[2] = {totals.reflectance.value, totals.transmittance.value};
  for (uint32_t side = 0; side < 2; ++side) {
    EXPECT_NEAR(sum(TYN_SLAB_RADIAL_REFLECTANCE + side, area), diffuse[side], 1e-9);
    EXPECT_NEAR(sum(TYN_SLAB_ANGULAR_REFLECTANCE + side, solid_angle), diffuse[side], 1e-9);
    EXPECT_NEAR(sum(TYN_SLAB_RADIAL_ANGULAR_REFLECTANCE + side, both), diffuse[side], 1e-9);
    EXPECT_NEAR(sum(TYN_SLAB_PATH_REFLECTANCE + side, [&](size_t) { return 1000.0 / PLAIN_PATHS; }), diffuse[side],
                1e-9);
    EXPECT_NEAR(sum(TYN_SLAB_ORDER_REFLECTANCE + side, one), all[side], 1e-9);
  }
  EXPECT_NEAR(sum(TYN_SLAB_LAYER_ABSORBED, one), totals.absorbed.value, 1e-12);
  // roulette is in the one and not in the other: equal within the error of either
  EXPECT_NEAR(sum(TYN_SLAB_DEPTH_ABSORBED, [&](size_t) { return 0.3 / PLAIN_DEPTHS; }), totals.absorbed.value,
              4 * totals.absorbed.standard_error);
}

// No scattering: the fluence is that of the beam, exp(-sigma_a z / mu) / mu, in clear layers too.
TEST(ResolvedSlab, FluenceOfAnUnscatteredBeam) {
  const double angle = 0.5, mu = std::cos(angle);
  ExactSlab slab({{0, 0, 0, 1, 0.5}, {2, 0, 0, 1, 1}});
  TynSlabOptions options = slab_options(1000000, 34);
  options.angle = angle;
  options.depth_max = 1.5;
  options.depth_bins = 15;
  const SlabOutcome outcome = simulate(slab.view(), options);
  for (size_t i = 0; i < 15; ++i) {
    const double low = std::max(0.0, double(i) * 0.1 - 0.5), high = std::max(0.0, double(i + 1) * 0.1 - 0.5);
    const double attenuated = (std::exp(-2 * low / mu) - std::exp(-2 * high / mu)) / 0.2;
    const double expected = i < 5 ? 1 / mu : attenuated;
    EXPECT_NEAR(outcome.value(TYN_SLAB_DEPTH_FLUENCE)[i], expected,
                4.5 * outcome.error(TYN_SLAB_DEPTH_FLUENCE)[i] + 1e-4)
        << i;
    EXPECT_NEAR(outcome.value(TYN_SLAB_DEPTH_ABSORBED)[i], i < 5 ? 0 : 2 * expected,
                9 * outcome.error(TYN_SLAB_DEPTH_FLUENCE)[i] + 1e-6)
        << i;
  }
}

// White slabs between equal media: the mean path length under diffuse light is 4 V / S = 2 d for any scattering.
TEST(ResolvedSlab, MeanPathLengthOfAWhiteSlab) {
  ExactSlab slab({{0, 5, 0.6, 1, 1}});
  TynSlabOptions options = slab_options(4000000, 35);
  options.incidence = TYN_INCIDENCE_DIFFUSE;
  options.depth_max = 1;
  options.depth_bins = 1;
  const SlabOutcome outcome = simulate(slab.view(), options);
  // the fluence integrated over the depth is the mean path length
  EXPECT_NEAR(outcome.value(TYN_SLAB_DEPTH_FLUENCE)[0], 2, 4 * outcome.error(TYN_SLAB_DEPTH_FLUENCE)[0]);
  EXPECT_LT(outcome.error(TYN_SLAB_DEPTH_FLUENCE)[0], 2e-3);
}

// Absorption goes to the layer that absorbs: the same events give it as an average over the depths.
TEST(ResolvedSlab, AbsorptionGoesToItsLayer) {
  ExactSlab slab({{0.7, 3, 0.5, 1.3, 0.5}, {0.1, 6, 0, 1.5, 1}, {2, 1, -0.5, 1, 0.5}});
  TynSlabOptions options = slab_options(1000000, 37);
  options.depth_max = 2;
  options.depth_bins = 4;
  const SlabOutcome outcome = simulate(slab.view(), options);
  const std::vector<double> &depth = outcome.value(TYN_SLAB_DEPTH_ABSORBED),
                            &error = outcome.error(TYN_SLAB_DEPTH_ABSORBED);
  const double expected[3] = {0.5 * depth[0], 0.5 * (depth[1] + depth[2]), 0.5 * depth[3]};
  const double errors[3] = {0.5 * error[0], 0.5 * (error[1] + error[2]), 0.5 * error[3]};
  for (size_t i = 0; i < 3; ++i) {
    const double both = errors[i] + outcome.error(TYN_SLAB_LAYER_ABSORBED)[i];
    EXPECT_NEAR(outcome.value(TYN_SLAB_LAYER_ABSORBED)[i], expected[i], 4 * both) << i;
    EXPECT_LT(both, 0.01 * expected[i]) << i;
  }
}

// Light of order 0 alone is the beam, and its fluence that of Beer's law; with order 1 the first scattered light joins it.
TEST(ResolvedSlab, FluenceOfLimitedOrders) {
  ExactSlab slab({{0.25, 0.75, 0, 1, 1}});
  TynSlabOptions options = slab_options(1000000, 38);
  options.max_order = 1;
  options.depth_max = 1;
  options.depth_bins = 1;
  const SlabOutcome outcome = simulate(slab.view(), options);
  // beam: 1 - exp(-1). Scattered once at depth z, isotropically: a mean path of (2 - E2(z) - E2(1 - z)) / 2 within the slab
  const auto e2 = [](double x) { return integral([x](double u) { return std::exp(-x / u); }); };
  const double once = integral([&](double z) { return 0.75 * std::exp(-z) * (2 - e2(z) - e2(1 - z)) / 2; });
  EXPECT_NEAR(outcome.value(TYN_SLAB_DEPTH_FLUENCE)[0], 1 - std::exp(-1.0) + once,
              4 * outcome.error(TYN_SLAB_DEPTH_FLUENCE)[0]);
}

// Albedos so near 1 that events absorb walks as a whole, in a half-space and in a stack where others lose weight.
TEST(ResolvedSlab, AlbedosNextToOne) {
  ExactSlab deep({{2e-6, 1, 0.2, 1.4, INFINITY}});
  EXPECT_LT(std::abs(deviation(simulate(deep.view(), slab_options(200000, 39)).totals[0].reflectance,
                               deep.solve().reflectance)),
            4);
  ExactSlab stack({{1e-5, 10, 0, 1.4, 20}, {0.5, 1, 0.3, 1, 1}});
  const TynSlabTotals totals = simulate(stack.view(), slab_options(400000, 40)).totals[0];
  const TynAddingDoublingResult exact = stack.solve();
  EXPECT_LT(std::abs(deviation(totals.reflectance, exact.reflectance)), 4);
  EXPECT_LT(std::abs(deviation(totals.transmittance, exact.transmittance)), 4);
  EXPECT_LT(std::abs(deviation(totals.absorbed, exact.absorbed)), 4);
}

// A disc and a Gaussian beam are the pencil beam's R(r) spread out: what does not interact leaves where it arrived.
TEST(ResolvedSlab, BeamsArriveWhereTheyShould) {
  ExactSlab slab({{0, 1e-3, 0, 1, 1e-3}});
  TynSlabOptions options = slab_options(4000000, 36);
  options.radial_max = 3;
  options.radial_bins = 6;
  options.beam_radius = 1;
  const double thickness = 1e-6; // of which half comes out above
  for (uint32_t beam : {TYN_BEAM_DISC, TYN_BEAM_GAUSSIAN}) {
    ExactSlab thin({{0, 1000, 0, 1, thickness * 10}});
    options.beam = beam;
    const SlabOutcome outcome = simulate(thin.view(), options);
    const double total = outcome.totals[0].diffuse_reflectance.value;
    for (size_t i = 0; i < 6; ++i) {
      const double a = 0.5 * double(i), b = a + 0.5;
      const double share = beam == TYN_BEAM_DISC ? std::min(1.0, b * b) - std::min(1.0, a * a)
                                                 : std::exp(-2 * a * a) - std::exp(-2 * b * b);
      const double area = pi * (b * b - a * a);
      EXPECT_NEAR(outcome.value(TYN_SLAB_RADIAL_REFLECTANCE)[i], total * share / area,
                  5 * outcome.error(TYN_SLAB_RADIAL_REFLECTANCE)[i] + 0.01 * total)
          << "beam " << beam << " ring " << i;
    }
  }
}

} // namespace
