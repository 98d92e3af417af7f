// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
//
// Everything that a run has to say, read out of the library once for all kinds of output.
#pragma once

#include "common/tool.hpp"
#include "slab/arguments.hpp"

#include <array>
#include <memory>

namespace slab {

struct Curve {
  std::vector<double> values, errors; // empty: not asked for
};

struct ChannelResults {
  TynSlabTotals totals = {};
  std::array<Curve, TYN_SLAB_QUANTITY_COUNT> quantities;
  TynAddingDoublingResult exact = {}; // with --exact
};

struct Results {
  bool interrupted = false;
  TynSlabRun run = {};
  TynDeviceInfo device = {};
  std::vector<std::string> names; // of the channels
  std::vector<ChannelResults> channels;
};

using ResultHandle = std::unique_ptr<TynSlabResult, tool::Releaser<TynSlabResult, tyn_slab_result_release>>;

// Reads totals, quantities and the run.
void read_results(const TynSlabResult *handle, Results &results);

// Runs adding-doubling for every channel. Needs no device.
std::vector<TynAddingDoublingResult> solve_exactly(const TynSlab &slab, const Arguments &arguments);

// Names of the channels: R, G, B, or their numbers.
std::vector<std::string> channel_names(const Arguments &arguments);

// How many standard errors an estimate is away from an exact value; 0 where it is exact itself, NaN where its
// error is not known.
double deviation(const TynEstimate &estimate, double exact, double accuracy);

} // namespace slab
