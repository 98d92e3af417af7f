// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "bssrdf/surface_albedo.hpp"

#include "core/status.hpp"
#include "tyndall/tyndall_exact.h"

namespace tyn {

double surface_albedo(const HalfSpace &medium, bool diffuse) {
  TynSlabLayer layer = tyn_slab_layer();
  layer.sigma_a = &medium.sigma_a;
  layer.sigma_s = &medium.sigma_s;
  layer.phase = &medium.phase;
  layer.ior = medium.ior;
  TynSlab slab = tyn_slab();
  slab.layer_count = 1;
  slab.layers = &layer;
  slab.ior_above = medium.ior_above;
  TynAddingDoublingOptions options = tyn_adding_doubling_options();
  options.incidence = diffuse ? TYN_INCIDENCE_DIFFUSE : TYN_INCIDENCE_COLLIMATED;
  TynAddingDoublingResult result{};
  result.size = sizeof result;
  char message[256] = "";
  const TynStatus status = tyn_adding_doubling(&slab, &options, &result, nullptr, nullptr, message, sizeof message);
  if (status != TYN_OK)
    fail(status, "the albedo of a half-space: %s", message);
  return (result.reflectance - result.specular_reflectance) / (1 - result.specular_reflectance);
}

} // namespace tyn
