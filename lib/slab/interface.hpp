// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// A smooth interface between two media, for one direction.
#pragma once

#include "slab/nodes.hpp"

namespace tyn {

struct Interface {
  double down, up; // reflectance for light from above and from below: 1 where it is totally reflected
  double through;  // transmittance, the same both ways; 0 where the direction is missing on one side
};

// Medium n1 above, n2 below. All 0 where neither has the direction.
Interface interface_between(const Direction &direction, double n1, double n2);

} // namespace tyn
