// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// What tyn_slab_simulate refuses, and what it says.
#include <cmath>
#include <functional>
#include <limits>

#include <gtest/gtest.h>

#include "common/exact_slab.hpp"
#include "common/walk_scene.hpp"

namespace {

using namespace tyn_test;

const double nan = std::numeric_limits<double>::quiet_NaN();

void expect_refused(const ExactSlab &slab, const TynSlabOptions &options, const char *says,
                    TynStatus status = TYN_ERROR_INVALID_ARGUMENT) {
  TynSlabResult *result = reinterpret_cast<TynSlabResult *>(1);
  EXPECT_EQ(tyn_slab_simulate(shared_context(), &slab.view(), &options, &result), status) << says;
  EXPECT_EQ(result, nullptr);
  EXPECT_NE(std::string(tyn_context_message(shared_context())).find(says), std::string::npos)
      << tyn_context_message(shared_context());
}

void expect_options_refused(const std::function<void(TynSlabOptions &)> &change, const char *says) {
  ExactSlab slab({{1, 9, 0, 1, 1}});
  TynSlabOptions options = tyn_slab_options();
  options.photons = 1000;
  change(options);
  expect_refused(slab, options, says);
}

TEST(BadSlabOptions, AreNamedWithTheirValue) {
  using Options = TynSlabOptions;
  expect_options_refused([](Options &o) { o.size = 3; }, "TynSlabOptions::size is 3");
  expect_options_refused([](Options &o) { o.photons = 0; }, "all 0");
  expect_options_refused([](Options &o) { o.photons = uint64_t(2e15); }, "photons is 2000000000000000");
  expect_options_refused([](Options &o) { o.seconds = -1; }, "seconds is -1");
  expect_options_refused([](Options &o) { o.seconds = nan; }, "seconds is");
  expect_options_refused([](Options &o) { o.target_error = -0.1; }, "target_error is -0.1");
  expect_options_refused([](Options &o) { o.incidence = 2; }, "incidence is 2");
  expect_options_refused([](Options &o) { o.angle = 1.6; }, "angle is 1.6");
  expect_options_refused([](Options &o) { o.angle = nan; }, "angle is");
  expect_options_refused([](Options &o) { o.beam = 3; }, "beam is 3");
  expect_options_refused([](Options &o) { o.beam = TYN_BEAM_DISC; }, "beam_radius is 0");
  expect_options_refused([](Options &o) { o.roulette_threshold = 0; }, "roulette_threshold is 0");
  expect_options_refused([](Options &o) { o.roulette_threshold = 1.5; }, "roulette_threshold is 1.5");
  expect_options_refused([](Options &o) { o.radial_bins = 10; }, "radial_max is 0");
  expect_options_refused([](Options &o) { o.depth_bins = 10, o.depth_max = INFINITY; }, "depth_max is inf");
  expect_options_refused([](Options &o) { o.path_bins = 10, o.path_max = -1; }, "path_max is -1");
  expect_options_refused([](Options &o) { o.angular_bins = 2000000; }, "angular_bins is 2000000");
  expect_options_refused([](Options &o) { o.order_bins = 4000000000u; }, "order_bins is 4000000000");
  expect_options_refused([](Options &o) { o.radial_angular = 1; }, "radial_angular is 1");
  expect_options_refused(
      [](Options &o) { o.radial_bins = 100000, o.radial_max = 1, o.angular_bins = 1000, o.radial_angular = 1; },
      "fewer bins");
  expect_options_refused([](Options &o) { o.sweep_count = 1; }, "sweep_sigma_a is NULL");
}

TEST(BadSlabOptions, SweepsThatTheSlabDoesNotBound) {
  static const double more_scattering[] = {1.0, 9.5}, less_extinction[] = {0.5, 9.0}, negative[] = {-1.0, 9.0};
  auto sweep = [](const double *values) {
    return [values](TynSlabOptions &o) {
      o.sweep_count = 1;
      o.sweep_sigma_a = values;
      o.sweep_sigma_s = values + 1;
    };
  };
  expect_options_refused(sweep(more_scattering), "sigma_s is 9.5; it must be at most the slab's own, 9");
  expect_options_refused(sweep(less_extinction), "sigma_a + sigma_s is 9.5; it must be at least the slab's own, 10");
  expect_options_refused(sweep(negative), "sweep_sigma_a is -1");
  static const double same[] = {1.0, 9.0};
  expect_options_refused([&](TynSlabOptions &o) { sweep(same)(o), o.max_order = 3; }, "max_order is 3");
}

TEST(BadSlabOptions, SlabsWhoseWalksWouldNeverEnd) {
  const TynSlabOptions options = tyn_slab_options();
  expect_refused(ExactSlab({{0, 9, 0, 1, INFINITY}}), options, "all but white");
  expect_refused(ExactSlab({{1e-8, 9, 0, 1, INFINITY}}), options, "all but white");
  expect_refused(ExactSlab({{1, 9, 0, 1, 1e39}}), options, "thickness is 1e+39");
  expect_refused(ExactSlab({{0, 0, 0, 1, INFINITY}}), options, "infinite and empty");
  expect_refused(ExactSlab({{1, 9, 0, 1, INFINITY}, {1, 9, 0, 1, 1}}), options, "thickness");
  expect_refused(ExactSlab({{1, 9, 0, 1, -1}}), options, "thickness");
  expect_refused(ExactSlab({{nan, 9, 0, 1, 1}}), options, "sigma_a");
  expect_refused(ExactSlab({{1, 9, 1, 1, 1}}), options, "g");
  expect_refused(ExactSlab({{1, 9, 0, 0.9, 1}}), options, "ior");
}

TEST(BadSlabOptions, NullPointersAndBadIndices) {
  ExactSlab slab({{1, 9, 0, 1, 1}});
  TynSlabResult *result = nullptr;
  EXPECT_EQ(tyn_slab_simulate(nullptr, &slab.view(), nullptr, &result), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_slab_simulate(shared_context(), nullptr, nullptr, &result), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_slab_simulate(shared_context(), &slab.view(), nullptr, nullptr), TYN_ERROR_INVALID_ARGUMENT);
  TynSlabOptions options = tyn_slab_options();
  options.photons = 100;
  ASSERT_EQ(tyn_slab_simulate(shared_context(), &slab.view(), &options, &result), TYN_OK);
  double value = 0;
  TynSlabTotals totals{};
  TynSlabRun run{};
  EXPECT_EQ(tyn_slab_result_totals(result, 0, &totals), TYN_ERROR_INVALID_ARGUMENT); // no size
  EXPECT_EQ(tyn_slab_result_run(result, &run), TYN_ERROR_INVALID_ARGUMENT);
  totals.size = sizeof totals;
  EXPECT_EQ(tyn_slab_result_totals(result, 1, &totals), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_slab_result_totals(nullptr, 0, &totals), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_slab_result_read(result, TYN_SLAB_LAYER_ABSORBED, 0, &value, nullptr, 1), TYN_OK);
  EXPECT_EQ(tyn_slab_result_read(result, TYN_SLAB_LAYER_ABSORBED, 1, &value, nullptr, 1), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_slab_result_read(result, TYN_SLAB_LAYER_ABSORBED, 0, &value, nullptr, 2), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_slab_result_read(result, TYN_SLAB_DEPTH_FLUENCE, 0, &value, nullptr, 0), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_slab_result_read(result, 99, 0, &value, nullptr, 1), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_slab_result_read(result, TYN_SLAB_LAYER_ABSORBED, 0, nullptr, nullptr, 1), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_slab_result_count(nullptr, 0), 0u);
  EXPECT_EQ(tyn_slab_quantity_name(TYN_SLAB_QUANTITY_COUNT), nullptr);
  tyn_slab_result_release(result);
  tyn_slab_result_release(nullptr);
  tyn_slab_result_retain(nullptr);
}

} // namespace
