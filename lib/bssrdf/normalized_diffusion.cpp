// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Christensen & Burley 2015, "Approximate Reflectance Profiles for Efficient Subsurface Scattering", eq. 3: two exponentials,
// fitted to Monte Carlo profiles of isotropic, index-matched half-spaces, that integrate to the surface's albedo A. What A the
// medium has is computed by adding and doubling, its boundary included; anisotropy enters by similarity.
#include <cmath>

#include "bssrdf/diffusion.hpp"
#include "bssrdf/surface_albedo.hpp"
#include "core/status.hpp"

namespace tyn {
namespace {

// The shape parameter s: eq. 5 (searchlight, r in mean free paths), eq. 6 (diffuse light, mean free paths), eq. 8 (searchlight,
// diffuse mean free paths).
double shape(uint32_t fit, double a) {
  if (fit == TYN_NORMALIZED_SEARCHLIGHT)
    return 1.85 - a + 7 * std::pow(std::abs(a - 0.8), 3);
  if (fit == TYN_NORMALIZED_DIFFUSE)
    return 1.9 - a + 3.5 * (a - 0.8) * (a - 0.8);
  return 3.5 + 100 * std::pow(a - 0.33, 4);
}

} // namespace

Profile normalized_diffusion(const BssrdfInput &input) {
  const ReducedMedium medium = reduced(input.top(), input.channel);
  if (medium.albedo == 0)
    return black_profile();
  const uint32_t fit = input.options.fit;
  double length = 1 / medium.sigma_t;
  if (fit == TYN_NORMALIZED_DMFP) {
    if (medium.albedo == 1)
      fail(TYN_ERROR_INVALID_ARGUMENT,
           "sigma_a is 0 in channel %u: the diffuse mean free path, in which this fit counts, is infinite",
           input.channel);
    length /= std::sqrt(3 * (1 - medium.albedo));
  }
  const double a =
      surface_albedo({input.top().phase, input.top().ior, input.slab.ior_above, input.sigma_a(), input.sigma_s()},
                     fit == TYN_NORMALIZED_DIFFUSE);
  return profile_of_exponentials(length / shape(fit, a), a);
}

} // namespace tyn
