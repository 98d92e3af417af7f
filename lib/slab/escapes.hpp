// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Where light comes back from a white half-space, by scattering order. From it follows what comes back at any albedo: a walk of
// n events keeps albedo^n of its weight.
#pragma once

#include <vector>

#include "slab/batches.hpp"

namespace tyn {

// Walks of a pencil beam that gets in perpendicularly, in a half-space with extinction 1.
struct Escapes {
  EscapeGrid grid;
  std::vector<uint64_t> walks;  // for each number of an order: the walks that were followed that far
  std::vector<uint64_t> counts; // of those, which came back: order by order, radius by radius, angle by angle
  uint64_t left = 0;            // of the walks that were followed farthest, those inside after the last order

  uint64_t count(uint32_t order, uint32_t radius, uint32_t angle) const {
    return counts[(size_t(order) * grid.radii + radius) * TYN_ESCAPE_ANGLES + angle];
  }
};

// The least scattering order, or the lower border of the radii, that has a number.
double escape_border(uint32_t number);

// For a phase function's mean cosine, below 1.
EscapeGrid escape_grid(double mean_cosine);

struct EscapeOptions {
  uint64_t events = 0; // about how many scattering events to walk
  uint64_t seed = 0;
  TynProgress progress = nullptr;
  void *user = nullptr;
};

// `ior`: inside over outside. Most walks are ended early, since low orders cost little: a third of the events go to those that
// are followed to the last order. Throws CANCELLED.
Escapes count_escapes(TynContext &context, const TynPhase &phase, double ior, const EscapeOptions &options);

} // namespace tyn
