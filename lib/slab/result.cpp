// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include <iterator>

#include "core/context.hpp"
#include "core/input.hpp"
#include "slab/result.hpp"

using namespace tyn;

namespace {

const char *const quantity_names[] = {
    "layer_absorbed",        "radial_reflectance",         "radial_transmittance",         "angular_reflectance",
    "angular_transmittance", "radial_angular_reflectance", "radial_angular_transmittance", "depth_absorbed",
    "depth_fluence",         "order_reflectance",          "order_transmittance",          "path_reflectance",
    "path_transmittance",    "sweep_reflectance",          "sweep_transmittance",          "sweep_absorbed",
};
static_assert(std::size(quantity_names) == TYN_SLAB_QUANTITY_COUNT, "one name a quantity");

} // namespace

extern "C" {

const char *tyn_slab_quantity_name(uint32_t quantity) {
  return quantity < std::size(quantity_names) ? quantity_names[quantity] : nullptr;
}

void tyn_slab_result_retain(TynSlabResult *result) {
  if (result)
    ++result->references;
}

void tyn_slab_result_release(TynSlabResult *result) {
  if (result && --result->references == 0)
    delete result;
}

TynStatus tyn_slab_result_run(const TynSlabResult *result, TynSlabRun *run) {
  if (!result)
    return TYN_ERROR_INVALID_ARGUMENT;
  return guarded(nullptr, [&] { write_struct("TynSlabRun", run, result->run); });
}

TynStatus tyn_slab_result_totals(const TynSlabResult *result, uint32_t channel, TynSlabTotals *totals) {
  if (!result || channel >= result->channels.size())
    return TYN_ERROR_INVALID_ARGUMENT;
  return guarded(nullptr, [&] { write_struct("TynSlabTotals", totals, result->channels[channel].totals); });
}

size_t tyn_slab_result_count(const TynSlabResult *result, uint32_t quantity) {
  if (!result || quantity >= TYN_SLAB_QUANTITY_COUNT || result->channels.empty())
    return 0;
  return result->channels[0].quantities[quantity].size();
}

TynStatus tyn_slab_result_read(const TynSlabResult *result, uint32_t quantity, uint32_t channel, double *values,
                               double *standard_errors, size_t count) {
  if (!result || channel >= result->channels.size() || quantity >= TYN_SLAB_QUANTITY_COUNT || !values)
    return TYN_ERROR_INVALID_ARGUMENT;
  const std::vector<TynEstimate> &estimates = result->channels[channel].quantities[quantity];
  if (estimates.empty() || count != estimates.size())
    return TYN_ERROR_INVALID_ARGUMENT;
  for (size_t i = 0; i < count; ++i) {
    values[i] = estimates[i].value;
    if (standard_errors)
      standard_errors[i] = estimates[i].standard_error;
  }
  return TYN_OK;
}

} // extern "C"
