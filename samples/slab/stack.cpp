// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "slab/stack.hpp"

#include <algorithm>

namespace slab {

Stack::Stack(const Arguments &arguments) : arguments_(arguments) {
  if (arguments.phase.given) {
    phase_ = arguments.phase.phase;
    phase_.cosines = arguments.phase.cosines.data();
    phase_.values = arguments.phase.values.data();
  }
  const std::vector<double> &sweep = arguments.sweep;
  // A sweep's photons are walked at its highest albedo, which bounds the weights of the others.
  const double albedo = sweep.empty() ? -1.0 : *std::max_element(sweep.begin(), sweep.end());
  for (const LayerArgument &layer : arguments.layers)
    add(layer, albedo);
  set_sweep();
  slab_.channel_count = static_cast<uint32_t>(arguments.layers.front().sigma_a.size());
  slab_.layer_count = static_cast<uint32_t>(layers_.size());
  slab_.layers = layers_.data();
  slab_.ior_above = arguments.ior_above;
  slab_.ior_below = arguments.ior_below;
}

// `albedo` replaces the layer's own unless it is negative.
void Stack::add(const LayerArgument &layer, double albedo) {
  TynSlabLayer result = tyn_slab_layer();
  result.sigma_a = layer.sigma_a.data();
  result.sigma_s = layer.sigma_s.data();
  if (albedo >= 0.0) {
    const double sigma_t = layer.sigma_a.front() + layer.sigma_s.front();
    coefficients_.push_back({(1.0 - albedo) * sigma_t});
    result.sigma_a = coefficients_.back().data();
    coefficients_.push_back({albedo * sigma_t});
    result.sigma_s = coefficients_.back().data();
  }
  result.g = layer.g;
  result.phase = arguments_.phase.given ? &phase_ : nullptr;
  result.ior = layer.ior;
  result.thickness = layer.thickness;
  layers_.push_back(result);
}

void Stack::set_sweep() {
  for (const double albedo : arguments_.sweep)
    for (const LayerArgument &layer : arguments_.layers) {
      const double sigma_t = layer.sigma_a.front() + layer.sigma_s.front();
      sweep_sigma_a_.push_back((1.0 - albedo) * sigma_t);
      sweep_sigma_s_.push_back(albedo * sigma_t);
    }
}

TynSlabOptions Stack::options() const {
  TynSlabOptions options = arguments_.options;
  options.sweep_count = static_cast<uint32_t>(arguments_.sweep.size());
  options.sweep_sigma_a = sweep_sigma_a_.data();
  options.sweep_sigma_s = sweep_sigma_s_.data();
  return options;
}

} // namespace slab
