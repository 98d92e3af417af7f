// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The phase function of a layer at the nodes.
#pragma once

#include "slab/nodes.hpp"
#include "slab/transfer.hpp"
#include "tyndall/tyndall_phase.h"

namespace tyn {

// Azimuthal means of 4 pi p between nodes, its integral over mu' being 2.
struct PhaseMatrix {
  Eigen::MatrixXd forward, backward; // a row each node, a column each node that light comes from
  Eigen::VectorXd missing;           // 1 - the discrete integral / 2, for each node: counts as not scattered
  double peak;                       // fraction of the scattered light that delta-M scaling takes as not scattered
};

// `mu`: cosines of the nodes in the layer, of index n; 0: none.
PhaseMatrix phase_matrix(const TynPhase &phase, const Basis &basis, const Eigen::VectorXd &mu, double n);

} // namespace tyn
