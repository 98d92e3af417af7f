// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Donner & Jensen 2005, "Light Diffusion in Multi-Layered Translucent Materials", eqs. 3 to 6, for one layer: the standard
// dipole's source, mirrored in the extrapolated boundaries on both sides again and again, so that the fluence vanishes there.
// Light that comes back or goes through. The sum over the images converges slowly where they are nearer to each other than to
// the point that is looked at; there the same solution is a sum over the modes of diffusion across the layer. Several layers
// are in multipole_stack.cpp.
#include <algorithm>
#include <cmath>

#include "bssrdf/diffusion.hpp"
#include "core/pi.hpp"
#include "core/status.hpp"

namespace tyn {
namespace {

constexpr int MOST_IMAGES = 2000; // on each side
constexpr double PRECISION = 1e-7;

// In units of 1 / sigma_t'.
class Images {
public:
  Images(double albedo_, double thickness_, double above, double below, bool transmitted_)
      : albedo(albedo_), falloff(std::sqrt(3 * (1 - albedo_))), thickness(thickness_), z_b(2.0 / 3 * above),
        period(2 * (thickness_ + z_b + 2.0 / 3 * below)), transmitted(transmitted_) {}

  double exitance(double r) const { return r < period / 2 ? from_images(r) : from_modes(r); }

  // The slowest of the modes, which is all that is left far away.
  double slowest() const { return rate(1); }

private:
  // The images i and -i together, whose far fields nearly cancel.
  double from_images(double r) const {
    double sum = pair(r, 0);
    for (int i = 1; i <= MOST_IMAGES; i++) {
      const double both = pair(r, i) + pair(r, -i);
      sum += both;
      if (i * period > 8 * r && std::abs(both) * i < PRECISION * std::abs(sum))
        break;
    }
    return albedo / (4 * pi) * sum;
  }

  // sin(m pi h / L) over the layer between the extrapolated boundaries, L = period / 2, each falling off like K_0 (Carslaw &
  // Jaeger 1959, section 14.10); its flux at the surface.
  double from_modes(double r) const {
    const double length = period / 2, source_height = 1 + z_b, surface = transmitted ? thickness + z_b : z_b;
    double sum = 0;
    for (int m = 1; m < 64 && rate(m) * r < 300; m++) {
      const double k = m * pi / length;
      sum += (transmitted ? -1 : 1) * std::sin(k * source_height) * k * std::cos(k * surface) *
             std::cyl_bessel_k(0.0, rate(m) * r);
    }
    return albedo / (pi * length) * sum;
  }

  double rate(int m) const { return std::hypot(falloff, 2 * m * pi / period); }

  double pair(double r, int i) const {
    const double z_r = i * period + 1, z_v = i * period - 1 - 2 * z_b;
    return transmitted ? source(r, thickness - z_r) - source(r, thickness - z_v) : source(r, z_r) - source(r, z_v);
  }

  double source(double r, double z) const {
    const double d = std::hypot(r, z);
    return z * (1 + falloff * d) * std::exp(-falloff * d) / (d * d * d);
  }

  const double albedo, falloff, thickness, z_b, period;
  const bool transmitted;
};

Profile one_layer(const BssrdfInput &input) {
  const ReducedMedium medium = reduced(input.top(), input.channel);
  if (medium.albedo == 0)
    return black_profile();
  if (std::isinf(input.top().thickness))
    return input.options.transmitted ? black_profile() : standard_dipole(input);
  const double length = 1 / medium.sigma_t, thickness = input.top().thickness / length;
  if (!(thickness > 1))
    fail(TYN_ERROR_INVALID_ARGUMENT,
         "layers[0].thickness is %g reduced mean free paths in channel %u; the model multipole, whose source is "
         "one deep, takes layers thicker than that",
         thickness, input.channel);
  const Images images(medium.albedo, thickness, internal_reflection_fit(input.ior()),
                      internal_reflection_fit(input.top().ior / input.slab.ior_below), input.options.transmitted != 0);
  auto value = [&](double x) { return std::max(images.exitance(x), 0.0); };
  return profile_of_table(length, value, false, images.slowest());
}

} // namespace

Profile multipole(const BssrdfInput &input) {
  Profile profile = input.slab.layers.size() > 1 ? multipole_stack(input) : one_layer(input);
  if (input.options.transmitted)
    profile.directions = TYN_DIRECTIONS_THROUGH;
  return profile;
}

} // namespace tyn
