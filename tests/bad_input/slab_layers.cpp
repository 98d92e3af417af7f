// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Slabs and options that the exact solvers refuse, and the closed forms outside their range.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

#include "tyndall/tyndall_exact.h"

namespace {

// Two layers, two channels.
struct Problem {
  double sigma_a[2][2] = {{1, 2}, {3, 4}}, sigma_s[2][2] = {{1, 2}, {3, 4}};
  double cosines[2] = {0.5, 1};
  TynPhase phase = tyn_phase();
  TynSlabLayer layers[2] = {tyn_slab_layer(), tyn_slab_layer()};
  TynSlab slab = tyn_slab();
  TynAddingDoublingOptions options = tyn_adding_doubling_options();
  TynAddingDoublingResult result;
  char message[256] = "";

  Problem() {
    for (int i = 0; i < 2; i++) {
      layers[i].sigma_a = sigma_a[i];
      layers[i].sigma_s = sigma_s[i];
    }
    layers[0].thickness = 1;
    slab.layers = layers;
    slab.layer_count = 2;
    slab.channel_count = 2;
    options.cosines = cosines;
    options.cosine_count = 2;
    result.size = sizeof result;
  }

  TynStatus solve() { return tyn_adding_doubling(&slab, &options, &result, nullptr, nullptr, message, sizeof message); }
};

struct Case {
  std::function<void(Problem &)> spoil;
  const char *message;
};

void expect_refused(const std::vector<Case> &cases) {
  Problem good;
  EXPECT_EQ(good.solve(), TYN_OK) << good.message;
  for (const Case &bad : cases) {
    Problem problem;
    bad.spoil(problem);
    problem.result.reflectance = -7;
    EXPECT_EQ(problem.solve(), TYN_ERROR_INVALID_ARGUMENT) << bad.message;
    EXPECT_NE(std::string(problem.message).find(bad.message), std::string::npos)
        << "'" << bad.message << "' is not in '" << problem.message << "'";
    EXPECT_EQ(problem.result.reflectance, -7);
  }
}

} // namespace

TEST(BadSlab, Layers) {
  expect_refused({
      {[](Problem &p) { p.layers[0].sigma_a = nullptr; }, "layers[0].sigma_a is NULL"},
      {[](Problem &p) { p.layers[1].sigma_s = nullptr; }, "layers[1].sigma_s is NULL"},
      {[](Problem &p) { p.sigma_a[0][1] = -1; }, "layers[0].sigma_a[1] is -1"},
      {[](Problem &p) { p.sigma_a[1][0] = NAN; }, "layers[1].sigma_a[0] is nan"},
      {[](Problem &p) { p.sigma_s[1][1] = INFINITY; }, "layers[1].sigma_s[1] is inf"},
      {[](Problem &p) { p.sigma_s[0][0] = p.sigma_a[0][0] = 6e29; }, "layers[0].sigma_a[0] + sigma_s[0] is 6e+29"},
      {[](Problem &p) { p.layers[0].g = 1; }, "layers[0].g is 1"},
      {[](Problem &p) { p.layers[0].g = -1; }, "layers[0].g is -1"},
      {[](Problem &p) { p.layers[0].g = NAN; }, "layers[0].g is nan"},
      {[](Problem &p) { p.layers[1].ior = 0.99; }, "layers[1].ior is 0.99"},
      {[](Problem &p) { p.layers[1].ior = 4.1; }, "layers[1].ior is 4.1"},
      {[](Problem &p) { p.layers[1].ior = NAN; }, "layers[1].ior is nan"},
      {[](Problem &p) { p.layers[0].thickness = 0; }, "layers[0].thickness is 0"},
      {[](Problem &p) { p.layers[0].thickness = -1; }, "layers[0].thickness is -1"},
      {[](Problem &p) { p.layers[1].thickness = NAN; }, "layers[1].thickness is nan"},
      {[](Problem &p) { p.layers[0].thickness = INFINITY; }, "layers[0].thickness is inf"},
      {[](Problem &p) { p.layers[0].size = 0; }, "TynSlabLayer::size is 0"},
      {[](Problem &p) { p.layers[0].size += 8; }, "later version"},
      {[](Problem &p) { p.layers[1].size = 8; }, "layers[1].size is 8"},
  });
}

TEST(BadSlab, PhaseFunctions) {
  expect_refused({
      {[](Problem &p) {
         p.phase.kind = TYN_PHASE_KIND_COUNT;
         p.layers[1].phase = &p.phase;
       },
       "layers[1].phase"},
      {[](Problem &p) {
         p.phase.kind = TYN_PHASE_HENYEY_GREENSTEIN;
         p.phase.g = 1;
         p.layers[0].phase = &p.phase;
       },
       "layers[0].phase"},
      {[](Problem &p) {
         p.phase.size = 1;
         p.layers[0].phase = &p.phase;
       },
       "layers[0].phase"},
  });
}

TEST(BadSlab, Stack) {
  expect_refused({
      {[](Problem &p) { p.slab.size = 4; }, "TynSlab::size is 4"},
      {[](Problem &p) { p.slab.layer_count = 0; }, "layer_count is 0"},
      {[](Problem &p) { p.slab.layer_count = 65; }, "layer_count is 65"},
      {[](Problem &p) { p.slab.channel_count = 0; }, "channel_count is 0"},
      {[](Problem &p) { p.slab.channel_count = 1025; }, "channel_count is 1025"},
      {[](Problem &p) { p.slab.layers = nullptr; }, "layers is NULL"},
      {[](Problem &p) { p.slab.ior_above = 0; }, "ior_above is 0"},
      {[](Problem &p) { p.slab.ior_below = NAN; }, "ior_below is nan"},
  });
}

TEST(BadSlab, AddingDoublingOptions) {
  expect_refused({
      {[](Problem &p) { p.options.size = 1; }, "TynAddingDoublingOptions::size is 1"},
      {[](Problem &p) { p.options.channel = 2; }, "channel is 2"},
      {[](Problem &p) { p.options.incidence = 2; }, "incidence is 2"},
      {[](Problem &p) { p.options.angle = -0.1; }, "angle is -0.1"},
      {[](Problem &p) { p.options.angle = M_PI / 2; }, "angle is 1.5708"},
      {[](Problem &p) { p.options.angle = NAN; }, "angle is nan"},
      {[](Problem &p) { p.options.tolerance = 0; }, "tolerance is 0"},
      {[](Problem &p) { p.options.tolerance = NAN; }, "tolerance is nan"},
      {[](Problem &p) { p.options.max_nodes = 7; }, "max_nodes is 7"},
      {[](Problem &p) { p.options.max_nodes = 513; }, "max_nodes is 513"},
      {[](Problem &p) { p.options.cosines = nullptr; }, "cosines is NULL"},
      {[](Problem &p) { p.cosines[1] = 0; }, "cosines[1] is 0"},
      {[](Problem &p) { p.cosines[0] = 1.1; }, "cosines[0] is 1.1"},
      {[](Problem &p) { p.cosines[0] = NAN; }, "cosines[0] is nan"},
      {[](Problem &p) { p.result.size = 8; }, "TynAddingDoublingResult::size is 8"},
  });
  Problem problem;
  EXPECT_EQ(tyn_adding_doubling(nullptr, nullptr, &problem.result, nullptr, nullptr, nullptr, 0),
            TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_adding_doubling(&problem.slab, nullptr, nullptr, nullptr, nullptr, nullptr, 0),
            TYN_ERROR_INVALID_ARGUMENT);
  // a message that does not fit is cut
  char little[5] = "";
  problem.slab.layer_count = 0;
  EXPECT_EQ(tyn_adding_doubling(&problem.slab, nullptr, &problem.result, nullptr, nullptr, little, sizeof little),
            TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_STREQ(little, "laye");
}

TEST(BadSlab, ClosedForms) {
  for (double mu : {0.0, -0.5, 1.5, double(NAN)}) {
    EXPECT_TRUE(std::isnan(tyn_reduced_intensity(1, mu)));
    EXPECT_TRUE(std::isnan(tyn_effective_source(0.5, 0.1, 1, mu)));
    EXPECT_TRUE(std::isnan(tyn_seeliger_brdf(0.5, 0.1, mu, 1)));
    EXPECT_TRUE(std::isnan(tyn_seeliger_brdf(0.5, 0.1, 1, mu)));
  }
  for (double bad : {-0.1, 1.1, double(NAN)}) {
    EXPECT_TRUE(std::isnan(tyn_effective_source(bad, 0.1, 1, 1)));
    EXPECT_TRUE(std::isnan(tyn_seeliger_brdf(bad, 0.1, 1, 1)));
  }
  for (double bad : {-0.1, double(NAN)}) {
    EXPECT_TRUE(std::isnan(tyn_reduced_intensity(bad, 1)));
    EXPECT_TRUE(std::isnan(tyn_effective_source(0.5, bad, 1, 1)));
    EXPECT_TRUE(std::isnan(tyn_effective_source(0.5, 0.1, bad, 1)));
    EXPECT_TRUE(std::isnan(tyn_seeliger_brdf(0.5, bad, 1, 1)));
  }
}

TEST(BadSlab, HanrahanKrueger) {
  const auto status = [](const TynSingleScattering &layer, double mu_i = 1, double mu_o = 1, double azimuth = 0) {
    double brdf = -7, btdf = -7;
    const TynStatus result = tyn_hanrahan_krueger(&layer, mu_i, mu_o, azimuth, &brdf, &btdf);
    EXPECT_TRUE(result == TYN_OK || (brdf == -7 && btdf == -7));
    return result;
  };
  const TynSingleScattering good = tyn_single_scattering();
  EXPECT_EQ(status(good), TYN_OK);
  EXPECT_EQ(tyn_hanrahan_krueger(&good, 1, 1, 0, nullptr, nullptr), TYN_OK);
  EXPECT_EQ(tyn_hanrahan_krueger(nullptr, 1, 1, 0, nullptr, nullptr), TYN_ERROR_INVALID_ARGUMENT);
  for (double bad : {0.0, -1.0, 1.01, double(NAN)}) {
    EXPECT_EQ(status(good, bad), TYN_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(status(good, 1, bad), TYN_ERROR_INVALID_ARGUMENT);
  }
  EXPECT_EQ(status(good, 1, 1, INFINITY), TYN_ERROR_INVALID_ARGUMENT);
  const std::function<void(TynSingleScattering &)> spoilers[] = {
      [](TynSingleScattering &l) { l.size = 8; },
      [](TynSingleScattering &l) { l.albedo = 1.5; },
      [](TynSingleScattering &l) { l.albedo = NAN; },
      [](TynSingleScattering &l) { l.optical_thickness = 0; },
      [](TynSingleScattering &l) { l.optical_thickness = NAN; },
      [](TynSingleScattering &l) { l.ior = 0.5; },
  };
  for (const auto &spoil : spoilers) {
    TynSingleScattering layer = good;
    spoil(layer);
    EXPECT_EQ(status(layer), TYN_ERROR_INVALID_ARGUMENT);
  }
  TynPhase phase = tyn_phase();
  phase.kind = 99;
  TynSingleScattering layer = good;
  layer.phase = &phase;
  EXPECT_EQ(status(layer), TYN_ERROR_INVALID_ARGUMENT);
}

TEST(BadSlab, Chandrasekhar) {
  double mu = 0.5, out = -7;
  for (double bad : {-0.1, 1.1, double(NAN)}) {
    EXPECT_EQ(tyn_chandrasekhar_h(bad, &mu, 1, &out), TYN_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(tyn_chandrasekhar_h(0.5, &bad, 1, &out), TYN_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(tyn_half_space_brdf(bad, 0.5, &mu, 1, &out), TYN_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(tyn_half_space_brdf(0.5, bad, &mu, 1, &out), TYN_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(tyn_half_space_brdf(0.5, 0.5, &bad, 1, &out), TYN_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(tyn_half_space_albedo(bad, 0.5, &out), TYN_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(tyn_half_space_albedo(0.5, bad, &out), TYN_ERROR_INVALID_ARGUMENT);
  }
  EXPECT_EQ(tyn_chandrasekhar_h(0.5, nullptr, 1, &out), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_chandrasekhar_h(0.5, &mu, 1, nullptr), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_half_space_brdf(0.5, 0.5, nullptr, 1, &out), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_half_space_brdf(0.5, 0.5, &mu, 1, nullptr), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_half_space_albedo(0.5, 0.5, nullptr), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(out, -7);
  EXPECT_EQ(tyn_chandrasekhar_h(0.5, nullptr, 0, nullptr), TYN_OK);
}
