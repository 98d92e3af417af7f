// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "slab/adding_doubling.hpp"

#include <cmath>

#include "slab/interface.hpp"
#include "core/pi.hpp"
#include "slab/layer.hpp"

namespace tyn {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// The lower part of a stack, as light from above meets it.
struct Stack {
  Transfer reflected, transmitted;
};

// Puts a part of the slab on a stack: up and down are what it does to light from above (down) and from below (up).
Stack put_on(const Basis &basis, const Transfer &reflected_down, const Transfer &transmitted_down,
             const Transfer &reflected_up, const Transfer &transmitted_up, const Stack &stack) {
  const Transfer round = multiply(basis, reflected_up, stack.reflected);
  const Transfer between = go_round(basis, round, transmitted_down);
  const Transfer back = multiply(basis, stack.reflected, between);
  return {add(reflected_down, multiply(basis, transmitted_up, back)), multiply(basis, stack.transmitted, between)};
}

// An interface under a medium of index n1 and over one of n2. Basic radiance passes it as flux does: times 1 - F.
Stack put_interface_on(const Basis &basis, const Nodes &nodes, double n1, double n2, const Stack &stack) {
  if (n1 == n2)
    return stack;
  Transfer down = nothing(basis), up = nothing(basis), through = nothing(basis);
  for (Index i = 0; i < basis.rows; i++) {
    const Interface at = interface_between(nodes.directions[static_cast<size_t>(i)], n1, n2);
    down.diagonal[i] = at.down;
    up.diagonal[i] = at.up;
    through.diagonal[i] = at.through;
  }
  return put_on(basis, down, through, up, through, stack);
}

LayerMedium medium_of(const SlabLayer &layer, uint32_t channel) {
  return {layer.sigma_a[channel], layer.sigma_s[channel], layer.phase, layer.ior, layer.thickness};
}

Stack whole_stack(const Slab &slab, uint32_t channel, const Basis &basis, const Nodes &nodes) {
  Stack stack{nothing(basis), nothing(basis)};
  stack.transmitted.diagonal.setOnes();
  double below = slab.ior_below;
  for (size_t i = slab.layers.size(); i-- > 0;) {
    const SlabLayer &layer = slab.layers[i];
    stack = put_interface_on(basis, nodes, layer.ior, below, stack);
    const LayerTransfer transfer = layer_transfer(medium_of(layer, channel), basis, nodes);
    stack = put_on(basis, transfer.reflected, transfer.transmitted, transfer.reflected, transfer.transmitted, stack);
    below = layer.ior;
  }
  return put_interface_on(basis, nodes, slab.ior_above, below, stack);
}

Basis basis_of(const Nodes &nodes, const Light &light) {
  const Index q = static_cast<Index>(nodes.quadrature());
  return {Eigen::Map<const VectorXd>(nodes.c.data(), q), static_cast<Index>(nodes.all()), q + (light.diffuse ? 0 : 1)};
}

// The weights c of the nodes that exist in a medium of index n.
VectorXd weights_in(const Basis &basis, const Nodes &nodes, double n) {
  VectorXd weights = basis.c;
  for (Index i = 0; i < weights.size(); i++)
    if (!(cosine_in(nodes.directions[static_cast<size_t>(i)], n) > 0))
      weights[i] = 0;
  return weights;
}

// Light that leaves at every node, scattered and not, for light of unit flux.
struct Leaving {
  VectorXd scattered;   // basic radiance x pi
  VectorXd unscattered; // flux along each direction of arrival
};

Leaving leaving(const Transfer &transfer, const Basis &basis, const VectorXd &arriving) {
  Leaving result{VectorXd::Zero(basis.rows), transfer.diagonal.head(basis.columns).cwiseProduct(arriving)};
  if (transfer.scatters())
    result.scattered = scattered(transfer, arriving);
  return result;
}

// Flux of the light that arrives, along each direction.
VectorXd arriving(const Basis &basis, const Nodes &nodes, const Light &light, double n) {
  if (light.diffuse)
    return weights_in(basis, nodes, n) / (n * n);
  VectorXd flux = VectorXd::Zero(basis.columns);
  flux[basis.columns - 1] = 1;
  return flux;
}

// Cosines this close to 0 are as good as 0, and thinner layers would have to be doubled for smaller ones.
double bounded(double mu) { return std::fmax(mu, 1e-9); }

// Radiance is n^2 l.
std::vector<double> per_solid_angle(const VectorXd &scattered, size_t first, const std::vector<double> &cosines,
                                    double n) {
  std::vector<double> values;
  for (size_t i = 0; i < cosines.size(); i++)
    values.push_back(scattered[static_cast<Index>(first + i)] * n * n * cosines[i] / pi);
  return values;
}

} // namespace

Totals add_layers(const Slab &slab, uint32_t channel, const Light &light, unsigned count,
                  const std::vector<double> &cosines, AngularOutput *output) {
  Nodes nodes = make_nodes(media_of(slab), count);
  const unsigned used = static_cast<unsigned>(nodes.quadrature());
  if (!light.diffuse)
    nodes.directions.push_back({slab.ior_above, bounded(light.mu)});
  const size_t first_above = nodes.all(), first_below = first_above + cosines.size();
  for (double n : {slab.ior_above, slab.ior_below})
    for (double mu : cosines)
      nodes.directions.push_back({n, bounded(mu)});

  const Basis basis = basis_of(nodes, light);
  const Stack stack = whole_stack(slab, channel, basis, nodes);
  const VectorXd flux = arriving(basis, nodes, light, slab.ior_above);
  const Leaving up = leaving(stack.reflected, basis, flux), down = leaving(stack.transmitted, basis, flux);
  if (output) {
    output->reflected = per_solid_angle(up.scattered, first_above, cosines, slab.ior_above);
    output->transmitted = per_solid_angle(down.scattered, first_below, cosines, slab.ior_below);
  }
  const auto total = [&](const Leaving &light_out, double n) {
    return weights_in(basis, nodes, n).dot(light_out.scattered.head(basis.quadrature())) + light_out.unscattered.sum();
  };
  return {total(up, slab.ior_above), total(down, slab.ior_below), used};
}

} // namespace tyn
