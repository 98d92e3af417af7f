// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "common/slab_run.hpp"

#include <cmath>

#include "common/walk_scene.hpp"

namespace tyn_test {

namespace {

void read_channel(const TynSlabResult *result, uint32_t channel, SlabOutcome &outcome) {
  TynSlabTotals totals{};
  totals.size = sizeof totals;
  EXPECT_EQ(tyn_slab_result_totals(result, channel, &totals), TYN_OK);
  outcome.totals.push_back(totals);
  outcome.values.emplace_back(TYN_SLAB_QUANTITY_COUNT);
  outcome.errors.emplace_back(TYN_SLAB_QUANTITY_COUNT);
  for (uint32_t quantity = 0; quantity < TYN_SLAB_QUANTITY_COUNT; ++quantity) {
    const size_t count = tyn_slab_result_count(result, quantity);
    if (count == 0)
      continue;
    std::vector<double> &values = outcome.values.back()[quantity], &errors = outcome.errors.back()[quantity];
    values.resize(count);
    errors.resize(count);
    EXPECT_EQ(tyn_slab_result_read(result, quantity, channel, values.data(), errors.data(), count), TYN_OK);
  }
}

} // namespace

SlabOutcome simulate(const TynSlab &slab, const TynSlabOptions &options, TynContext *context) {
  if (!context)
    context = shared_context();
  SlabOutcome outcome;
  TynSlabResult *result = nullptr;
  EXPECT_EQ(tyn_slab_simulate(context, &slab, &options, &result), TYN_OK) << tyn_context_message(context);
  outcome.run.size = sizeof outcome.run;
  EXPECT_EQ(tyn_slab_result_run(result, &outcome.run), TYN_OK);
  for (uint32_t channel = 0; channel < slab.channel_count; ++channel)
    read_channel(result, channel, outcome);
  tyn_slab_result_release(result);
  return outcome;
}

TynSlabOptions slab_options(uint64_t photons, uint64_t seed) {
  TynSlabOptions options = tyn_slab_options();
  options.photons = photons;
  options.seed = seed;
  return options;
}

double deviation(const TynEstimate &estimate, double expected) {
  const double off = estimate.value - expected;
  return off == 0 ? 0 : off / estimate.standard_error;
}

} // namespace tyn_test
