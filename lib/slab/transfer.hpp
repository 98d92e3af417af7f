// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Linear operators on radiance at the nodes: what a part of a slab reflects or transmits.
#pragma once

#include <Eigen/Core>

namespace tyn {

// (A l)_j = diagonal_j l_j + sum_k kernel_jk c_k l_k: light that keeps its direction, and scattered light, kept apart so that
// thin layers lose no digits and so that directions of no weight (the light's and the viewer's) can be among the nodes.
//
// Nodes: `quadrature` ones, then the directions light comes from, then those that are only looked at. A kernel has a row for
// each node and a column for each but the last group. Reciprocity makes the kernels of reflection symmetric.
struct Transfer {
  Eigen::VectorXd diagonal;
  Eigen::MatrixXd kernel; // 0 x 0 if nothing is scattered
  bool scatters() const { return kernel.size() > 0; }
};

// What all operators of one problem share.
struct Basis {
  Eigen::VectorXd c; // weights of the quadrature's nodes
  Eigen::Index rows, columns;
  Eigen::Index quadrature() const { return c.size(); }
};

Transfer nothing(const Basis &basis);
Transfer add(const Transfer &a, const Transfer &b);

// A B: first B, then A.
Transfer multiply(const Basis &basis, const Transfer &a, const Transfer &b);

// What A makes of light of a given flux along the directions it comes from, at each node.
Eigen::VectorXd scattered(const Transfer &a, const Eigen::VectorXd &flux);

// The flux that A scatters of unit flux along each direction it comes from.
Eigen::VectorXd scattered_flux(const Basis &basis, const Transfer &a);

// X = (1 - A)^-1 B: light that goes round A any number of times.
Transfer go_round(const Basis &basis, const Transfer &a, const Transfer &b);

} // namespace tyn
