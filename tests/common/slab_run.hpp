// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Runs of the slab engine, with everything that they give.
#pragma once

#include <vector>

#include "common/exact_slab.hpp"
#include "tyndall/tyndall_slab.h"

namespace tyn_test {

struct SlabOutcome {
  TynSlabRun run{};
  std::vector<TynSlabTotals> totals;                    // one a channel
  std::vector<std::vector<std::vector<double>>> values; // [channel][quantity]
  std::vector<std::vector<std::vector<double>>> errors;

  const std::vector<double> &value(uint32_t quantity, size_t channel = 0) const { return values[channel][quantity]; }
  const std::vector<double> &error(uint32_t quantity, size_t channel = 0) const { return errors[channel][quantity]; }
};

// Runs on the shared context unless another one is given. A failure fails the test.
SlabOutcome simulate(const TynSlab &slab, const TynSlabOptions &options, TynContext *context = nullptr);

// Options with a photon count and a seed.
TynSlabOptions slab_options(uint64_t photons, uint64_t seed = 0);

// How many standard errors an estimate is off; 0 if both agree exactly.
double deviation(const TynEstimate &estimate, double expected);

} // namespace tyn_test
