// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Adding-doubling against published values and identities. tests/peers compares it with another program.
#include <gtest/gtest.h>

#include <cmath>

#include "common/exact_slab.hpp"

using tyn_test::ExactLayer;
using tyn_test::ExactSlab;
using tyn_test::integral;

namespace {

constexpr double deep = INFINITY;

double fresnel_normal(double n) { return (n - 1) * (n - 1) / ((n + 1) * (n + 1)); }

// With both polarizations written in angles (air to n)
double fresnel(double n, double mu) {
  const double in = std::acos(mu), out = std::asin(std::sin(in) / n);
  if (in < 1e-6)
    return fresnel_normal(n);
  const double s = std::sin(in - out) / std::sin(in + out), p = std::tan(in - out) / std::tan(in + out);
  return (s * s + p * p) / 2;
}

const std::vector<ExactLayer> skin_like = {{0.1, 10, 0.8, 1.4, 0.1}, {1, 10, 0.9, 1.5, 0.3}, {0.1, 20, 0.7, 1.33, 0.5}};

} // namespace

// van de Hulst 1980; the digits beyond his from an independent solver.
TEST(AddingDoubling, SlabOfVanDeHulst) {
  const TynAddingDoublingResult result = ExactSlab({{1, 9, 0.75, 1, 0.2}}).solve();
  EXPECT_NEAR(result.reflectance, 0.097395, 1e-6);
  EXPECT_NEAR(result.transmittance, 0.660958, 1e-6);
  EXPECT_NEAR(result.absorbed, 1 - 0.097395 - 0.660958, 2e-6);
  EXPECT_EQ(result.specular_reflectance, 0);
  EXPECT_DOUBLE_EQ(result.direct_transmittance, std::exp(-2.0));
  EXPECT_LT(result.accuracy, 1e-6);
}

// Giovanelli 1955; the digits beyond his from an independent solver.
TEST(AddingDoubling, HalfSpaceOfGiovanelli) {
  const TynAddingDoublingResult normal = ExactSlab({{1, 9, 0, 1.5, deep}}).solve();
  EXPECT_NEAR(normal.reflectance, 0.259919, 1e-6);
  EXPECT_NEAR(normal.specular_reflectance, 0.04, 1e-15);
  EXPECT_EQ(normal.transmittance, 0);
  EXPECT_NEAR(ExactSlab({{1, 9, 0, 1.5, deep}}).diffuse().solve().reflectance, 0.307890, 1e-6);
}

// Radiative equilibrium between black plates (Heaslet & Warming 1965): the flux is what a white isotropic layer transmits.
// Their table is of an approximation that is good to 3e-4.
TEST(AddingDoubling, WhiteIsotropicLayersUnderDiffuseLight) {
  const double published[][2] = {{0.1, 0.9157}, {0.5, 0.7040}, {1.0, 0.5532}, {2.0, 0.3900}};
  for (const auto &row : published) {
    ExactSlab slab({{0, 1, 0, 1, row[0]}});
    EXPECT_NEAR(slab.diffuse().solve().transmittance, row[1], 3e-4) << row[0];
  }
}

TEST(AddingDoubling, IsotropicHalfSpaceHasTheBrdfOfChandrasekhar) {
  const std::vector<double> cosines{0.001, 0.05, 0.2, 0.5, 0.8, 1.0};
  for (double albedo : {0.3, 0.9, 0.999999, 1.0})
    for (double angle : {0.0, 1.0, 1.55}) {
      ExactSlab slab({{1 - albedo, albedo, 0, 1, deep}});
      const TynAddingDoublingResult result = slab.angle(angle).cosines(cosines).solve();
      double directional = NAN;
      ASSERT_EQ(tyn_half_space_albedo(albedo, std::cos(angle), &directional), TYN_OK);
      EXPECT_NEAR(result.reflectance, directional, 1e-6);
      double brdf[6];
      ASSERT_EQ(tyn_half_space_brdf(albedo, std::cos(angle), cosines.data(), 6, brdf), TYN_OK);
      for (size_t i = 0; i < cosines.size(); i++) {
        EXPECT_NEAR(slab.reflected[i] / cosines[i], brdf[i], 1e-6) << albedo << " " << angle << " " << cosines[i];
        EXPECT_EQ(slab.transmitted[i], 0);
      }
    }
}

TEST(AddingDoubling, NothingIsLostWithoutAbsorption) {
  for (double g : {-0.5, 0.0, 0.8, 0.95})
    for (double ior : {1.0, 1.5})
      for (double thickness : {1e-6, 0.1, 10.0, 1e4, 1e9, 1e20}) {
        const TynAddingDoublingResult result = ExactSlab({{0, 1, g, ior, thickness}}, 1, 1.2).angle(0.5).solve();
        EXPECT_NEAR(result.reflectance + result.transmittance, 1, 1e-9) << g << " " << ior << " " << thickness;
      }
}

TEST(AddingDoubling, AWhiteHalfSpaceReturnsEverything) {
  for (double g : {0.0, 0.5, 0.95})
    for (double ior : {1.0, 1.5}) {
      EXPECT_NEAR(ExactSlab({{0, 3, g, ior, deep}}).angle(0.3).solve().reflectance, 1, 1e-8) << g << " " << ior;
      EXPECT_NEAR(ExactSlab({{0, 3, g, ior, deep}}).diffuse().solve().reflectance, 1, 1e-8) << g << " " << ior;
    }
}

// White furnace: in uniform light a white half-space shows that same radiance in every direction, Fresnel's part of it
// reflected and the rest scattered.
TEST(AddingDoubling, WhiteFurnace) {
  const std::vector<double> cosines{0.01, 0.3, 0.7, 1.0};
  ExactSlab slab({{0, 1, 0.5, 1.5, 2.0}, {0, 1, 0, 1.3, deep}});
  slab.diffuse().tolerance(1e-9).cosines(cosines).solve();
  for (size_t i = 0; i < cosines.size(); i++) {
    const double mu = cosines[i];
    // unscattered light also comes back from the second interface, weakened: at most 5e-5 here
    EXPECT_NEAR(slab.reflected[i], mu * (1 - fresnel(1.5, mu)) / M_PI, 1e-3) << mu;
  }
  ExactSlab alone({{0, 1, 0.5, 1.5, deep}});
  alone.diffuse().tolerance(1e-9).cosines(cosines).solve();
  for (size_t i = 0; i < cosines.size(); i++)
    EXPECT_NEAR(alone.reflected[i], cosines[i] * (1 - fresnel(1.5, cosines[i])) / M_PI, 1e-8) << cosines[i];
}

// Unscattered light: a plate, and Stokes' 1862 pile of plates, R = 2 m F / (1 + (2 m - 1) F).
TEST(AddingDoubling, ClearGlass) {
  const double f = fresnel_normal(1.5);
  const TynAddingDoublingResult plate = ExactSlab({{0, 0, 0, 1.5, 1}}).solve();
  EXPECT_NEAR(plate.reflectance, 2 * f / (1 + f), 1e-15);
  EXPECT_NEAR(plate.transmittance, (1 - f) / (1 + f), 1e-15);
  const ExactLayer glass{0, 0, 0, 1.5, 1}, air{0, 0, 0, 1, 1};
  const TynAddingDoublingResult pile = ExactSlab({glass, air, glass, air, glass}).solve();
  EXPECT_NEAR(pile.reflectance, 6 * f / (1 + 5 * f), 1e-15);
  EXPECT_NEAR(pile.specular_reflectance, 6 * f / (1 + 5 * f), 1e-15);
  EXPECT_NEAR(pile.direct_transmittance, 1 - 6 * f / (1 + 5 * f), 1e-15);

  const double e = std::exp(-0.5);
  const TynAddingDoublingResult dark = ExactSlab({{0.5, 0, 0, 1.5, 1}}).solve();
  EXPECT_NEAR(dark.transmittance, (1 - f) * (1 - f) * e / (1 - f * f * e * e), 1e-15);
}

TEST(AddingDoubling, ClearGlassUnderDiffuseLight) {
  const TynAddingDoublingResult result = ExactSlab({{0.3, 0, 0, 1.5, 1}}).diffuse().tolerance(1e-9).solve();
  const auto part = [](double mu, bool through) {
    const double f = fresnel(1.5, mu), inside = std::sqrt(1 - (1 - mu * mu) / 2.25), e = std::exp(-0.3 / inside);
    const double t = (1 - f) * (1 - f) * e / (1 - f * f * e * e);
    return 2 * mu * (through ? t : f + f * e * t);
  };
  const double r = integral([&](double mu) { return part(mu, false); });
  const double t = integral([&](double mu) { return part(mu, true); });
  EXPECT_NEAR(result.reflectance, r, 1e-9);
  EXPECT_NEAR(result.transmittance, t, 1e-9);
  EXPECT_NEAR(result.specular_reflectance, r, 1e-9);
  EXPECT_NEAR(result.direct_transmittance, t, 1e-9);
}

TEST(AddingDoubling, TotalReflection) {
  const TynAddingDoublingResult result = ExactSlab({{1, 9, 0, 1, 1}}, 1.5, 1.5).angle(0.8).solve();
  EXPECT_EQ(result.reflectance, 1);
  EXPECT_EQ(result.specular_reflectance, 1);
  // 41.8 degrees: beyond that angle nothing of what is scattered gets out
  ExactSlab slab({{1, 9, 0, 1, 1}}, 1.5, 1.5);
  slab.cosines({0.7, 0.8}).solve();
  EXPECT_EQ(slab.reflected[0], 0);
  EXPECT_EQ(slab.transmitted[0], 0);
  EXPECT_GT(slab.reflected[1], 0);
}

TEST(AddingDoubling, ALayerCutInPiecesIsTheSameLayer) {
  for (double ior : {1.0, 1.4}) {
    const TynAddingDoublingResult whole = ExactSlab({{0.5, 4, 0.6, ior, 1}}).angle(0.7).tolerance(1e-8).solve();
    const ExactLayer thin{0.5, 4, 0.6, ior, 0.1}, thick{0.5, 4, 0.6, ior, 0.4}, mid{0.5, 4, 0.6, ior, 0.25};
    const TynAddingDoublingResult cut = ExactSlab({thin, thick, mid, mid}).angle(0.7).tolerance(1e-8).solve();
    EXPECT_NEAR(cut.reflectance, whole.reflectance, 1e-8);
    EXPECT_NEAR(cut.transmittance, whole.transmittance, 1e-8);
    EXPECT_NEAR(cut.direct_transmittance, whole.direct_transmittance, 1e-14);
  }
}

// Diffuse light: n^2 T is the same from both sides.
TEST(AddingDoubling, TransmittanceIsReciprocal) {
  const std::vector<ExactLayer> flipped(skin_like.rbegin(), skin_like.rend());
  const double down = ExactSlab(skin_like, 1, 1.6).diffuse().tolerance(1e-8).solve().transmittance;
  const double up = ExactSlab(flipped, 1.6, 1).diffuse().tolerance(1e-8).solve().transmittance;
  EXPECT_NEAR(down, 1.6 * 1.6 * up, 1e-8);
}

TEST(AddingDoubling, TheBrdfIsReciprocal) {
  const double a = 0.3, b = 1.1;
  ExactSlab one(skin_like), other(skin_like);
  one.angle(a).cosines({std::cos(b)}).solve();
  other.angle(b).cosines({std::cos(a)}).solve();
  EXPECT_NEAR(one.reflected[0] / std::cos(b), other.reflected[0] / std::cos(a), 1e-6);
}

TEST(AddingDoubling, AngularOutputAddsUp) {
  std::vector<double> cosines;
  for (int i = 0; i < 300; i++) // more than are done at once; midpoints
    cosines.push_back((i + 0.5) / 300);
  ExactSlab slab({{0.5, 4, 0.3, 1.4, 1}}, 1, 1.2);
  const TynAddingDoublingResult result = slab.angle(0.4).cosines(cosines).solve();
  double up = 0, down = 0;
  for (size_t i = 0; i < cosines.size(); i++) {
    up += 2 * M_PI * slab.reflected[i] / 300;
    down += 2 * M_PI * slab.transmitted[i] / 300;
  }
  EXPECT_NEAR(up, result.reflectance - result.specular_reflectance, 1e-5);
  EXPECT_NEAR(down, result.transmittance - result.direct_transmittance, 1e-5);
}

// The same phase function by other names.
TEST(AddingDoubling, PhaseFunctionsThatAreAlikeActAlike) {
  TynPhase rayleigh = tyn_phase(), draine = tyn_phase(), table = tyn_phase();
  rayleigh.kind = TYN_PHASE_RAYLEIGH;
  draine.kind = TYN_PHASE_DRAINE;
  draine.alpha = 1;
  std::vector<double> cosines, values;
  for (int i = 0; i <= 8000; i++) {
    cosines.push_back(-1 + i / 4000.0);
    values.push_back(1 + cosines.back() * cosines.back());
  }
  table.kind = TYN_PHASE_TABULATED;
  table.cosines = cosines.data();
  table.values = values.data();
  table.count = 8001;
  const auto solve = [](const TynPhase &phase) { return ExactSlab({{0.1, 1, 0, 1.3, 2, &phase}}).angle(0.5).solve(); };
  const TynAddingDoublingResult expected = solve(rayleigh);
  for (const TynPhase &phase : {draine, table}) {
    EXPECT_NEAR(solve(phase).reflectance, expected.reflectance, 2e-8);
    EXPECT_NEAR(solve(phase).transmittance, expected.transmittance, 2e-8);
  }
}

// A lobe that is all but straight on does nothing: half of the scattering is not there.
TEST(AddingDoubling, AForwardPeakIsNoScattering) {
  TynPhase peaked = tyn_phase();
  peaked.kind = TYN_PHASE_TWO_LOBE;
  peaked.g = 0.9999999;
  peaked.g2 = 0.3;
  peaked.weight = 0.5;
  for (double ior : {1.0, 1.5}) {
    const TynAddingDoublingResult a = ExactSlab({{0.1, 4, 0, ior, 1, &peaked}}).solve();
    const TynAddingDoublingResult b = ExactSlab({{0.1, 2, 0.3, ior, 1}}).solve();
    EXPECT_NEAR(a.reflectance, b.reflectance, 1e-6);
    EXPECT_NEAR(a.transmittance, b.transmittance, 1e-6);
  }
}

TEST(AddingDoubling, AThickLayerIsAHalfSpace) {
  for (double g : {0.0, 0.95}) {
    const TynAddingDoublingResult thick = ExactSlab({{0.1, 10, g, 1.4, 1e6}}).solve();
    const TynAddingDoublingResult half = ExactSlab({{0.1, 10, g, 1.4, deep}}).solve();
    EXPECT_NEAR(thick.reflectance, half.reflectance, 1e-9);
    EXPECT_LT(thick.transmittance, 1e-100);
  }
  EXPECT_EQ(ExactSlab({{1, 0, 0, 1, deep}}).solve().reflectance, 0);
  EXPECT_EQ(ExactSlab({{0, 0, 0, 1, deep}}).solve().reflectance, 0);
}

TEST(AddingDoubling, SaysWhatItReached) {
  ExactSlab slab({{0.1, 10, 0.99, 1.4, 1}});
  slab.options.max_nodes = 16;
  const TynAddingDoublingResult rough = slab.tolerance(1e-9).solve();
  EXPECT_GT(rough.accuracy, 1e-9);
  EXPECT_LE(rough.nodes, 16u);
}

TEST(AddingDoubling, ReadsTheChannelAndTheDefaults) {
  const double sigma_a[2] = {5, 1}, sigma_s[2] = {1, 9};
  TynSlabLayer layer = tyn_slab_layer();
  layer.sigma_a = sigma_a;
  layer.sigma_s = sigma_s;
  layer.g = 0.75;
  layer.thickness = 0.2;
  TynSlab slab = tyn_slab();
  slab.channel_count = 2;
  slab.layer_count = 1;
  slab.layers = &layer;
  TynAddingDoublingResult result;
  result.size = sizeof result;
  TynAddingDoublingOptions options = tyn_adding_doubling_options();
  options.channel = 1;
  ASSERT_EQ(tyn_adding_doubling(&slab, &options, &result, nullptr, nullptr, nullptr, 0), TYN_OK);
  EXPECT_NEAR(result.reflectance, 0.097395, 1e-6);
  ASSERT_EQ(tyn_adding_doubling(&slab, nullptr, &result, nullptr, nullptr, nullptr, 0), TYN_OK);
  EXPECT_LT(result.reflectance, 0.03);
}
