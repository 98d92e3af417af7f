// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "slab/results.hpp"

#include "slab/messages.hpp"

namespace slab {
namespace {

Curve read_curve(const TynSlabResult *handle, uint32_t quantity, uint32_t channel) {
  Curve curve;
  const size_t count = tyn_slab_result_count(handle, quantity);
  curve.values.resize(count);
  curve.errors.resize(count);
  if (count)
    tool::check(tyn_slab_result_read(handle, quantity, channel, curve.values.data(), curve.errors.data(), count),
                nullptr);
  return curve;
}

} // namespace

void read_results(const TynSlabResult *handle, Results &results) {
  results.run.size = sizeof results.run;
  tool::check(tyn_slab_result_run(handle, &results.run), nullptr);
  results.channels.resize(results.run.channel_count);
  for (uint32_t c = 0; c < results.run.channel_count; ++c) {
    ChannelResults &channel = results.channels[c];
    channel.totals.size = sizeof channel.totals;
    tool::check(tyn_slab_result_totals(handle, c, &channel.totals), nullptr);
    for (uint32_t quantity = 0; quantity < TYN_SLAB_QUANTITY_COUNT; ++quantity)
      channel.quantities[quantity] = read_curve(handle, quantity, c);
  }
}

std::vector<TynAddingDoublingResult> solve_exactly(const TynSlab &slab, const Arguments &arguments) {
  std::vector<TynAddingDoublingResult> solutions;
  TynAddingDoublingOptions exact = tyn_adding_doubling_options();
  exact.incidence = arguments.options.incidence;
  exact.angle = arguments.options.angle;
  for (exact.channel = 0; exact.channel < slab.channel_count; ++exact.channel) {
    TynAddingDoublingResult solution = {};
    solution.size = sizeof solution;
    char message[512] = "";
    const TynStatus status = tyn_adding_doubling(&slab, &exact, &solution, nullptr, nullptr, message, sizeof message);
    if (status != TYN_OK)
      throw tool::Error(status == TYN_ERROR_INVALID_ARGUMENT ? tool::kUsage : tool::kFailed,
                        "--exact: " + in_options(*message ? message : tyn_status_string(status), arguments));
    solutions.push_back(solution);
  }
  return solutions;
}

std::vector<std::string> channel_names(const Arguments &arguments) {
  if (arguments.is_rgb)
    return {"R", "G", "B"};
  std::vector<std::string> names;
  for (size_t c = 0; c < arguments.layers.front().sigma_a.size(); ++c)
    names.push_back(std::to_string(c));
  return names;
}

double deviation(const TynEstimate &estimate, double exact, double accuracy) {
  const double difference = estimate.value - exact;
  if (estimate.standard_error > 0.0)
    return difference / estimate.standard_error;
  return std::fabs(difference) <= accuracy ? 0.0 : NAN;
}

} // namespace slab
