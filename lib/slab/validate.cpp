// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "slab/validate.hpp"

#include <string>

#include "kernels/shared_slab.h"
#include "core/input.hpp"
#include "media/phase.hpp"

namespace tyn {
namespace {

// Coefficients are converted to float on the device; beyond this their sum and products with lengths overflow.
constexpr double max_coefficient = 1e30;

std::vector<double> read_coefficients(const std::string &name, const double *values, uint32_t channels) {
  require_pointer(name.c_str(), values);
  for (uint32_t c = 0; c < channels; c++)
    require_not_negative(format("%s[%u]", name.c_str(), c).c_str(), values[c]);
  return std::vector<double>(values, values + channels);
}

void require_sums(const std::string &name, const SlabLayer &layer) {
  for (size_t c = 0; c < layer.sigma_a.size(); c++)
    if (!(layer.sigma_a[c] + layer.sigma_s[c] <= max_coefficient))
      fail(TYN_ERROR_INVALID_ARGUMENT, "%ssigma_a[%zu] + sigma_s[%zu] is %g + %g; it must be at most %g", name.c_str(),
           c, c, layer.sigma_a[c], layer.sigma_s[c], max_coefficient);
}

TynPhase read_phase(const std::string &name, const TynSlabLayer &given) {
  TynPhase phase = tyn_phase();
  if (!given.phase) {
    if (!(given.g > -1 && given.g < 1))
      fail(TYN_ERROR_INVALID_ARGUMENT, "%sg is %g; it must be in (-1, 1)", name.c_str(), given.g);
    phase.kind = TYN_PHASE_HENYEY_GREENSTEIN;
    phase.g = given.g;
    return phase;
  }
  try {
    phase = read_struct("TynPhase", given.phase, phase);
    validate(phase);
  } catch (const Failure &failure) {
    fail(failure.status, "%sphase: %s", name.c_str(), failure.what());
  }
  return phase;
}

void require_thickness(const std::string &name, double thickness, bool last) {
  // the device has single precision: what overflows there must not become a half-space
  if (thickness > 0 && (thickness <= 1e20 || (last && std::isinf(thickness))))
    return;
  fail(TYN_ERROR_INVALID_ARGUMENT,
       "%sthickness is %g; it must be > 0, at most 1e20, and infinite in the last layer only", name.c_str(), thickness);
}

SlabLayer read_layer(const TynSlabLayer *given, uint32_t index, uint32_t count, uint32_t channels) {
  const TynSlabLayer layer = read_struct("TynSlabLayer", given, tyn_slab_layer());
  const std::string name = format("layers[%u].", index);
  SlabLayer result;
  result.sigma_a = read_coefficients(name + "sigma_a", layer.sigma_a, channels);
  result.sigma_s = read_coefficients(name + "sigma_s", layer.sigma_s, channels);
  require_sums(name, result);
  result.phase = read_phase(name, layer);
  require_between((name + "ior").c_str(), layer.ior, 1, 4);
  result.ior = layer.ior;
  require_thickness(name, layer.thickness, index + 1 == count);
  result.thickness = layer.thickness;
  return result;
}

void require_count(const char *name, uint32_t value, uint32_t highest) {
  if (value < 1 || value > highest)
    fail(TYN_ERROR_INVALID_ARGUMENT, "%s is %u; it must be in 1 .. %u", name, value, highest);
}

} // namespace

Slab read_slab(const TynSlab *given) {
  const TynSlab slab = read_struct("TynSlab", given, tyn_slab());
  require_count("channel_count", slab.channel_count, 1024);
  require_count("layer_count", slab.layer_count, TYN_SLAB_MAX_LAYERS);
  require_pointer("layers", slab.layers);
  require_between("ior_above", slab.ior_above, 1, 4);
  require_between("ior_below", slab.ior_below, 1, 4);

  Slab result{slab.channel_count, {}, slab.ior_above, slab.ior_below};
  // The caller's structs may be of another version: their own size is the array's stride.
  const size_t stride = slab.layers[0].size;
  const char *bytes = reinterpret_cast<const char *>(slab.layers);
  for (uint32_t i = 0; i < slab.layer_count; i++) {
    const auto *layer = reinterpret_cast<const TynSlabLayer *>(bytes + i * stride);
    if (layer->size != stride)
      fail(TYN_ERROR_INVALID_ARGUMENT, "layers[%u].size is %zu, but layers[0].size is %zu; they must be the same", i,
           layer->size, stride);
    result.layers.push_back(read_layer(layer, i, slab.layer_count, slab.channel_count));
  }
  return result;
}

} // namespace tyn
