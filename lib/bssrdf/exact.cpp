// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Exact transport: single scattering in closed form, all else from walks of the slab engine in a white half-space, which answer
// for every albedo (escape_light.hpp). Totals are those of adding and doubling.
#include <cmath>

#include "bssrdf/escape_angles.hpp"
#include "bssrdf/exact_table.hpp"
#include "bssrdf/model.hpp"
#include "bssrdf/ring_curve.hpp"
#include "bssrdf/single_scattering.hpp"
#include "core/status.hpp"
#include "media/phase.hpp"

namespace tyn {
namespace {

// All but the last, which has no end.
std::vector<Ring> rings_of(const EscapeGrid &grid, const EscapeLight &light) {
  std::vector<Ring> rings;
  for (uint32_t i = 0; i + 1 < light.radii; ++i) {
    Ring ring{ring_begin(grid, i), ring_end(grid, i), 0, 0};
    double variance = 0;
    for (uint32_t angle = 0; angle < TYN_ESCAPE_ANGLES; ++angle) {
      ring.power += light.power[i * TYN_ESCAPE_ANGLES + angle];
      variance += light.variance[i * TYN_ESCAPE_ANGLES + angle];
    }
    ring.error = std::sqrt(variance);
    rings.push_back(ring);
  }
  return rings;
}

} // namespace

Profile exact(const BssrdfInput &input) {
  if (input.sigma_s() == 0)
    return black_profile();
  const double sigma_t = input.sigma_a() + input.sigma_s();
  const ExactTable &table = input.tables.table(input.top().phase, input.ior());
  const EscapeLight light = table.light(input.sigma_a() / sigma_t);
  const RingCurve multiple(rings_of(table.escapes.grid, light)); // in mean free paths
  const SingleScattering single(input);
  if (multiple.empty())
    fail(TYN_ERROR_INVALID_ARGUMENT, "exact_events is %llu, too few for a profile in channel %u",
         (unsigned long long)input.options.exact_events, input.channel);

  const double mean_cosine = table.mean_cosine > 0 ? table.mean_cosine : 0;
  const double length = 1 / (sigma_t - mean_cosine * input.sigma_s()), paths = sigma_t * length;
  std::vector<double> errors;
  auto value = [&](double x) {
    const double scattered = multiple.value(x * paths) * paths * paths;
    const double all = scattered + single.exitance(x * length) * length * length;
    errors.push_back(all > 0 ? multiple.relative_error(x * paths) * scattered / all : 0);
    return all;
  };
  Profile profile = profile_of_table(length, value, true, multiple.falloff() * paths);
  profile.errors = errors;
  const double absorption = input.sigma_a() / sigma_t;
  profile.directions = TYN_DIRECTIONS_TABLE;
  profile.more = angle_terms(table.escapes.grid, light,
                             SingleScattering(1 - absorption, absorption, input.ior(), INFINITY, input.top().phase),
                             input.ior(), paths);
  scale_profile(profile, (light.sum() + single.half_space_albedo()) / profile.albedo);
  return profile;
}

} // namespace tyn
