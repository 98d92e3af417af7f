// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// d'Eon & Irving 2011, "A Quantized-Diffusion Model for Rendering Translucent Materials": the light of every time after it
// got in is a Gaussian of variance v = 2 D t; time is cut into intervals, each with one Gaussian; and the source is all of the
// beam, whose integral over the depth has a closed form for a Gaussian. Grosjean's D, and the exitance from fluence and flux,
// are those of the better dipole. Light that was scattered once only is not in it. With more Gaussians than the paper's, since
// what is evaluated is a table of their sum.
#include <cmath>

#include "bssrdf/diffusion.hpp"
#include "core/pi.hpp"

namespace tyn {
namespace {

constexpr int INTERVALS = 128;
constexpr double FIRST = 1e-4, LAST = 1e10; // variances, in units of 1 / sigma_t'^2

// exp(x^2) erfc(x) for x >= 0.
double scaled_erfc(double x) {
  if (x < 20)
    return std::exp(x * x) * std::erfc(x);
  const double w = 1 / (2 * x * x); // Abramowitz & Stegun 1964, eq. 7.1.23
  return (1 - w * (1 - 3 * w * (1 - 5 * w))) / (x * std::sqrt(pi));
}

// In units of 1 / sigma_t'. The source at depth z has the density exp(-z), and an image at -(z + 2 z_b).
class Quantized {
public:
  Quantized(double albedo, double eta)
      : diffusion(albedo), boundary(exitance_boundary(eta)), z_b(2 * boundary.a * diffusion.d) {
    const double ratio = std::pow(LAST / FIRST, 1.0 / INTERVALS);
    double from = 0, to = FIRST * ratio;
    for (int i = 0; i < INTERVALS; i++) {
      const double variance = i == 0 ? to / 2 : std::sqrt(from * to);
      const double exitance = boundary.c_phi * (fluence(variance, 0) - fluence(variance, 2 * z_b)) +
                              boundary.c_e * diffusion.d / variance * (moment(variance, 0) + moment(variance, 2 * z_b));
      weights.push_back(albedo * albedo * share(from, to, 1 - albedo) * exitance);
      variances.push_back(variance);
      from = to;
      to *= ratio;
    }
  }

  double exitance(double r) const {
    double sum = 0;
    for (size_t i = 0; i < weights.size(); i++)
      sum += weights[i] / (2 * pi * variances[i]) * std::exp(-r * r / (2 * variances[i]));
    return sum;
  }

  double falloff() const { return diffusion.falloff; }

private:
  // int exp(-sigma_a v / (2 D)) dv / (2 D) over an interval.
  double share(double from, double to, double sigma_a) const {
    const double rate = sigma_a / (2 * diffusion.d), length = to - from;
    const double x = rate * length;
    return std::exp(-rate * from) * (x > 0 ? -std::expm1(-x) / x : 1) * length / (2 * diffusion.d);
  }

  // int exp(-z) g(z + b) dz over z > 0, g the Gaussian density of variance v.
  static double fluence(double v, double b) {
    return 0.5 * std::exp(-b * b / (2 * v)) * scaled_erfc((b + v) / std::sqrt(2 * v));
  }

  // int exp(-z) (z + b) g(z + b) dz; the two terms nearly cancel where v is large, 1 / v being what is left of them.
  static double moment(double v, double b) {
    if (v > 1e6)
      return std::exp(-b * b / (2 * v)) * (1 + b) / std::sqrt(2 * pi * v);
    return std::sqrt(v / (2 * pi)) * std::exp(-b * b / (2 * v)) - v * fluence(v, b);
  }

  const GrosjeanDiffusion diffusion;
  const ExitanceBoundary boundary;
  const double z_b;
  std::vector<double> weights, variances;
};

} // namespace

Profile quantized_diffusion(const BssrdfInput &input) {
  const ReducedMedium medium = reduced(input.top(), input.channel);
  if (medium.albedo == 0)
    return black_profile();
  const Quantized sum(medium.albedo, input.ior());
  return profile_of_table(
      1 / medium.sigma_t, [&](double x) { return sum.exitance(x); }, false, sum.falloff());
}

} // namespace tyn
