// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// From the integers that a kernel adds up to the quantities of the API.
#pragma once

#include <vector>

#include "kernels/shared_slab.h"
#include "slab/moments.hpp"
#include "slab/result.hpp"
#include "slab/validate.hpp"

namespace tyn {

// Sets the bins, their scales and the places of the tallies in the kernel's parameters. Throws INVALID_ARGUMENT if there are
// too many.
void lay_out_tallies(const TynSlabOptions &options, size_t channels, TynSlabParameters &parameters);

// The estimates of one channel, batch by batch.
class Estimates {
public:
  // `specular`: the fraction that the first interface reflects before a photon starts.
  Estimates(const Slab &slab, size_t channel, const TynSlabOptions &options, const TynSlabParameters &parameters,
            double specular);

  // A batch's tallies.
  void add(const int64_t *tallies, uint64_t photons);

  // The larger standard error of total reflectance and transmittance.
  double error() const;
  uint64_t events() const { return event_count; }
  SlabChannelResult result() const;

private:
  enum Total { Specular, DiffuseR, Reflectance, Direct, DiffuseT, Transmittance, Absorbed, Cut, TotalCount };

  double surface_reflection(const int64_t *tallies, uint64_t photons) const;
  void evaluate_totals(const int64_t *tallies, uint64_t photons);
  void evaluate_sides(uint32_t quantity, const int64_t *tallies, uint32_t first);
  void evaluate_depth(const int64_t *tallies);
  void evaluate_sweep(const int64_t *tallies, uint64_t photons);
  double *values(uint32_t quantity) { return &batch[first[quantity]]; }

  const Slab &slab;
  size_t channel;
  TynSlabParameters parameters;
  double specular;
  uint64_t event_count = 0;
  std::array<size_t, TYN_SLAB_QUANTITY_COUNT> first{}; // of each quantity among the values
  std::array<size_t, TYN_SLAB_QUANTITY_COUNT> count{};
  std::array<std::vector<double>, TYN_SLAB_QUANTITY_COUNT> bin_size; // what a bin's fraction is divided by; empty: 1
  std::vector<double> batch;                                         // the values of the batch at hand
  Moments moments;
};

} // namespace tyn
