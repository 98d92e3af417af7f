// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "bssrdf/surface_albedo.hpp"

#include "core/pi.hpp"
#include "core/status.hpp"
#include "media/fresnel.hpp"
#include "tyndall/tyndall_exact.h"

namespace tyn {
namespace {

// `reflected`: at the options' cosines, or nullptr.
TynAddingDoublingResult solve(const HalfSpace &medium, const TynAddingDoublingOptions &options, double *reflected) {
  TynSlabLayer layer = tyn_slab_layer();
  layer.sigma_a = &medium.sigma_a;
  layer.sigma_s = &medium.sigma_s;
  layer.phase = &medium.phase;
  layer.ior = medium.ior;
  TynSlab slab = tyn_slab();
  slab.layer_count = 1;
  slab.layers = &layer;
  slab.ior_above = medium.ior_above;
  TynAddingDoublingResult result{};
  result.size = sizeof result;
  char message[256] = "";
  const TynStatus status = tyn_adding_doubling(&slab, &options, &result, reflected, nullptr, message, sizeof message);
  if (status != TYN_OK)
    fail(status, "the albedo of a half-space: %s", message);
  return result;
}

} // namespace

double surface_albedo(const HalfSpace &medium, bool diffuse) {
  TynAddingDoublingOptions options = tyn_adding_doubling_options();
  options.incidence = diffuse ? TYN_INCIDENCE_DIFFUSE : TYN_INCIDENCE_COLLIMATED;
  const TynAddingDoublingResult result = solve(medium, options, nullptr);
  return (result.reflectance - result.specular_reflectance) / (1 - result.specular_reflectance);
}

// By reciprocity: what leaves with a cosine of light from everywhere, whose radiance is 1 / pi.
std::vector<double> surface_albedos(const HalfSpace &medium, const std::vector<double> &cosines) {
  TynAddingDoublingOptions options = tyn_adding_doubling_options();
  options.incidence = TYN_INCIDENCE_DIFFUSE;
  options.cosines = cosines.data();
  options.cosine_count = cosines.size();
  std::vector<double> albedos(cosines.size());
  solve(medium, options, albedos.data());
  for (size_t i = 0; i < cosines.size(); ++i)
    albedos[i] *= pi / cosines[i] / (1 - fresnel_reflectance(cosines[i], medium.ior / medium.ior_above));
  return albedos;
}

} // namespace tyn
