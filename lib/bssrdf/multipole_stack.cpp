// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Donner & Jensen 2005, "Light Diffusion in Multi-Layered Translucent Materials": layers as in multipole.cpp, each with a
// source of its own one reduced mean free path below the side where light gets in, convolved with each other by way of their
// spatial frequencies. What is reflected where indices of refraction differ is part of the layer that light comes from.
#include <algorithm>
#include <cmath>

#include "bssrdf/decaying.hpp"
#include "bssrdf/diffusion.hpp"
#include "bssrdf/hankel.hpp"
#include "bssrdf/layer_stack.hpp"
#include "core/status.hpp"

namespace tyn {
namespace {

// The last layer may be there to stop light: infinite and black.
bool is_black_end(const SlabLayer &layer, const ReducedMedium &medium) {
  return std::isinf(layer.thickness) && medium.albedo == 0;
}

void require_layer(const BssrdfInput &input, size_t i) {
  const SlabLayer &layer = input.slab.layers[i];
  const ReducedMedium medium = reduced(layer, input.channel);
  if (is_black_end(layer, medium))
    return;
  if (!(layer.thickness * medium.sigma_t > 1))
    fail(TYN_ERROR_INVALID_ARGUMENT,
         "layers[%zu].thickness is %g reduced mean free paths in channel %u; the model multipole, whose source is one "
         "deep, takes layers thicker than that",
         i, layer.thickness * medium.sigma_t, input.channel);
  if (medium.albedo == 0)
    fail(TYN_ERROR_INVALID_ARGUMENT,
         "layers[%zu].sigma_s is %g in channel %u; of several layers the model multipole takes only an infinite one "
         "that does not scatter (which is black)",
         i, layer.sigma_s[input.channel], input.channel);
}

// Light comes back as near as the top layer lets it and, from layers with longer mean free paths, as far as these do: one
// table must reach both.
double unit_of_reflected(const BssrdfInput &input) {
  const double top = 1 / reduced(input.top(), input.channel).sigma_t;
  double longest = top;
  for (const SlabLayer &layer : input.slab.layers) {
    const ReducedMedium medium = reduced(layer, input.channel);
    if (medium.albedo > 0)
      longest = std::max(longest, 1 / medium.sigma_t);
  }
  return top * std::min(std::max(longest / top / 16, 1.0), 32.0);
}

double total_thickness(const Slab &slab) {
  double sum = 0;
  for (const SlabLayer &layer : slab.layers)
    sum += layer.thickness;
  return sum;
}

std::vector<DiffusionLayer> diffusion_layers(const BssrdfInput &input, double unit) {
  const std::vector<SlabLayer> &given = input.slab.layers;
  std::vector<DiffusionLayer> layers;
  for (size_t i = 0; i < given.size(); i++) {
    const ReducedMedium medium = reduced(given[i], input.channel);
    if (is_black_end(given[i], medium))
      break;
    const double over = i == 0 ? input.slab.ior_above : given[i - 1].ior;
    const double under = i + 1 == given.size() ? input.slab.ior_below : given[i + 1].ior;
    layers.emplace_back(medium.albedo, given[i].thickness * medium.sigma_t,
                        internal_reflection_fit(given[i].ior / over), internal_reflection_fit(given[i].ior / under),
                        1 / medium.sigma_t / unit);
  }
  return layers;
}

} // namespace

Profile multipole_stack(const BssrdfInput &input) {
  for (size_t i = 0; i < input.slab.layers.size(); i++)
    require_layer(input, i);
  const bool transmitted = input.options.transmitted != 0;
  if (transmitted && std::isinf(input.slab.layers.back().thickness))
    return black_profile();
  // what goes through has spread over all layers
  const double unit = transmitted ? total_thickness(input.slab) : unit_of_reflected(input);
  const std::vector<DiffusionLayer> layers = diffusion_layers(input, unit);
  auto transform = [&](std::complex<double> s) {
    const StackResponse response = stack_response(layers, s);
    return transmitted ? response.transmitted : response.reflected;
  };
  const double first = sampler_border(1), last = sampler_border(TYN_SAMPLER_CELLS - 1);
  const auto count = size_t(std::ceil(std::log(last / first) / HANKEL_STEP)) + 1;
  const DecayingFunction value(first, inverse_hankel(transform, first, count));
  return profile_of_table(unit, value, false, value.falloff());
}

} // namespace tyn
