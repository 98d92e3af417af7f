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
#include "core/pi.hpp"
#include "core/status.hpp"
#include "media/phase.hpp"

namespace tyn {
namespace {

constexpr double MOST_FORWARD =
    0.999; // walks in more forward media have too many events to come to where light is diffuse
constexpr double NEGLIGIBLE = 1e-3; // of what is scattered more than once, in media nearly without scattering

// All but the last, which has no end.
std::vector<Ring> rings_of(const EscapeGrid &grid, const EscapeLight &light, const SingleScattering &single) {
  std::vector<Ring> rings;
  for (uint32_t i = 0; i + 1 < light.radii; ++i) {
    Ring ring{ring_begin(grid, i), ring_end(grid, i), 0, 0, 0};
    const double middle = 0.5 * (ring.begin + ring.end);
    ring.beside = 2 * pi * middle * (ring.end - ring.begin) * single.exitance(middle);
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
  const double sigma_t = input.sigma_a() + input.sigma_s(), absorption = input.sigma_a() / sigma_t;
  if (phase_mean_cosine(input.top().phase) > MOST_FORWARD)
    fail(TYN_ERROR_INVALID_ARGUMENT, "the mean cosine of the phase function is %g; the model exact takes at most %g",
         phase_mean_cosine(input.top().phase), MOST_FORWARD);
  const ExactTable &table = input.tables.table(input.top().phase, input.ior());
  const EscapeLight light = table.light(absorption);
  // in mean free paths
  const SingleScattering single(input.sigma_s() / sigma_t, absorption, input.ior(), INFINITY, input.top().phase);
  const RingCurve multiple(rings_of(table.escapes.grid, light, single));
  const double once = single.half_space_albedo();
  if (multiple.empty() && light.sum() > NEGLIGIBLE * once)
    fail(TYN_ERROR_INVALID_ARGUMENT, "exact_events is %llu, too few for a profile in channel %u",
         (unsigned long long)input.options.exact_events, input.channel);

  const double mean_cosine = table.mean_cosine > 0 ? table.mean_cosine : 0;
  const double length = 1 / (sigma_t - mean_cosine * input.sigma_s()), paths = sigma_t * length;
  std::vector<double> errors;
  auto value = [&](double x) {
    const double r = x * paths;
    const double scattered = multiple.empty() ? 0 : multiple.value(r), all = scattered + single.exitance(r);
    errors.push_back(scattered > 0 ? multiple.relative_error(r) * scattered / all : 0);
    return all * paths * paths;
  };
  Profile profile = profile_of_table(length, value, true, (multiple.empty() ? 1 : multiple.falloff()) * paths);
  if (!(profile.albedo > 0))
    return black_profile();
  profile.errors = errors;
  profile.directions = TYN_DIRECTIONS_TABLE;
  profile.more = angle_terms(table, absorption, light, single, input.ior(), paths);
  scale_profile(profile, (light.sum() + once) / profile.albedo);
  return profile;
}

} // namespace tyn
