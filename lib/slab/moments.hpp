// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Means and standard errors from independent batches of photons.
#pragma once

#include <cstdint>
#include <vector>

#include "tyndall/tyndall_slab.h"

namespace tyn {

// Many estimates at once, each the mean over photons of what one of them contributes.
class Moments {
public:
  explicit Moments(size_t size) : sum(size), sum_of_squares(size) {}

  // A batch of `photons`, whose contributions add up to `sums`.
  void add(const std::vector<double> &sums, uint64_t photons);

  // Batches may differ in size n_b. With their means m_b and the mean m of all, the variance of one photon's contribution is
  // estimated by sum n_b (m_b - m)^2 / (batches - 1). A single batch says nothing of its error: NaN.
  TynEstimate estimate(size_t index) const;

private:
  std::vector<double> sum;
  std::vector<double> sum_of_squares; // of the batches' sums, each divided by its photons
  double photons_total = 0;
  double batches = 0;
};

} // namespace tyn
