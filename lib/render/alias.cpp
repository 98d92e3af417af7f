// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "render/alias.hpp"

#include <cstddef>
#include <numeric>

namespace tyn {

std::vector<AliasRow> alias_table(const std::vector<double> &weights) {
  const size_t count = weights.size();
  const double scale = double(count) / std::accumulate(weights.begin(), weights.end(), 0.0);
  std::vector<AliasRow> rows(count);
  std::vector<double> left(count); // what is still to be given out, relative to the mean
  std::vector<uint32_t> small, large;
  for (size_t i = 0; i < count; i++) {
    left[i] = weights[i] * scale;
    rows[i] = {1.0f, uint32_t(i)};
    (left[i] < 1 ? small : large).push_back(uint32_t(i));
  }
  while (!small.empty() && !large.empty()) {
    const uint32_t low = small.back(), high = large.back();
    small.pop_back();
    rows[low] = {float(left[low]), high};
    left[high] -= 1 - left[low];
    if (left[high] < 1) {
      large.pop_back();
      small.push_back(high);
    }
  }
  // What is left over differs from 1 by rounding alone, except that a weight of 0 must never be drawn.
  for (const uint32_t row : small)
    if (weights[row] == 0)
      rows[row] = {0.0f, large.empty() ? rows[row].alias : large.back()};
  return rows;
}

} // namespace tyn
