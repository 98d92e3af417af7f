// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The same seed gives the same bits, over however many lanes; limits, progress and cancelling.
#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include "common/slab_run.hpp"
#include "common/walk_scene.hpp"

namespace {

using namespace tyn_test;

TynSlabOptions everything(uint64_t photons) {
  TynSlabOptions options = slab_options(photons, 5);
  options.angle = 0.3;
  options.beam = TYN_BEAM_GAUSSIAN;
  options.beam_radius = 0.1;
  options.radial_max = options.depth_max = options.path_max = 1;
  options.radial_bins = options.depth_bins = options.path_bins = options.order_bins = 20;
  options.angular_bins = 7;
  options.radial_angular = 1;
  static const double sigma_a[] = {0.5, 1, 1.6, 2}, sigma_s[] = {4, 9, 3, 8};
  options.sweep_count = 2;
  options.sweep_sigma_a = sigma_a;
  options.sweep_sigma_s = sigma_s;
  return options;
}

const TynPhase &rayleigh() {
  static const TynPhase phase = [] {
    TynPhase made = tyn_phase();
    made.kind = TYN_PHASE_RAYLEIGH;
    return made;
  }();
  return phase;
}

std::vector<ExactLayer> layers() { return {{0.5, 4, 0.7, 1.4, 0.2}, {1, 9, 0, 1.3, 0.3, &rayleigh()}}; }

void expect_same(const SlabOutcome &a, const SlabOutcome &b) {
  EXPECT_EQ(a.run.events, b.run.events);
  EXPECT_EQ(std::memcmp(&a.totals[0], &b.totals[0], sizeof a.totals[0]), 0);
  for (uint32_t quantity = 0; quantity < TYN_SLAB_QUANTITY_COUNT; ++quantity) {
    EXPECT_EQ(a.value(quantity), b.value(quantity)) << tyn_slab_quantity_name(quantity);
    EXPECT_EQ(a.error(quantity), b.error(quantity)) << tyn_slab_quantity_name(quantity);
  }
}

TEST(SlabRuns, TheSameBitsOverAnyNumberOfLanes) {
  ExactSlab slab(layers());
  ContextHandle reference = make_context(1);
  const SlabOutcome expected = simulate(slab.view(), everything(3000), reference.get());
  EXPECT_GT(expected.value(TYN_SLAB_SWEEP_REFLECTANCE)[0], 0.1);
  for (uint32_t lanes : {4u, 8u, 16u}) {
    ContextHandle context = make_context(lanes);
    expect_same(simulate(slab.view(), everything(3000), context.get()), expected);
  }
}

// The same with what the first leaves out: diffuse light, a clear layer, a table, walks absorbed as a whole, limited orders.
TEST(SlabRuns, TheSameBitsOverAnyNumberOfLanesWithTheRest) {
  const double cosines[] = {-1, 0, 1}, shares[] = {1, 0.5, 3};
  TynPhase table = tyn_phase();
  table.kind = TYN_PHASE_TABULATED;
  table.cosines = cosines;
  table.values = shares;
  table.count = 3;
  ExactSlab slab({{0, 0, 0, 1.5, 0.1}, {1e-5, 4, 0, 1.4, 0.2, &table}, {1, 2, -0.4, 1, 0.3}}, 1.1, 1.3);
  TynSlabOptions options = everything(3000);
  options.sweep_count = 0;
  options.angle = 0;
  options.incidence = TYN_INCIDENCE_DIFFUSE;
  options.beam = TYN_BEAM_DISC;
  options.max_order = 30;
  ContextHandle reference = make_context(1);
  const SlabOutcome expected = simulate(slab.view(), options, reference.get());
  for (uint32_t lanes : {4u, 8u, 16u}) {
    ContextHandle context = make_context(lanes);
    expect_same(simulate(slab.view(), options, context.get()), expected);
  }
}

TEST(SlabRuns, TheSameSeedTheSameBits) {
  ExactSlab slab(layers());
  const SlabOutcome first = simulate(slab.view(), everything(50000));
  expect_same(simulate(slab.view(), everything(50000)), first);
  TynSlabOptions other = everything(50000);
  other.seed = 6;
  EXPECT_NE(simulate(slab.view(), other).totals[0].reflectance.value, first.totals[0].reflectance.value);
}

TEST(SlabRuns, ChannelsAreRunsOfTheirOwn) {
  const double sigma_a[3] = {1, 0.5, 0.1}, sigma_s[3] = {9, 5, 2};
  TynSlabLayer layer = tyn_slab_layer();
  layer.sigma_a = sigma_a;
  layer.sigma_s = sigma_s;
  layer.thickness = 0.5;
  TynSlab slab = tyn_slab();
  slab.channel_count = 3;
  slab.layer_count = 1;
  slab.layers = &layer;
  const SlabOutcome together = simulate(slab, slab_options(20000, 8));
  for (size_t c = 0; c < 3; ++c) {
    ExactSlab alone({{sigma_a[c], sigma_s[c], 0, 1, 0.5}});
    const TynSlabTotals expected = simulate(alone.view(), slab_options(20000, 8)).totals[0];
    // batches are smaller where there are channels: the errors are estimated from others, the values are the same
    EXPECT_EQ(together.totals[c].reflectance.value, expected.reflectance.value) << c;
    EXPECT_EQ(together.totals[c].transmittance.value, expected.transmittance.value) << c;
    EXPECT_EQ(together.totals[c].absorbed.value, expected.absorbed.value) << c;
  }
}

TEST(SlabRuns, EnergyIsConserved) {
  for (uint64_t photons : {1ull, 7ull, 1000ull, 100000ull}) {
    ExactSlab slab(layers(), 1.2, 1.5);
    const TynSlabTotals totals = simulate(slab.view(), slab_options(photons)).totals[0];
    EXPECT_NEAR(totals.reflectance.value + totals.transmittance.value + totals.absorbed.value + totals.cut.value, 1,
                1e-6);
    EXPECT_EQ(totals.cut.value, 0);
  }
}

// Where nothing varies the error is 0; where one photon says nothing of it, it is not a number.
TEST(SlabRuns, ErrorsOfWhatDoesNotVary) {
  ExactSlab slab({{1, 4, 0.3, 1.37, 1}, {0.5, 3, 0, 1.2, 1}});
  const TynSlabTotals totals = simulate(slab.view(), slab_options(300000)).totals[0];
  EXPECT_EQ(totals.cut.standard_error, 0);
  ExactSlab dark({{1, 0, 0, 1.37, INFINITY}});
  const TynSlabTotals specular = simulate(dark.view(), slab_options(300000)).totals[0];
  const double reflected = std::pow(0.37 / 2.37, 2);
  EXPECT_NEAR(specular.specular_reflectance.value, reflected, 1e-7);
  EXPECT_EQ(specular.specular_reflectance.standard_error, 0);
  EXPECT_TRUE(std::isnan(simulate(slab.view(), slab_options(1)).totals[0].reflectance.standard_error));
}

TEST(SlabRuns, StopAtATargetError) {
  ExactSlab slab(layers());
  TynSlabOptions options = slab_options(0);
  options.target_error = 1e-3;
  const SlabOutcome outcome = simulate(slab.view(), options);
  EXPECT_LE(outcome.totals[0].reflectance.standard_error, 1e-3);
  EXPECT_LE(outcome.totals[0].transmittance.standard_error, 1e-3);
  EXPECT_LT(outcome.run.photons, 3000000u);
  expect_same(simulate(slab.view(), options), outcome);
}

TEST(SlabRuns, StopAtATime) {
  ExactSlab slab(layers());
  TynSlabOptions options = slab_options(0);
  options.seconds = 0.05;
  const SlabOutcome outcome = simulate(slab.view(), options);
  EXPECT_GE(outcome.run.seconds, 0.05);
  EXPECT_GE(outcome.run.photons, 512u);
}

struct Watch {
  int calls = 0;
  double last = -1;
  bool ordered = true;
};

int32_t watch_three(void *user, double fraction) {
  Watch &watch = *static_cast<Watch *>(user);
  watch.ordered = watch.ordered && fraction >= watch.last && fraction <= 1;
  watch.last = fraction;
  return ++watch.calls >= 3;
}

TEST(SlabRuns, CancelledRunsKeepWhatIsDone) {
  ExactSlab slab(layers());
  Watch watch;
  TynSlabOptions options = slab_options(10000000, 5);
  options.progress = watch_three;
  options.user = &watch;
  TynSlabResult *result = nullptr;
  EXPECT_EQ(tyn_slab_simulate(shared_context(), &slab.view(), &options, &result), TYN_ERROR_CANCELLED);
  ASSERT_NE(result, nullptr);
  EXPECT_TRUE(watch.ordered);
  TynSlabRun run{};
  run.size = sizeof run;
  ASSERT_EQ(tyn_slab_result_run(result, &run), TYN_OK);
  EXPECT_GE(run.photons, 3u * 512);
  EXPECT_EQ(run.photons % 512, 0u);
  EXPECT_LT(run.photons, 10000000u);
  TynSlabTotals totals{};
  totals.size = sizeof totals;
  ASSERT_EQ(tyn_slab_result_totals(result, 0, &totals), TYN_OK);
  EXPECT_NEAR(totals.reflectance.value + totals.transmittance.value + totals.absorbed.value, 1, 1e-6);
  tyn_slab_result_release(result);
}

TEST(SlabRuns, ResultsOutliveTheirContext) {
  ExactSlab slab(layers());
  TynSlabResult *result = nullptr;
  {
    ContextHandle context = make_context(0);
    const TynSlabOptions options = slab_options(1000);
    ASSERT_EQ(tyn_slab_simulate(context.get(), &slab.view(), &options, &result), TYN_OK);
  }
  tyn_slab_result_retain(result);
  tyn_slab_result_release(result);
  TynSlabTotals totals{};
  totals.size = sizeof totals;
  EXPECT_EQ(tyn_slab_result_totals(result, 0, &totals), TYN_OK);
  EXPECT_GT(totals.reflectance.value, 0);
  tyn_slab_result_release(result);
}

TEST(SlabRuns, QuantitiesThatWereNotAskedForAreEmpty) {
  ExactSlab slab(layers());
  const SlabOutcome outcome = simulate(slab.view(), slab_options(1000));
  for (uint32_t quantity = 0; quantity < TYN_SLAB_QUANTITY_COUNT; ++quantity)
    EXPECT_EQ(outcome.value(quantity).size(), quantity == TYN_SLAB_LAYER_ABSORBED ? 2u : 0u);
}

// Light that rounding would reflect for ever is cut, not walked for ever.
TEST(SlabRuns, GrazingLightInNearlyClearLayersEnds) {
  for (double sigma_a : {0.0, 1e-9}) {
    ExactSlab slab({{sigma_a, 0, 0, 1.33, 1}});
    TynSlabOptions options = slab_options(1000);
    options.angle = 89.99 * M_PI / 180;
    const TynSlabTotals totals = simulate(slab.view(), options).totals[0];
    EXPECT_NEAR(totals.reflectance.value + totals.transmittance.value + totals.absorbed.value + totals.cut.value, 1,
                1e-6);
  }
}

TEST(SlabRuns, ClearLayersNeverScatter) {
  ExactSlab slab({{0, 0, 0, 1, 1}});
  const SlabOutcome outcome = simulate(slab.view(), slab_options(100000000));
  EXPECT_EQ(outcome.run.events, 0u);
  EXPECT_EQ(outcome.totals[0].direct_transmittance.value, 1);
}

// At a grazing angle in a clear layer rounding may reflect light for ever.
TEST(SlabRuns, ClearLayersLetEverythingOut) {
  ExactSlab slab({{0, 0, 0, 1.6, 1}, {0, 0, 0, 1, 1}, {0, 2, 0, 1.5, 1}, {0, 0, 0, 1.6, 1}});
  TynSlabOptions options = slab_options(200000);
  options.incidence = TYN_INCIDENCE_DIFFUSE;
  const TynSlabTotals totals = simulate(slab.view(), options).totals[0];
  // light that enters at a grazing angle with a weight below the threshold plays roulette: nothing on average
  EXPECT_NEAR(totals.absorbed.value, 0, 4 * totals.absorbed.standard_error + 1e-7);
  EXPECT_LT(totals.absorbed.standard_error, 1e-5);
  EXPECT_NEAR(totals.reflectance.value + totals.transmittance.value + totals.absorbed.value, 1, 1e-6);
}

} // namespace
