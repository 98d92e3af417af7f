// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "slab/phase_matrix.hpp"

#include <algorithm>

#include "media/phase.hpp"

namespace tyn {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

struct Series {
  std::vector<double> moments; // chi_0 = 1, chi_1, ...
  double peak;
};

// Wiscombe 1977: a series cut at `length` terms gets the phase function's forward peak as a delta function of the size of
// the first moment left out; the rest is scaled so that the remaining moments are exact.
Series delta_m(const TynPhase &phase, size_t length) {
  std::vector<double> moments = phase_moments(phase, length + 1);
  Series series{{}, std::max(0.0, moments.back())};
  moments.pop_back();
  for (double moment : moments)
    series.moments.push_back((moment - series.peak) / (1 - series.peak));
  while (series.moments.size() > 1 && std::abs(series.moments.back()) < 1e-16)
    series.moments.pop_back();
  return series;
}

// Row j: P_0(mu_j), P_1(mu_j), ...; zeros where there is no such direction.
MatrixXd legendre_table(const VectorXd &mu, Index length) {
  MatrixXd table(mu.size(), length);
  table.col(0) = (mu.array() > 0).cast<double>();
  if (length > 1)
    table.col(1) = mu;
  for (Index l = 2; l < length; l++) {
    const double inverse = 1.0 / static_cast<double>(l);
    table.col(l) = (2 - inverse) * mu.cwiseProduct(table.col(l - 1)) - (1 - inverse) * table.col(l - 2);
  }
  return table;
}

// sum (2 l + 1) chi_l P_l(mu_j) P_l(mu_k) over l = first, first + 2, ...
MatrixXd half_sum(const MatrixXd &table, const Series &series, Index columns, Index first) {
  const Index terms = (static_cast<Index>(series.moments.size()) - first + 1) / 2;
  if (terms <= 0)
    return MatrixXd::Zero(table.rows(), columns);
  MatrixXd picked(table.rows(), terms);
  VectorXd factor(terms);
  for (Index i = 0; i < terms; i++) {
    const Index l = first + 2 * i;
    picked.col(i) = table.col(l);
    factor[i] = static_cast<double>(2 * l + 1) * series.moments[static_cast<size_t>(l)];
  }
  return picked * factor.asDiagonal() * picked.topRows(columns).transpose();
}

} // namespace

PhaseMatrix phase_matrix(const TynPhase &phase, const Basis &basis, const VectorXd &mu, double n) {
  const Index q = basis.quadrature();
  const VectorXd weights =
      (mu.head(q).array() > 0).select(basis.c.array() / (2 * n * n * mu.head(q).array()), 0.0).matrix();
  // N nodes in each hemisphere could resolve 2 N moments if they were those of one Gauss rule. Measured over single layers
  // and stacks with g from 0.75 to 0.95, 3/2 N gives the smallest errors.
  const size_t active = static_cast<size_t>((weights.array() > 0).count());
  const Series series = delta_m(phase, active + active / 2);
  const MatrixXd table = legendre_table(mu, static_cast<Index>(series.moments.size()));
  const MatrixXd even = half_sum(table, series, basis.columns, 0);
  const MatrixXd odd = half_sum(table, series, basis.columns, 1);

  // Grant & Hunt 1969: what the quadrature makes of the integral over all directions is not quite 2; the difference is put
  // into the forward direction, so that energy is conserved to the last digit and reciprocity stays.
  PhaseMatrix matrix{even + odd, even - odd, VectorXd(), series.peak};
  const MatrixXd all = half_sum(table, series, q, 0); // all nodes, seen from those of the quadrature
  matrix.missing = VectorXd::Ones(mu.size()) - all * weights;
  return matrix;
}

} // namespace tyn
