// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "core/input.hpp"
#include "slab/options.hpp"

namespace tyn {

namespace {

constexpr uint32_t most_bins = 1000000; // of one axis
constexpr uint64_t most_photons = uint64_t(1e15);
constexpr uint32_t most_sweep_rows = 4096;
constexpr double least_absorption = 1e-7; // 1 - albedo of a half-space

void require_bins(const char *name, uint32_t bins, uint32_t most = most_bins) {
  if (bins > most)
    fail(TYN_ERROR_INVALID_ARGUMENT, "%s is %u; it must be in 0 .. %u", name, bins, most);
}

// An axis of equal steps from 0 to `end`.
void require_axis(const char *name, double end, const char *bins_name, uint32_t bins) {
  require_bins(bins_name, bins);
  if (bins)
    require_positive(name, end);
}

void check_source(const TynSlabOptions &options) {
  require_choice("incidence", options.incidence, 2);
  if (!(options.angle >= 0 && options.angle < 1.5707963267948966))
    fail(TYN_ERROR_INVALID_ARGUMENT, "angle is %g; it must be in [0, pi/2)", options.angle);
  require_choice("beam", options.beam, 3);
  if (options.beam != TYN_BEAM_PENCIL)
    require_positive("beam_radius", options.beam_radius);
}

void check_limits(const TynSlabOptions &options) {
  if (options.photons > most_photons)
    fail(TYN_ERROR_INVALID_ARGUMENT, "photons is %llu; it must be at most 1e15", (unsigned long long)options.photons);
  require_not_negative("seconds", options.seconds);
  require_not_negative("target_error", options.target_error);
  if (options.photons == 0 && options.seconds == 0 && options.target_error == 0)
    fail(TYN_ERROR_INVALID_ARGUMENT, "photons, seconds and target_error are all 0: the run would never end");
  if (!(options.roulette_threshold > 0 && options.roulette_threshold <= 1))
    fail(TYN_ERROR_INVALID_ARGUMENT, "roulette_threshold is %g; it must be in (0, 1]", options.roulette_threshold);
}

void check_bins(const TynSlabOptions &options) {
  require_axis("radial_max", options.radial_max, "radial_bins", options.radial_bins);
  require_axis("depth_max", options.depth_max, "depth_bins", options.depth_bins);
  require_axis("path_max", options.path_max, "path_bins", options.path_bins);
  require_bins("angular_bins", options.angular_bins);
  require_bins("order_bins", options.order_bins);
  require_choice("radial_angular", options.radial_angular, 2);
  if (options.radial_angular && (!options.radial_bins || !options.angular_bins))
    fail(TYN_ERROR_INVALID_ARGUMENT, "radial_angular is 1, which needs radial_bins and angular_bins above 0");
}

// What bounds a row's weights by the slab's own: it scatters no more, and light meets no less.
void check_sweep_layer(const SlabLayer &layer, uint32_t row, size_t index, double sigma_a, double sigma_s) {
  for (size_t c = 0; c < layer.sigma_a.size(); ++c) {
    const double rounding = 1e-9 * (layer.sigma_a[c] + layer.sigma_s[c]);
    if (sigma_s > layer.sigma_s[c] + rounding)
      fail(TYN_ERROR_INVALID_ARGUMENT, "sweep row %u, layer %zu: sigma_s is %g; it must be at most the slab's own, %g",
           row, index, sigma_s, layer.sigma_s[c]);
    if (sigma_a + sigma_s < layer.sigma_a[c] + layer.sigma_s[c] - rounding)
      fail(TYN_ERROR_INVALID_ARGUMENT,
           "sweep row %u, layer %zu: sigma_a + sigma_s is %g; it must be at least the slab's own, %g", row, index,
           sigma_a + sigma_s, layer.sigma_a[c] + layer.sigma_s[c]);
  }
}

void check_sweep(const TynSlabOptions &options, const Slab &slab) {
  require_bins("sweep_count", options.sweep_count, most_sweep_rows);
  if (!options.sweep_count)
    return;
  if (options.max_order)
    fail(TYN_ERROR_INVALID_ARGUMENT,
         "max_order is %u and sweep_count %u; a sweep needs walks of any order (max_order 0)", options.max_order,
         options.sweep_count);
  require_pointer("sweep_sigma_a", options.sweep_sigma_a);
  require_pointer("sweep_sigma_s", options.sweep_sigma_s);
  for (uint32_t row = 0; row < options.sweep_count; ++row)
    for (size_t i = 0; i < slab.layers.size(); ++i) {
      const double sigma_a = options.sweep_sigma_a[row * slab.layers.size() + i];
      const double sigma_s = options.sweep_sigma_s[row * slab.layers.size() + i];
      require_not_negative("sweep_sigma_a", sigma_a);
      require_not_negative("sweep_sigma_s", sigma_s);
      check_sweep_layer(slab.layers[i], row, i, sigma_a, sigma_s);
    }
}

// Walks that nothing ends: no photon may be started that cannot be finished.
void check_ends(const TynSlabOptions &options, const Slab &slab) {
  const SlabLayer &last = slab.layers.back();
  if (!std::isinf(last.thickness))
    return;
  for (size_t c = 0; c < last.sigma_a.size(); ++c) {
    if (last.sigma_a[c] + last.sigma_s[c] == 0)
      fail(TYN_ERROR_INVALID_ARGUMENT,
           "the last layer is infinite and empty: light in it never comes to anything; give its ior as ior_below");
    if (last.sigma_a[c] < least_absorption * (last.sigma_a[c] + last.sigma_s[c]) && options.max_order == 0)
      fail(TYN_ERROR_INVALID_ARGUMENT,
           "the last layer is infinite and all but white (sigma_a[%zu] is %g, sigma_s %g; 1 - albedo must be at least "
           "%g): "
           "its walks go on for too long; give it a thickness or more sigma_a, or set max_order",
           c, last.sigma_a[c], last.sigma_s[c], least_absorption);
  }
}

} // namespace

TynSlabOptions read_slab_options(const TynSlabOptions *options, const Slab &slab) {
  TynSlabOptions checked = options ? read_struct("TynSlabOptions", options, tyn_slab_options()) : tyn_slab_options();
  check_source(checked);
  check_limits(checked);
  check_bins(checked);
  check_sweep(checked, slab);
  check_ends(checked, slab);
  return checked;
}

} // namespace tyn
