// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Diffuse light in a stack of plane layers by spatial frequency.
#pragma once

#include <complex>
#include <vector>

namespace tyn {

// What one side of a layer does to light that gets in there, at one frequency.
struct LayerResponse {
  std::complex<double> reflected, kept, transmitted; // kept: 1 - reflected, to all its digits
};

// A layer with light's source one reduced mean free path below the side where it gets in, and with the fluence 0 on the
// extrapolated boundaries 2 A / 3 beyond its sides (Donner & Jensen 2005, for one slab). All in its own reduced mean free
// paths.
class DiffusionLayer {
public:
  // `thickness`: > 1; may be infinite. `above`, `below`: A of the two sides. `length`: of a reduced mean free path in
  // the unit that frequencies are given in.
  DiffusionLayer(double albedo, double thickness, double above, double below, double length);

  // `s`: frequency, |arg s| < pi / 2, or 0.
  LayerResponse from_above(std::complex<double> s) const { return response(s, z_above, z_below); }
  LayerResponse from_below(std::complex<double> s) const { return response(s, z_below, z_above); }

private:
  LayerResponse response(std::complex<double> s, double z_near, double z_far) const;

  double albedo, thickness, z_above, z_below, length;
};

struct StackResponse {
  std::complex<double> reflected, transmitted;
};

// Layers from the top, with all that goes back and forth between them.
StackResponse stack_response(const std::vector<DiffusionLayer> &layers, std::complex<double> s);

} // namespace tyn
