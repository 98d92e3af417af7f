// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Jensen, Marschner, Levoy, Hanrahan 2001, "A Practical Model for Subsurface Light Transport", eq. 4: a point source one mean
// free path deep, and its negative image, so that the flux vanishes at z = -2 A D. Single scattering is not apart: the source
// holds all light.
#include <cmath>

#include "bssrdf/diffusion.hpp"
#include "core/pi.hpp"

namespace tyn {

Profile standard_dipole(const BssrdfInput &input) {
  const ReducedMedium medium = reduced(input.top(), input.channel);
  if (medium.albedo == 0)
    return black_profile();
  // in units of 1 / sigma_t': z_r = 1, D = 1 / 3
  const double z_v = -(1 + 4.0 / 3 * internal_reflection_fit(input.ior()));
  return profile_of_pairs(1 / medium.sigma_t, std::sqrt(3 * (1 - medium.albedo)), medium.albedo / (4 * pi), 0,
                          {{1, z_v}});
}

} // namespace tyn
