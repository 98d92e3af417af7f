// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>

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
    return {mean, std::numeric_limits<double>::quiet_NaN()};
  // what the rounding of the sums can make of batches that are all alike is no spread
  const double rounding = 4 * std::sqrt(batches) * std::numeric_limits<double>::epsilon() * sum_of_squares[index];
  const double spread = sum_of_squares[index] - mean * sum[index];
  return {mean, spread > rounding ? std::sqrt(spread / (batches - 1) / photons_total) : 0};
}

} // namespace tyn
