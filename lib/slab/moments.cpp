// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "slab/moments.hpp"

namespace tyn {

void Moments::add(const std::vector<double> &sums, uint64_t photons) {
  const double n = double(photons);
  for (size_t i = 0; i < sum.size(); ++i) {
    sum[i] += sums[i];
    sum_of_squares[i] += sums[i] * sums[i] / n;
  }
  photons_total += n;
  ++batches;
}

TynEstimate Moments::estimate(size_t index) const {
  const double mean = sum[index] / photons_total;
  if (batches < 2)
    return {mean, 0};
  const double spread = std::max(0.0, sum_of_squares[index] - mean * sum[index]);
  return {mean, std::sqrt(spread / (batches - 1) / photons_total)};
}

} // namespace tyn
