// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace tyn {

// One row of an alias table: keep the row if a uniform number is below `threshold`, else take row `alias`.
struct AliasRow {
  float threshold;
  uint32_t alias;
};

// Rows from which row i is drawn with probability weights[i] / sum (Walker 1977; construction by Vose 1991). Weights are
// >= 0, with a sum > 0.
std::vector<AliasRow> alias_table(const std::vector<double> &weights);

} // namespace tyn
