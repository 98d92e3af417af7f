// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Characteristic lengths of a medium.
#include <cmath>
#include <limits>

#include "core/context.hpp"
#include "core/input.hpp"
#include "media/media.hpp"
#include "media/phase.hpp"

namespace {

// The length that belongs to a coefficient; infinite where there is nothing to meet.
double length_of(double coefficient) {
  return coefficient > 0.0 ? 1.0 / coefficient : std::numeric_limits<double>::infinity();
}

struct Lengths {
  double mean_free_path, transport, diffusion; // scene units
};

Lengths lengths_of(double sigma_a, double sigma_s, double g) {
  const double transport = sigma_a + sigma_s * (1.0 - g);
  return {length_of(sigma_a + sigma_s), length_of(transport), length_of(std::sqrt(3.0 * sigma_a * transport))};
}

bool is_positive(double value) { return std::isfinite(value) && value > 0.0; }

double mean_cosine(const TynMedium &medium) {
  if (!medium.phase)
    return static_cast<double>(medium.g);
  return tyn::phase_mean_cosine(tyn::read_struct("TynPhase", medium.phase, tyn_phase()));
}

void describe_channel(const TynMedium &medium, double g, int channel, double mm_per_unit, double reference,
                      TynMediumDescription &out) {
  const double sigma_a = static_cast<double>(medium.sigma_a[channel]);
  const double sigma_s = static_cast<double>(medium.sigma_s[channel]);
  const double sigma_t = sigma_a + sigma_s;
  const Lengths lengths = lengths_of(sigma_a, sigma_s, g);
  out.albedo[channel] = sigma_t > 0.0 ? static_cast<float>(sigma_s / sigma_t) : 0.0f;
  out.diffuse_albedo[channel] = tyn_color_from_albedo(out.albedo[channel], static_cast<float>(g));
  out.mean_free_path_mm[channel] = lengths.mean_free_path * mm_per_unit;
  out.transport_mean_free_path_mm[channel] = lengths.transport * mm_per_unit;
  out.diffusion_length_mm[channel] = lengths.diffusion * mm_per_unit;
  out.mean_free_path_fraction[channel] = lengths.mean_free_path / reference;
  out.transport_mean_free_path_fraction[channel] = lengths.transport / reference;
  out.diffusion_length_fraction[channel] = lengths.diffusion / reference;
}

} // namespace

TynStatus tyn_medium_describe(const TynMedium *medium, double metres_per_unit, double reference_length,
                              TynMediumDescription *description) {
  if (!medium || !description || !is_positive(metres_per_unit) || !is_positive(reference_length))
    return TYN_ERROR_INVALID_ARGUMENT;
  return tyn::guarded(nullptr, [&] {
    const TynMedium given = tyn::read_medium(medium);
    const double g = mean_cosine(given);
    for (int channel = 0; channel < 3; ++channel)
      describe_channel(given, g, channel, 1000.0 * metres_per_unit, reference_length, *description);
  });
}
