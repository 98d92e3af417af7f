// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// What one homogeneous layer does, without its interfaces. The same from above and from below.
#pragma once

#include "slab/phase_matrix.hpp"

namespace tyn {

struct LayerMedium {
  double sigma_a, sigma_s; // 1/length
  TynPhase phase;
  double ior, thickness;
};

struct LayerTransfer {
  Transfer reflected, transmitted;
};

LayerTransfer layer_transfer(const LayerMedium &layer, const Basis &basis, const Nodes &nodes);

} // namespace tyn
