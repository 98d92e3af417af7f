// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Where Donner & Jensen 2005 transform the sums over a layer's images numerically, the transforms here are closed forms: at
// the spatial frequency s diffusion across a layer is D (phi'' - k^2 phi) = -albedo delta(z - source), k^2 = falloff^2 + s^2,
// with phi = 0 on the extrapolated boundaries, and a side's exitance is D phi' there. With a and b the source's distances to
// the near and the far one of them, which are L = a + b apart,
//   R^ = albedo cosh(k z_near) sinh(k b) / sinh(k L),  T^ = albedo cosh(k z_far) sinh(k a) / sinh(k L),
// below without exponentials that grow.
#include "bssrdf/layer_stack.hpp"

#include <cmath>

namespace tyn {
namespace {

using Complex = std::complex<double>;

// 1 - exp(-z), to all its digits also where z is small.
Complex complement(Complex z) {
  const double x = z.real(), y = z.imag(), half = std::sin(y / 2), e = std::exp(-x);
  return {-std::expm1(-x) + 2 * e * half * half, e * std::sin(y)};
}

// (1 - exp(-2 k part)) / (1 - exp(-2 k whole)).
Complex ratio(Complex k, double part, double whole) {
  return k == 0.0 ? Complex(part / whole) : complement(2.0 * k * part) / complement(2.0 * k * whole);
}

} // namespace

DiffusionLayer::DiffusionLayer(double albedo_, double thickness_, double above, double below, double length_)
    : albedo(albedo_), thickness(thickness_), z_above(2.0 / 3 * above), z_below(2.0 / 3 * below), length(length_) {}

LayerResponse DiffusionLayer::response(Complex s, double z_near, double z_far) const {
  const Complex k = std::sqrt(3 * (1 - albedo) + s * s * (length * length));
  const double a = 1 + z_near;
  // of the source and its image beyond the near side: all there is in a half-space
  const Complex dipole = 0.5 * albedo * (std::exp(-k) + std::exp(-k * (1 + 2 * z_near)));
  const Complex dipole_kept = 1 - albedo + 0.5 * albedo * (complement(k) + complement(k * (1 + 2 * z_near)));
  if (std::isinf(thickness))
    return {dipole, dipole_kept, 0.0};
  const double b = thickness - 1 + z_far, whole = a + b;
  const Complex near = ratio(k, a, whole), far = ratio(k, b, whole);
  return {dipole * far, std::exp(-2.0 * k * b) * near + dipole_kept * far,
          0.5 * albedo * (std::exp(-k * (thickness - 1)) + std::exp(-k * (thickness - 1 + 2 * z_far))) * near};
}

// Kubelka's adding equations in frequency space, with layers whose two sides differ (Donner & Jensen 2005, on multi-layered
// materials), from the bottom: R1 + T1 R2 T1' / (1 - R1' R2) and T1 T2 / (1 - R1' R2), ' being a layer's response from below.
StackResponse stack_response(const std::vector<DiffusionLayer> &layers, Complex s) {
  Complex reflected = 0, kept = 1, transmitted = 1; // of what is below layer i
  for (size_t i = layers.size(); i-- > 0;) {
    const LayerResponse down = layers[i].from_above(s), up = layers[i].from_below(s);
    const Complex left = up.kept + up.reflected * kept; // 1 - R1' R2
    const Complex returned = down.transmitted * reflected * up.transmitted / left;
    transmitted *= down.transmitted / left;
    reflected = down.reflected + returned;
    kept = down.kept - returned;
  }
  return {reflected, transmitted};
}

} // namespace tyn
