// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "slab/layer.hpp"

#include <cmath>
#include <vector>

namespace tyn {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// A medium in units of its own extinction, after delta-M scaling.
struct Generator {
  VectorXd rate;     // loss of a direction per optical depth; 0 where there is no such direction
  VectorXd mu;       // 0: none
  Transfer loss;     // alpha: all that a thin layer takes from transmission, per optical depth
  Transfer backward; // beta: what it reflects
};

Generator make_generator(const LayerMedium &layer, const PhaseMatrix &phase, const Basis &basis, const VectorXd &mu,
                         double albedo) {
  const VectorXd inverse = mu.unaryExpr([](double m) { return m > 0 ? 1 / m : 0.0; });
  const double scale = albedo / (4 * layer.ior * layer.ior);
  const auto kernel = [&](const MatrixXd &p, double sign) -> MatrixXd {
    return sign * scale * (inverse.asDiagonal() * p * inverse.head(basis.columns).asDiagonal());
  };
  Generator g;
  g.mu = mu;
  g.rate = inverse.cwiseProduct((1 - albedo * phase.missing.array()).matrix());
  g.loss = {g.rate, kernel(phase.forward, -1)};
  g.backward = {VectorXd::Zero(basis.rows), kernel(phase.backward, 1)};
  return g;
}

VectorXd attenuation(const Generator &g, double tau) {
  return (g.mu.array() > 0).select((-tau * g.rate.array()).exp(), 0.0).matrix();
}

void scale(Transfer &t, double factor) {
  t.diagonal *= factor;
  t.kernel *= factor;
}

// R and T of a thin layer as power series in its optical depth. From the equations of invariant imbedding (Bellman et al.
// 1960; the limit of adding a layer of no thickness on top): R' = beta - alpha R - R alpha + R beta R, T' = -T alpha +
// T beta R.
LayerTransfer thin_layer(const Basis &basis, const Generator &g, double tau) {
  constexpr int order = 5;
  std::vector<Transfer> r{nothing(basis)}, t{nothing(basis)}, beta_r{nothing(basis)};
  t[0].diagonal.setOnes();
  for (int k = 0; k < order; k++) {
    const size_t last = static_cast<size_t>(k);
    Transfer r_loss = add(multiply(basis, g.loss, r[last]), multiply(basis, r[last], g.loss));
    Transfer t_loss = multiply(basis, t[last], g.loss);
    scale(r_loss, -1);
    scale(t_loss, -1);
    Transfer r_next = k == 0 ? g.backward : r_loss, t_next = t_loss;
    for (size_t i = 0; i <= last; i++) {
      r_next = add(r_next, multiply(basis, r[i], beta_r[last - i]));
      t_next = add(t_next, multiply(basis, t[i], beta_r[last - i]));
    }
    scale(r_next, 1.0 / (k + 1));
    scale(t_next, 1.0 / (k + 1));
    r.push_back(r_next);
    t.push_back(t_next);
    beta_r.push_back(multiply(basis, g.backward, r_next));
  }
  LayerTransfer sum{nothing(basis), nothing(basis)};
  double power = 1;
  for (size_t k = 1; k < r.size(); k++) {
    power *= tau;
    scale(r[k], power);
    scale(t[k], power);
    sum.reflected = add(sum.reflected, r[k]);
    sum.transmitted = add(sum.transmitted, t[k]);
  }
  sum.transmitted.diagonal = attenuation(g, tau);
  return sum;
}

// Two layers alike, one on the other. `tau`: of both.
void double_layer(const Basis &basis, const Generator &g, LayerTransfer &layer, double tau) {
  const Transfer both = multiply(basis, layer.reflected, layer.reflected);
  const Transfer down = go_round(basis, both, layer.transmitted);
  const Transfer up = multiply(basis, layer.reflected, down);
  layer.reflected = add(layer.reflected, multiply(basis, layer.transmitted, up));
  layer.transmitted = multiply(basis, layer.transmitted, down);
  layer.transmitted.diagonal = attenuation(g, tau);
}

// The part of unit flux along each direction that gets through, at most
double greatest_transmittance(const Basis &basis, const Transfer &t) {
  return (scattered_flux(basis, t) + t.diagonal.head(basis.columns)).maxCoeff();
}

double smallest_cosine(const VectorXd &mu) { return (mu.array() > 0).select(mu.array(), 1.0).minCoeff(); }

// Optical depth of the first layer: so thin that the error of the series, of relative size (tau / mu)^5 / 6!, is 1e-15. Half
// spaces are 2^21 and more such layers.
double first_depth(const VectorXd &mu) { return smallest_cosine(mu) / 256; }

LayerTransfer doubled_layer(const Basis &basis, const Generator &g, double tau) {
  const double first = first_depth(g.mu);
  int doublings = 0;
  for (double depth = tau; depth > first; depth *= 0.5)
    doublings++;
  LayerTransfer layer = thin_layer(basis, g, std::ldexp(tau, -doublings));
  for (int i = doublings - 1; i >= 0; i--) {
    double_layer(basis, g, layer, std::ldexp(tau, -i));
    if (greatest_transmittance(basis, layer.transmitted) < 1e-150)
      break; // nothing comes through: no further change, and denormal numbers are slow
  }
  return layer;
}

// Less than that is lost to rounding: such layers count as free of absorption.
constexpr double no_absorption = 1e-14;

// Thick layers without absorption transmit T = 1 / (a tau + b), and R + T does not depend on tau (van de Hulst 1980, chapter
// 5), both to within exponentially small terms. Going on doubling would add up rounding errors instead.
LayerTransfer thick_white_layer(const Basis &basis, const Generator &g, double tau) {
  constexpr double thick = 1 << 14;
  if (tau <= thick)
    return doubled_layer(basis, g, tau);
  LayerTransfer layer = doubled_layer(basis, g, thick / 2);
  const double half = greatest_transmittance(basis, layer.transmitted);
  double_layer(basis, g, layer, thick);
  const double whole = greatest_transmittance(basis, layer.transmitted);
  const double kept = 1 / (1 + (1 - whole / half) * (tau - thick) / (thick / 2));
  layer.reflected.kernel += (1 - kept) * layer.transmitted.kernel;
  layer.transmitted.kernel *= kept;
  layer.transmitted.diagonal = attenuation(g, tau);
  return layer;
}

// Doubles until nothing comes through: light that goes through and comes back is of the order T^2.
LayerTransfer half_space(const Basis &basis, const Generator &g) {
  double depth = first_depth(g.mu);
  LayerTransfer layer = thin_layer(basis, g, depth);
  while (depth < 1e18 && greatest_transmittance(basis, layer.transmitted) > 1e-9) {
    depth *= 2;
    double_layer(basis, g, layer, depth);
  }
  layer.transmitted = nothing(basis);
  return layer;
}

LayerTransfer scattering_layer(const Basis &basis, const Generator &g, double tau, double absorption) {
  if (absorption >= no_absorption)
    return std::isinf(tau) ? half_space(basis, g) : doubled_layer(basis, g, tau);
  LayerTransfer layer = thick_white_layer(basis, g, tau);
  if (std::isinf(tau))
    layer.transmitted = nothing(basis);
  return layer;
}

LayerTransfer clear_layer(const Basis &basis, const VectorXd &mu, double tau) {
  LayerTransfer layer{nothing(basis), nothing(basis)};
  for (Index i = 0; i < mu.size(); i++)
    layer.transmitted.diagonal[i] = mu[i] > 0 ? std::exp(-tau / mu[i]) : 0;
  return layer;
}

} // namespace

LayerTransfer layer_transfer(const LayerMedium &layer, const Basis &basis, const Nodes &nodes) {
  const std::vector<double> cosines = node_cosines(nodes, layer.ior);
  const VectorXd mu = Eigen::Map<const VectorXd>(cosines.data(), static_cast<Index>(cosines.size()));
  const bool infinite = std::isinf(layer.thickness);
  if (layer.sigma_s == 0) {
    if (infinite)
      return {nothing(basis), nothing(basis)};
    return clear_layer(basis, mu, layer.sigma_a * layer.thickness);
  }
  const PhaseMatrix phase = phase_matrix(layer.phase, basis, mu, layer.ior);
  const double sigma_s = layer.sigma_s * (1 - phase.peak);
  const double sigma_t = layer.sigma_a + sigma_s;
  const Generator g = make_generator(layer, phase, basis, mu, sigma_s / sigma_t);
  return scattering_layer(basis, g, sigma_t * layer.thickness, layer.sigma_a / sigma_t);
}

} // namespace tyn
