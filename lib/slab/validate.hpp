// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// TynSlab as the engines want it: checked, with every default filled in.
#pragma once

#include <vector>

#include "tyndall/tyndall_slab.h"

namespace tyn {

struct SlabLayer {
  std::vector<double> sigma_a, sigma_s; // one value a channel
  TynPhase phase;                       // a layer without one has Henyey-Greenstein here; a table stays the caller's
  double ior;
  double thickness; // INFINITY in the last layer only
};

struct Slab {
  uint32_t channels;
  std::vector<SlabLayer> layers; // from the top
  double ior_above, ior_below;
};

// Throws INVALID_ARGUMENT with the layer, the field, its value and what is allowed. The phase functions' tables are not
// copied: the result is good as long as the caller's slab.
Slab read_slab(const TynSlab *slab);

} // namespace tyn
