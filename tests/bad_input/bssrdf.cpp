// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Models, media and radii that the BSSRDF calls refuse: a status, one line that says what is wrong, and nothing is written.
#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "common/bssrdf_model.hpp"
#include "common/bssrdf_paths.hpp"
#include "common/walk_scene.hpp"

namespace {

using namespace tyn_test;

struct Problem {
  double sigma_a[2] = {1, 2}, sigma_s[2] = {3, 4}, weights[4] = {0.1, 0.2, 0.3, 0.4}, variances[4] = {1, 2, 3, 4};
  double nothing[2] = {0, 0};
  TynSlabLayer layers[2] = {tyn_slab_layer(), tyn_slab_layer()};
  TynSlab slab = tyn_slab();
  TynBssrdfOptions options = tyn_bssrdf_options();

  Problem() {
    for (TynSlabLayer &layer : layers) {
      layer.sigma_a = sigma_a;
      layer.sigma_s = sigma_s;
      layer.ior = 1.3;
    }
    slab.layers = layers;
    slab.layer_count = 1;
    slab.channel_count = 2;
    options.gaussian_count = 2;
    options.gaussian_weights = weights;
    options.gaussian_variances = variances;
  }

  void two_layers(double first, double second) {
    options.model = TYN_BSSRDF_MULTIPOLE;
    slab.layer_count = 2;
    layers[0].thickness = first;
    layers[1].thickness = second;
  }

  TynStatus create(TynBssrdf **made) { return tyn_bssrdf_create(shared_context(), &slab, &options, made); }
};

struct Case {
  std::function<void(Problem &)> spoil;
  const char *message;
};

TEST(BadBssrdf, IsNotCreated) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const Case cases[] = {
      {[](Problem &p) { p.options.model = 99; }, "standard-dipole, better-dipole"},
      {[](Problem &p) { p.options.size = 3; }, "TynBssrdfOptions::size"},
      {[](Problem &p) { p.options.fit = 3; }, "fit is 3"},
      {[](Problem &p) { p.options.model = TYN_BSSRDF_EXACT, p.layers[0].g = 0.9995; }, "takes at most 0.999"},
      {[](Problem &p) { p.options.model = TYN_BSSRDF_EXACT, p.options.exact_events = 1; }, "too few for a profile"},
      {[](Problem &p) { p.options.model = TYN_BSSRDF_EXACT, p.options.exact_events = 10000; }, "too few for a profile"},
      {[](Problem &p) { p.options.exact_events = 0; }, "exact_events is 0"},
      {[](Problem &p) { p.options.exact_events = UINT64_MAX; }, "it must be in 1 .. 1e15"},
      {[](Problem &p) { p.options.transmitted = 2; }, "transmitted is 2"},
      {[](Problem &p) { p.slab.layer_count = 2, p.layers[0].thickness = 1; }, "takes 1 layer"},
      {[](Problem &p) { p.layers[0].thickness = 1; }, "half-spaces"},
      {[](Problem &p) { p.slab.ior_above = 1.5; }, "below the 1.5 outside"},
      {[](Problem &p) {
         p.options.model = TYN_BSSRDF_SINGLE_SCATTERING, p.layers[0].thickness = 1, p.slab.ior_below = 2;
       },
       "below the 2 outside"},
      {[](Problem &p) {
         p.options.model = TYN_BSSRDF_SINGLE_SCATTERING, p.slab.layer_count = 2, p.layers[0].thickness = 1;
       },
       "single-scattering takes 1 layer"},
      {[](Problem &p) { p.two_layers(1, 0.21); }, "layers[1].thickness is 0.84 reduced mean free paths in channel 0"},
      {[](Problem &p) { p.two_layers(0.2, 1), p.sigma_s[1] = 2; },
       "layers[0].thickness is 0.8 reduced mean free paths in channel 0"},
      {[](Problem &p) { p.two_layers(0.3, 1), p.sigma_a[1] = 0, p.sigma_s[1] = 1; },
       "layers[0].thickness is 0.3 reduced mean free paths in channel 1"},
      {[](Problem &p) { p.two_layers(2, 2), p.sigma_s[1] = 0; }, "layers[0].sigma_s is 0 in channel 1"},
      {[](Problem &p) { p.two_layers(2, 2), p.layers[1].sigma_s = p.nothing; }, "layers[1].sigma_s is 0 in channel 0"},
      {[](Problem &p) { p.two_layers(2, 2), p.layers[1].sigma_s = p.layers[1].sigma_a = p.nothing; },
       "layers[1].thickness is 0 reduced mean free paths"},
      {[](Problem &p) { p.two_layers(INFINITY, 2); }, "layers[0].thickness is inf"},
      {[](Problem &p) { p.two_layers(2, 2), p.options.transmitted = 3; }, "transmitted is 3"},
      {[](Problem &p) { p.options.model = TYN_BSSRDF_MULTIPOLE, p.layers[0].thickness = 0.1; }, "thicker than that"},
      {[](Problem &p) { p.options.transmitted = 1; }, "transmitted is 1"},
      {[](Problem &p) { p.sigma_s[1] = 1e20; }, "lengths must be in"},
      {[](Problem &p) { p.options.model = TYN_BSSRDF_GAUSSIANS, p.variances[3] = 1e-30; }, "a factor of 1e20"},
      {[](Problem &p) { p.sigma_a[1] = -1; }, "sigma_a[1]"},
      {[](Problem &p) { p.sigma_s[0] = nan; }, "sigma_s[0]"},
      {[](Problem &p) { p.layers[0].g = 1; }, "g is 1"},
      {[](Problem &p) { p.slab.channel_count = 0; }, "channel_count"},
      {[](Problem &p) {
         p.options.model = TYN_BSSRDF_NORMALIZED_DIFFUSION, p.options.fit = TYN_NORMALIZED_DMFP, p.sigma_a[1] = 0;
       },
       "sigma_a is 0 in channel 1"},
      {[](Problem &p) { p.options.model = TYN_BSSRDF_GAUSSIANS, p.options.gaussian_count = 0; }, "gaussian_count is 0"},
      {[](Problem &p) { p.options.model = TYN_BSSRDF_GAUSSIANS, p.options.gaussian_count = 65; },
       "gaussian_count is 65"},
      {[](Problem &p) { p.options.model = TYN_BSSRDF_GAUSSIANS, p.options.gaussian_weights = nullptr; },
       "gaussian_weights is NULL"},
      {[](Problem &p) { p.options.model = TYN_BSSRDF_GAUSSIANS, p.weights[2] = -0.1; }, "gaussian_weights[2]"},
      {[](Problem &p) { p.options.model = TYN_BSSRDF_GAUSSIANS, p.weights[2] = 0.9; }, "in channel 1"},
      {[](Problem &p) { p.options.model = TYN_BSSRDF_GAUSSIANS, p.variances[3] = 0; }, "gaussian_variances[3]"},
  };
  for (const Case &bad : cases) {
    Problem problem;
    bad.spoil(problem);
    TynBssrdf *made = reinterpret_cast<TynBssrdf *>(&problem);
    EXPECT_EQ(problem.create(&made), TYN_ERROR_INVALID_ARGUMENT) << bad.message;
    EXPECT_EQ(made, nullptr);
    const std::string message = tyn_context_message(shared_context());
    EXPECT_NE(message.find(bad.message), std::string::npos) << "'" << bad.message << "' is not in '" << message << "'";
    EXPECT_EQ(message.find('\n'), std::string::npos);
  }
}

TEST(BadBssrdf, NullArguments) {
  Problem problem;
  TynBssrdf *made = nullptr;
  EXPECT_EQ(tyn_bssrdf_create(nullptr, &problem.slab, &problem.options, &made), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_bssrdf_create(shared_context(), nullptr, &problem.options, &made), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_bssrdf_create(shared_context(), &problem.slab, nullptr, &made), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_bssrdf_create(shared_context(), &problem.slab, &problem.options, nullptr), TYN_ERROR_INVALID_ARGUMENT);
  float value = 1;
  double albedo = 0;
  EXPECT_EQ(tyn_bssrdf_profile(nullptr, &value, 1, &value), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_bssrdf_pdf(nullptr, &value, 1, &value), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_bssrdf_sample(nullptr, 0, 0, 1, &value, &value, nullptr), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_bssrdf_albedo(nullptr, &albedo, 1), TYN_ERROR_INVALID_ARGUMENT);
  tyn_bssrdf_release(nullptr);
  tyn_bssrdf_retain(nullptr);
  ASSERT_EQ(problem.create(&made), TYN_OK);
  EXPECT_EQ(tyn_bssrdf_profile(made, nullptr, 1, &value), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_bssrdf_profile(made, &value, 1, nullptr), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_bssrdf_pdf(made, &value, 1, nullptr), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_bssrdf_sample(made, 0, 0, 1, nullptr, &value, nullptr), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_bssrdf_sample(made, 0, 0, 1, &value, nullptr, nullptr), TYN_ERROR_INVALID_ARGUMENT);
  const TynBssrdfPath path = plane_path(1);
  EXPECT_EQ(tyn_bssrdf_evaluate(nullptr, &path, 1, &value), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_bssrdf_evaluate(made, nullptr, 1, &value), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_bssrdf_evaluate(made, &path, 1, nullptr), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_bssrdf_albedo(made, nullptr, 2), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_bssrdf_albedo(made, &albedo, 1), TYN_ERROR_INVALID_ARGUMENT); // there are two channels
  // nothing to do
  EXPECT_EQ(tyn_bssrdf_profile(made, nullptr, 0, nullptr), TYN_OK);
  EXPECT_EQ(tyn_bssrdf_evaluate(made, nullptr, 0, nullptr), TYN_OK);
  EXPECT_EQ(tyn_bssrdf_sample(made, 0, 0, 0, nullptr, nullptr, nullptr), TYN_OK);
  tyn_bssrdf_release(made);
}

TEST(BadBssrdf, RadiiThatAreNone) {
  const BssrdfModel model = half_space_model(TYN_BSSRDF_STANDARD_DIPOLE, 0.9);
  for (float bad : {0.0f, -1.0f, INFINITY, NAN}) {
    const float radii[2] = {1, bad};
    float values[2] = {-7, -7};
    auto *bssrdf = const_cast<TynBssrdf *>(model.get());
    EXPECT_EQ(tyn_bssrdf_profile(bssrdf, radii, 2, values), TYN_ERROR_INVALID_ARGUMENT) << bad;
    EXPECT_NE(std::string(tyn_context_message(shared_context())).find("radii[1]"), std::string::npos);
    EXPECT_EQ(tyn_bssrdf_pdf(bssrdf, radii, 2, values), TYN_ERROR_INVALID_ARGUMENT) << bad;
    EXPECT_EQ(values[0], -7);
  }
}

TEST(BadBssrdf, PathsThatAreNone) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
  const struct {
    std::function<void(TynBssrdfPath &)> spoil;
    const char *message;
  } cases[] = {
      {[](TynBssrdfPath &p) { p.entry_position[1] = nan; }, "paths[1]: entry_position[1] is nan; it must be finite"},
      {[](TynBssrdfPath &p) { p.exit_position[2] = -infinity; }, "paths[1]: exit_position[2] is -inf"},
      {[](TynBssrdfPath &p) { p.entry_normal[2] = 1.01f; }, "paths[1]: entry_normal is (0, 0, 1.01)"},
      {[](TynBssrdfPath &p) { p.exit_normal[2] = 0; }, "paths[1]: exit_normal is (0, 0, 0) of length 0"},
      {[](TynBssrdfPath &p) { p.entry_direction[0] = nan; }, "paths[1]: entry_direction[0] is nan"},
      {[](TynBssrdfPath &p) { p.entry_direction[2] = -0.99f; }, "it must have unit length"},
      {[](TynBssrdfPath &p) { p.exit_direction[1] = infinity; }, "paths[1]: exit_direction[1] is inf"},
      {[](TynBssrdfPath &p) { p.exit_direction[2] = 3e38f; }, "paths[1]: exit_direction is (0, 0, 3e+38)"},
  };
  for (uint32_t kind : {TYN_BSSRDF_STANDARD_DIPOLE, TYN_BSSRDF_DIRECTIONAL_DIPOLE}) {
    const BssrdfModel model = half_space_model(kind, 0.9);
    for (const auto &bad : cases) {
      TynBssrdfPath paths[2] = {plane_path(1), plane_path(1)};
      bad.spoil(paths[1]);
      float values[2] = {-7, -7};
      auto *bssrdf = const_cast<TynBssrdf *>(model.get());
      EXPECT_EQ(tyn_bssrdf_evaluate(bssrdf, paths, 2, values), TYN_ERROR_INVALID_ARGUMENT) << bad.message;
      const std::string message = tyn_context_message(shared_context());
      EXPECT_NE(message.find(bad.message), std::string::npos) << message;
      EXPECT_EQ(values[0], -7);
    }
  }
}

TEST(BssrdfNames, AreFoundAgain) {
  for (uint32_t model = 0; model < TYN_BSSRDF_MODEL_COUNT; ++model)
    EXPECT_EQ(tyn_bssrdf_find_model(tyn_bssrdf_model_name(model)), model);
  EXPECT_EQ(tyn_bssrdf_model_name(TYN_BSSRDF_MODEL_COUNT), nullptr);
  EXPECT_EQ(tyn_bssrdf_find_model("dipole"), uint32_t(TYN_BSSRDF_MODEL_COUNT));
  EXPECT_EQ(tyn_bssrdf_find_model(nullptr), uint32_t(TYN_BSSRDF_MODEL_COUNT));
}

} // namespace
