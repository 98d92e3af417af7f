// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// d'Eon 2012, "A Better Dipole": Grosjean's diffusion coefficient, and the exitance from both fluence and flux. Light that was
// scattered once only is not in it.
#include "bssrdf/diffusion.hpp"
#include "core/pi.hpp"

namespace tyn {

Profile better_dipole(const BssrdfInput &input) {
  const ReducedMedium medium = reduced(input.top(), input.channel);
  if (medium.albedo == 0)
    return black_profile();
  const GrosjeanDiffusion diffusion(medium.albedo);
  const ExitanceBoundary boundary = exitance_boundary(input.ior());
  const double power = medium.albedo * medium.albedo / (4 * pi);
  return profile_of_pairs(1 / medium.sigma_t, diffusion.falloff, power * boundary.c_e,
                          power * boundary.c_phi / diffusion.d, {{1, -(1 + 4 * boundary.a * diffusion.d)}});
}

} // namespace tyn
