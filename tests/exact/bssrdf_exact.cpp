// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The exact model against closed forms, and S against its own profile.
#include <cmath>

#include <gtest/gtest.h>

#include "common/bssrdf_model.hpp"
#include "common/walk_scene.hpp"
#include "tyndall/tyndall_exact.h"

namespace {

using namespace tyn_test;

// Isotropic scattering, matched index: 1 - H(1) sqrt(1 - albedo) (Chandrasekhar 1960, section 33), R -> 1 in a white medium.
TEST(ExactBssrdf, HasTheAlbedosOfChandrasekhar) {
  for (double albedo : {1e-3, 0.1, 0.5, 0.77, 0.9, 0.99, 0.999, 0.9999, 1.0}) {
    const double one = 1;
    double h = 0;
    ASSERT_EQ(tyn_chandrasekhar_h(albedo, &one, 1, &h), TYN_OK);
    const double expected = 1 - h * std::sqrt(1 - albedo);
    EXPECT_NEAR(half_space_model(TYN_BSSRDF_EXACT, albedo).albedo()[0], expected, 1e-4 * expected) << albedo;
  }
}

// The same of many albedos: each has other rings that are known well, and the faintest of them must not spoil a profile.
TEST(ExactBssrdf, HasAnAlbedoWhateverTheMedium) {
  const size_t channels = 80;
  std::vector<double> sigma_a, sigma_s(channels, 0.95);
  for (size_t i = 0; i < channels; ++i)
    sigma_a.push_back(1e-4 * std::pow(1.1, double(i))); // to 0.19
  TynSlabLayer layer = tyn_slab_layer();
  layer.sigma_a = sigma_a.data();
  layer.sigma_s = sigma_s.data();
  TynSlab slab = tyn_slab();
  slab.channel_count = uint32_t(channels);
  slab.layer_count = 1;
  slab.layers = &layer;
  TynBssrdfOptions options = tyn_bssrdf_options();
  options.model = TYN_BSSRDF_EXACT;
  const std::vector<double> albedos = BssrdfModel(slab, options).albedo();
  for (size_t i = 0; i < channels; ++i) {
    const double albedo = sigma_s[i] / (sigma_a[i] + sigma_s[i]), one = 1;
    double h = 0;
    ASSERT_EQ(tyn_chandrasekhar_h(albedo, &one, 1, &h), TYN_OK);
    const double expected = 1 - h * std::sqrt(1 - albedo);
    EXPECT_NEAR(albedos[i], expected, 1e-4 * expected) << "sigma_a " << sigma_a[i];
  }
}

// Nothing but single scattering is left in a dark medium, and near the beam: sigma_s p(-1) / r at the centre (Hanrahan & Krueger
// 1993 for one order).
TEST(ExactBssrdf, IsSingleScatteringNearTheBeam) {
  const std::vector<float> radii = {1e-4f, 1e-3f};
  const std::vector<float> exact = half_space_model(TYN_BSSRDF_EXACT, 0.8).profile(radii);
  const std::vector<float> single = half_space_model(TYN_BSSRDF_SINGLE_SCATTERING, 0.8).profile(radii);
  EXPECT_NEAR(double(exact[0]) / double(single[0]), 1, 2e-3);
  EXPECT_NEAR(double(exact[1]) / double(single[1]), 1, 2e-2);
  EXPECT_GT(exact[1], single[1]);
}

// A white medium's light falls like r^-3, as that of a source and its image does.
TEST(ExactBssrdf, FallsAsADipoleDoesInAWhiteMedium) {
  const std::vector<float> radii = {300, 600, 1200, 2400};
  const std::vector<float> profile = half_space_model(TYN_BSSRDF_EXACT, 1).profile(radii);
  for (size_t i = 1; i < radii.size(); ++i)
    EXPECT_NEAR(double(profile[i - 1]) / double(profile[i]), 8, 0.05) << radii[i];
}

// Next to no scattering, down to what rounding swallows: single scattering is all there is.
TEST(ExactBssrdf, IsSingleScatteringInBlackMedia) {
  for (double sigma_s : {1e-3, 1e-8, 1e-14, 1e-17, 1e-30}) {
    ExactSlab slab({{1, sigma_s, 0, 1.4, INFINITY}});
    TynBssrdfOptions options = tyn_bssrdf_options();
    options.model = TYN_BSSRDF_SINGLE_SCATTERING;
    const BssrdfModel single(slab.view(), options);
    options.model = TYN_BSSRDF_EXACT;
    options.exact_events = FEW_EVENTS;
    const BssrdfModel exact(slab.view(), options);
    EXPECT_NEAR(exact.albedo()[0], single.albedo()[0], 2e-3 * single.albedo()[0]) << sigma_s;
    for (float r : {0.01f, 0.3f})
      EXPECT_NEAR(double(exact.profile({r})[0]), double(single.profile({r})[0]), 5e-3 * double(single.profile({r})[0]));
  }
}

// All pairs of indices are taken, whatever their quotients round to.
TEST(ExactBssrdf, TakesEveryPairOfIndices) {
  for (int i = 0; i < 12; ++i) {
    const double above = 1.27 + 0.0103 * i * i;
    ExactSlab slab({{0.1, 0.9, 0, 1, INFINITY}}, above);
    TynBssrdfOptions options = tyn_bssrdf_options();
    options.model = TYN_BSSRDF_EXACT;
    options.exact_events = 1000000;
    EXPECT_GT(BssrdfModel(slab.view(), options).albedo()[0], 0) << above;
  }
}

} // namespace
