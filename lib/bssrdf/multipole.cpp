// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Donner & Jensen 2005, "Light Diffusion in Multi-Layered Translucent Materials", eqs. 3 to 6, for one layer: the standard
// dipole's source, mirrored in the extrapolated boundaries on both sides again and again, so that the fluence vanishes there.
// Light that comes back or goes through.
#include <cmath>

#include "bssrdf/diffusion.hpp"
#include "core/pi.hpp"

namespace tyn {
namespace {

constexpr int MOST_IMAGES = 2000; // on each side
constexpr double PRECISION = 1e-9;

// In units of 1 / sigma_t'.
class Images {
public:
  Images(double albedo_, double thickness_, double above, double below, bool transmitted_)
      : albedo(albedo_), falloff(std::sqrt(3 * (1 - albedo_))), thickness(thickness_), z_b(2.0 / 3 * above),
        period(2 * (thickness_ + z_b + 2.0 / 3 * below)), transmitted(transmitted_) {}

  // The images i and -i together, whose far fields nearly cancel.
  double exitance(double r) const {
    double sum = pair(r, 0);
    for (int i = 1; i <= MOST_IMAGES; i++) {
      const double both = pair(r, i) + pair(r, -i);
      sum += both;
      if (i * period > 8 * r && std::abs(both) * i < PRECISION * std::abs(sum))
        break;
    }
    return albedo / (4 * pi) * sum;
  }

  // The slowest of the modes across the layer, which is all that is left far away.
  double slowest() const { return std::sqrt(falloff * falloff + 4 * pi * pi / (period * period)); }

private:
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

} // namespace

Profile multipole(const BssrdfInput &input) {
  const ReducedMedium medium = reduced(input.top(), input.channel);
  if (medium.albedo == 0)
    return black_profile();
  if (std::isinf(input.top().thickness))
    return input.options.transmitted ? black_profile() : standard_dipole(input);
  const double length = 1 / medium.sigma_t;
  const Images images(medium.albedo, input.top().thickness / length, internal_reflection_fit(input.ior()),
                      internal_reflection_fit(input.top().ior / input.slab.ior_below), input.options.transmitted != 0);
  const double end = 30 / images.slowest(); // beyond it is below 1e-13 of what it is nearby
  const double at_end = images.exitance(end);
  auto value = [&](double x) {
    return x < end ? std::max(images.exitance(x), 0.0)
                   : at_end * std::exp(-images.slowest() * (x - end)) * std::sqrt(end / x);
  };
  return profile_of_table(length, value, false, images.slowest());
}

} // namespace tyn
