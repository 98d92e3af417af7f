// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Frisvad, Hachisuka, Kjeldsen 2014, "Directional Dipole Model for Subsurface Scattering": the source is a ray in an infinite
// medium, whose diffusion keeps the direction of the refracted light, and its image in a plane that is turned towards the point
// where light leaves. Kernels evaluate S_d for any directions (kernels/bssrdf_dipole.clh); here is its exitance for light that
// arrives perpendicularly at a flat surface. S_E, their delta-Eddington term of light that is scattered forward only, is not in
// it. The source has the power of all light that gets in: so there is too much where little is absorbed (an albedo of 1.09 for
// alpha' = 0.99, index-matched), and where little is scattered (0.21 as alpha' goes to 0).
#include <algorithm>
#include <cmath>

#include "bssrdf/diffusion.hpp"
#include "core/pi.hpp"

namespace tyn {
namespace {

// In units of 1 / sigma_t'.
class DirectionalDipole {
public:
  // `extinction`: sigma_t / sigma_t'.
  DirectionalDipole(double albedo, double eta, double extinction)
      : falloff(std::sqrt((1 - albedo) / DIFFUSION)), boundary(exitance_boundary(eta)),
        extension(2.131 * DIFFUSION / std::sqrt(albedo)), separation(2 * boundary.a * extension),
        backlit(std::pow(1 / (3 * extinction), 2)) {}

  // pi c S_d, c = 4 C_phi(1 / eta), for w12 = -n: then x . w = x . n is 0 for the source, -separation for its image.
  double exitance(double r) const {
    const double d_r = std::sqrt(r * r + DIFFUSION * (DIFFUSION + 2 * extension * r / std::hypot(r, extension)));
    const double source = part(d_r, 0, -1);
    const double image = part(std::hypot(r, separation), -separation, 1); // its light travels upwards
    return std::max(source - image, 0.0) / (4 * pi);
  }

  std::vector<double> terms() const {
    std::vector<double> terms(TYN_DIPOLE_TERMS);
    terms[TYN_DIPOLE_DIFFUSION] = DIFFUSION;
    terms[TYN_DIPOLE_FALLOFF] = falloff;
    terms[TYN_DIPOLE_C_PHI] = boundary.c_phi;
    terms[TYN_DIPOLE_C_E] = boundary.c_e;
    terms[TYN_DIPOLE_EXTENSION] = extension;
    terms[TYN_DIPOLE_SEPARATION] = separation;
    terms[TYN_DIPOLE_BACKLIT] = backlit;
    return terms;
  }

  const double falloff;

private:
  static constexpr double DIFFUSION = 1.0 / 3;

  // The brackets of S' at distance d; `along` = x . w = x . n, `cosine` = w . n.
  double part(double d, double along, double cosine) const {
    const double g = (1 + falloff * d) * std::exp(-falloff * d) / (d * d * d);
    const double q = (3 * (1 + falloff * d) + falloff * d * falloff * d) * std::exp(-falloff * d) / std::pow(d, 5);
    const double h = std::exp(-falloff * d) / d;
    return boundary.c_phi * (h / DIFFUSION + 3 * g * along) -
           boundary.c_e * (3 * DIFFUSION * g * cosine - (g + 3 * DIFFUSION * q * along) * along);
  }

  const ExitanceBoundary boundary;
  const double extension, separation, backlit;
};

} // namespace

Profile directional_dipole(const BssrdfInput &input) {
  const ReducedMedium medium = reduced(input.top(), input.channel);
  if (medium.albedo == 0)
    return black_profile();
  const DirectionalDipole dipole(medium.albedo, input.ior(), (input.sigma_a() + input.sigma_s()) / medium.sigma_t);
  Profile profile = profile_of_table(
      1 / medium.sigma_t, [&](double x) { return dipole.exitance(x); }, false, dipole.falloff);
  profile.directions = TYN_DIRECTIONS_DIPOLE;
  profile.more = dipole.terms();
  return profile;
}

} // namespace tyn
