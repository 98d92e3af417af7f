// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Measured media: Jensen, Marschner, Levoy, Hanrahan, "A Practical Model for Subsurface Light
// Transport", 2001, figure 5. The measurement cannot tell g from sigma_s: what it calls
// sigma_s' = sigma_s (1 - g) is given back with g = 0.
#include <cmath>
#include <cstring>
#include <iterator>

#include "core/status.hpp"
#include "media/media.hpp"

namespace {

struct Preset {
  const char *name;
  double sigma_s[3]; // reduced, 1/mm
  double sigma_a[3]; // 1/mm
  float ior;
};

const Preset presets[] = {
    {"apple", {2.29, 2.39, 1.97}, {0.0030, 0.0034, 0.046}, 1.3f},
    {"chicken1", {0.15, 0.21, 0.38}, {0.015, 0.077, 0.19}, 1.3f},
    {"chicken2", {0.19, 0.25, 0.32}, {0.018, 0.088, 0.20}, 1.3f},
    {"cream", {7.38, 5.47, 3.15}, {0.0002, 0.0028, 0.0163}, 1.3f},
    {"ketchup", {0.18, 0.07, 0.03}, {0.061, 0.97, 1.45}, 1.3f},
    {"marble", {2.19, 2.62, 3.00}, {0.0021, 0.0041, 0.0071}, 1.5f},
    {"potato", {0.68, 0.70, 0.55}, {0.0024, 0.0090, 0.12}, 1.3f},
    {"skimmilk", {0.70, 1.22, 1.90}, {0.0014, 0.0025, 0.0142}, 1.3f},
    {"skin1", {0.74, 0.88, 1.01}, {0.032, 0.17, 0.48}, 1.3f},
    {"skin2", {1.09, 1.59, 1.79}, {0.013, 0.070, 0.145}, 1.3f},
    {"spectralon", {11.6, 20.4, 14.9}, {0.0, 0.0, 0.0}, 1.3f},
    {"wholemilk", {2.55, 3.21, 3.77}, {0.0011, 0.0024, 0.014}, 1.3f},
};

const Preset *find_preset(const char *name) {
  for (const Preset &preset : presets)
    if (std::strcmp(preset.name, name) == 0)
      return &preset;
  return nullptr;
}

// From 1/mm to 1/scene unit.
TynMedium scaled(const Preset &preset, double mm_per_unit) {
  TynMedium medium = tyn_medium();
  medium.name = preset.name;
  for (int channel = 0; channel < 3; ++channel) {
    medium.sigma_a[channel] = static_cast<float>(preset.sigma_a[channel] * mm_per_unit);
    medium.sigma_s[channel] = static_cast<float>(preset.sigma_s[channel] * mm_per_unit);
  }
  medium.ior = preset.ior;
  return medium;
}

} // namespace

uint32_t tyn_medium_preset_count(void) { return static_cast<uint32_t>(std::size(presets)); }

const char *tyn_medium_preset_name(uint32_t index) {
  return index < std::size(presets) ? presets[index].name : nullptr;
}

TynStatus tyn_medium_preset(const char *name, double metres_per_unit, TynMedium *medium) {
  if (!name || !medium || !std::isfinite(metres_per_unit) || !(metres_per_unit > 0.0))
    return TYN_ERROR_INVALID_ARGUMENT;
  const Preset *preset = find_preset(name);
  if (!preset)
    return TYN_ERROR_INVALID_ARGUMENT;
  const TynMedium result = scaled(*preset, 1000.0 * metres_per_unit);
  try {
    tyn::validate(result); // an extreme metres_per_unit may overflow
  } catch (const tyn::Failure &failure) {
    return failure.status;
  }
  // A program compiled for the first version has less room. Any other size, and none, is one of today's: the struct is filled in
  // whole.
  const bool first_version = medium->size == tyn::first_medium_size;
  std::memcpy(static_cast<void *>(medium), &result, first_version ? tyn::first_medium_size : sizeof result);
  if (first_version)
    medium->size = tyn::first_medium_size;
  return TYN_OK;
}
