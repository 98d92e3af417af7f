// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
//
// The library's view of a command line.
#pragma once

#include "slab/arguments.hpp"

namespace slab {

// A TynSlab with everything that it points to.
class Stack {
public:
  // Keeps pointers into `arguments`.
  explicit Stack(const Arguments &arguments);
  Stack(const Stack &) = delete;
  Stack &operator=(const Stack &) = delete;

  const TynSlab &slab() const { return slab_; }

  // The options, with the sweep's coefficients.
  TynSlabOptions options() const;

private:
  void add(const LayerArgument &layer, double albedo);
  void set_sweep();

  const Arguments &arguments_;
  TynPhase phase_ = tyn_phase();
  std::vector<std::vector<double>> coefficients_; // where a sweep changes a layer's own
  std::vector<TynSlabLayer> layers_;
  std::vector<double> sweep_sigma_a_, sweep_sigma_s_;
  TynSlab slab_ = tyn_slab();
};

} // namespace slab
