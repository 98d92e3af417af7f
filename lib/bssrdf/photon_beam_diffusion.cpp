// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Habel, Christensen, Jarosz 2013, "Photon Beam Diffusion: A Hybrid Monte Carlo Method for Subsurface Scattering", sections 4
// and 5, for perpendicular incidence: a better dipole at every depth of the beam, each taken back near the beam by the
// empirical factor kappa, and single scattering exactly.
#include <cmath>

#include "bssrdf/diffusion.hpp"
#include "bssrdf/integrate.hpp"
#include "bssrdf/single_scattering.hpp"
#include "core/pi.hpp"

namespace tyn {
namespace {

// Multiple scattering at radius r, in units of 1 / sigma_t'.
class Beam {
public:
  Beam(double albedo_, double eta) : albedo(albedo_), diffusion(albedo_), boundary(exitance_boundary(eta)) {}

  // Over the depths z of the beam's scatterings, of density exp(-z); most of it comes from depths like r and like 1.
  double exitance(double r) const {
    auto part = [&](double z) { return std::exp(-z) * dipole(r, z); };
    double sum = 0, from = 0;
    for (double to : {0.25 * r, r, 4 * r, 1.0, 4.0, 12.0, 40.0})
      if (to > from && to <= 40) {
        sum += integrate(part, from, to);
        from = to;
      }
    return albedo * albedo * sum;
  }

  double falloff() const { return diffusion.falloff; }

private:
  double dipole(double r, double z_r) const {
    const SourcePair pair{z_r, -(z_r + 4 * boundary.a * diffusion.d)};
    const PairLight light = pair_light(pair, diffusion.falloff, r);
    const double kappa = -std::expm1(-2 * (std::hypot(r, z_r) + z_r));
    return kappa * (boundary.c_phi * light.fluence / diffusion.d + boundary.c_e * light.flux) / (4 * pi);
  }

  const double albedo;
  const GrosjeanDiffusion diffusion;
  const ExitanceBoundary boundary;
};

} // namespace

Profile photon_beam_diffusion(const BssrdfInput &input) {
  const ReducedMedium medium = reduced(input.top(), input.channel);
  if (medium.albedo == 0)
    return black_profile();
  const Beam beam(medium.albedo, input.ior());
  const double length = 1 / medium.sigma_t;
  const SingleScattering single(input);
  auto value = [&](double x) { return beam.exitance(x) + single.exitance(x * length) * length * length; };
  return profile_of_table(length, value, true, beam.falloff());
}

} // namespace tyn
