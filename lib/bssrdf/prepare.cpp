// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// From a slab and options to profiles: checks, then the model's own work for each channel.
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "bssrdf/bssrdf.hpp"
#include "bssrdf/exact_table.hpp"
#include "bssrdf/model.hpp"
#include "core/input.hpp"

namespace tyn {
namespace {

constexpr uint64_t EXACT_SEED = 1;
constexpr uint64_t MOST_EXACT_EVENTS = 1000000000000000;

void require_gaussians(const TynBssrdfOptions &options, uint32_t channels) {
  if (options.gaussian_count < 1 || options.gaussian_count > 64)
    fail(TYN_ERROR_INVALID_ARGUMENT, "gaussian_count is %u; it must be in 1 .. 64", options.gaussian_count);
  require_pointer("gaussian_weights", options.gaussian_weights);
  require_pointer("gaussian_variances", options.gaussian_variances);
  for (uint32_t c = 0; c < channels; c++) {
    double sum = 0, least = INFINITY, largest = 0;
    for (uint32_t i = c * options.gaussian_count; i < (c + 1) * options.gaussian_count; i++) {
      require_not_negative(format("gaussian_weights[%u]", i).c_str(), options.gaussian_weights[i]);
      require_positive(format("gaussian_variances[%u]", i).c_str(), options.gaussian_variances[i]);
      sum += options.gaussian_weights[i];
      least = std::min(least, options.gaussian_variances[i]);
      largest = std::max(largest, options.gaussian_variances[i]);
    }
    if (largest > 1e20 * least)
      fail(TYN_ERROR_INVALID_ARGUMENT, "gaussian_variances range from %g to %g in channel %u; at most a factor of 1e20",
           least, largest, c);
    if (!(sum <= 1 + 1e-6))
      fail(TYN_ERROR_INVALID_ARGUMENT, "gaussian_weights add up to %g in channel %u; they must add up to at most 1",
           sum, c);
  }
}

// R is computed in units of the profile's own length, but given in the caller's, in single precision.
void require_length(const Profile &profile, uint32_t channel) {
  if (profile.albedo > 0 && !(profile.length >= 1e-18 && profile.length <= 1e18))
    fail(TYN_ERROR_INVALID_ARGUMENT, "the profile of channel %u extends over %g; lengths must be in [1e-18, 1e18]",
         channel, profile.length);
}

void require_slab(const BssrdfModel &model, const TynBssrdfOptions &options, const Slab &slab) {
  if (slab.layers.size() != 1 && !model.takes_stacks)
    fail(TYN_ERROR_INVALID_ARGUMENT, "layer_count is %zu; the model %s takes 1 layer", slab.layers.size(), model.name);
  if (!model.takes_slabs && !std::isinf(slab.layers[0].thickness))
    fail(TYN_ERROR_INVALID_ARGUMENT, "layers[0].thickness is %g; the model %s is for half-spaces: it must be INFINITY",
         slab.layers[0].thickness, model.name);
  if (options.model == TYN_BSSRDF_GAUSSIANS || options.model == TYN_BSSRDF_EXACT || model.takes_stacks)
    return;
  const double ior = slab.layers[0].ior;
  for (const double outside : {slab.ior_above, std::isinf(slab.layers[0].thickness) ? 1.0 : slab.ior_below})
    if (ior < outside)
      fail(TYN_ERROR_INVALID_ARGUMENT,
           "layers[0].ior is %g, below the %g outside, which the model %s has no boundary for", ior, outside,
           model.name);
}

} // namespace

PreparedBssrdf prepare_bssrdf(TynContext &context, const TynSlab *given_slab, const TynBssrdfOptions *given) {
  const TynBssrdfOptions options =
      read_struct("TynBssrdfOptions", given, tyn_bssrdf_options(), offsetof(TynBssrdfOptions, exact_events));
  const BssrdfModel *model = find_model(options.model);
  if (!model)
    fail(TYN_ERROR_INVALID_ARGUMENT, "model is %u; models are 0 .. %u: %s", options.model, TYN_BSSRDF_MODEL_COUNT - 1,
         model_names().c_str());
  require_choice("fit", options.fit, TYN_NORMALIZED_FIT_COUNT);
  require_choice("transmitted", options.transmitted, 2);
  if (options.exact_events < 1 || options.exact_events > MOST_EXACT_EVENTS)
    fail(TYN_ERROR_INVALID_ARGUMENT, "exact_events is %llu; it must be in 1 .. 1e15",
         (unsigned long long)options.exact_events);
  const Slab slab = read_slab(given_slab);
  require_slab(*model, options, slab);
  if (options.model == TYN_BSSRDF_GAUSSIANS)
    require_gaussians(options, slab.channels);
  if (options.transmitted && options.model != TYN_BSSRDF_MULTIPOLE)
    fail(TYN_ERROR_INVALID_ARGUMENT, "transmitted is 1; the model %s has what comes back only", model->name);
  ExactTables tables(context, {options.exact_events, EXACT_SEED, options.progress, options.user});
  const double entry = slab.layers.front().ior / slab.ior_above, below = slab.layers.back().ior / slab.ior_below;
  PreparedBssrdf prepared{{}, entry, options.transmitted ? below : entry, options.transmitted != 0};
  for (uint32_t c = 0; c < slab.channels; c++) {
    prepared.profiles.push_back(model->prepare({slab, options, c, tables}));
    require_length(prepared.profiles.back(), c);
  }
  return prepared;
}

} // namespace tyn
