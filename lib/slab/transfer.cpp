// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "slab/transfer.hpp"

#include <Eigen/LU>

namespace tyn {

using Eigen::MatrixXd;
using Eigen::VectorXd;

Transfer nothing(const Basis &basis) { return {VectorXd::Zero(basis.rows), MatrixXd()}; }

namespace {

void accumulate(MatrixXd &sum, const MatrixXd &term) {
  if (sum.size() == 0)
    sum = term;
  else if (term.size() > 0)
    sum += term;
}

// K_A diag(B) + diag(A) K_B: scattered once by either, and not by the other
MatrixXd first_order(const Basis &basis, const Transfer &a, const Transfer &b) {
  MatrixXd kernel;
  if (a.scatters())
    kernel = a.kernel * b.diagonal.head(basis.columns).asDiagonal();
  if (b.scatters())
    accumulate(kernel, a.diagonal.asDiagonal() * b.kernel);
  return kernel;
}

// K_A c, the rows of all nodes and the columns of the quadrature
MatrixXd weighted(const Basis &basis, const MatrixXd &kernel) {
  return kernel.leftCols(basis.quadrature()) * basis.c.asDiagonal();
}

} // namespace

Transfer add(const Transfer &a, const Transfer &b) {
  Transfer sum = a;
  sum.diagonal += b.diagonal;
  accumulate(sum.kernel, b.kernel);
  return sum;
}

Transfer multiply(const Basis &basis, const Transfer &a, const Transfer &b) {
  Transfer product{a.diagonal.cwiseProduct(b.diagonal), first_order(basis, a, b)};
  if (a.scatters() && b.scatters())
    product.kernel.noalias() += weighted(basis, a.kernel) * b.kernel.topRows(basis.quadrature());
  return product;
}

VectorXd scattered(const Transfer &a, const VectorXd &flux) { return a.kernel * flux; }

VectorXd scattered_flux(const Basis &basis, const Transfer &a) {
  return a.kernel.topRows(basis.quadrature()).transpose() * basis.c;
}

// With X = D + K_X c: D = diag(B) / (1 - diag(A)), and (1 - A) K_X = K_B + K_A D.
Transfer go_round(const Basis &basis, const Transfer &a, const Transfer &b) {
  // 1 - diag(A) is 0 for directions that are totally reflected at both ends of a clear layer. No light gets in there.
  const VectorXd escape = (1 - a.diagonal.array()).matrix();
  const VectorXd inverse = escape.unaryExpr([](double x) { return x > 0 ? 1 / x : 0.0; });
  Transfer x{inverse.cwiseProduct(b.diagonal), b.kernel};
  if (a.scatters())
    accumulate(x.kernel, a.kernel * x.diagonal.head(basis.columns).asDiagonal());
  if (!x.scatters())
    return x;
  if (!a.scatters()) {
    x.kernel = inverse.asDiagonal() * x.kernel;
    return x;
  }
  const Eigen::Index q = basis.quadrature(), further = basis.rows - q;
  const MatrixXd coupling = weighted(basis, a.kernel);
  MatrixXd system = -coupling.topRows(q);
  system.diagonal() += escape.head(q).unaryExpr([](double e) { return e > 0 ? e : 1.0; });
  x.kernel.topRows(q) = system.partialPivLu().solve(x.kernel.topRows(q)).eval();
  if (further > 0) {
    x.kernel.bottomRows(further).noalias() += coupling.bottomRows(further) * x.kernel.topRows(q);
    x.kernel.bottomRows(further) = inverse.tail(further).asDiagonal() * x.kernel.bottomRows(further);
  }
  return x;
}

} // namespace tyn
