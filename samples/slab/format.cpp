// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "slab/format.hpp"

#include "common/table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace slab {

std::string with_error(double value, double error, const char *sign) {
  if (!std::isfinite(error))
    return tool::number(value, 4) + sign + "unknown";
  if (!(error > 1e-8 * std::fabs(value))) // what is left is rounding
    return tool::number(value, 7);
  const int decimals = std::clamp(1 - static_cast<int>(std::floor(std::log10(error))), 0, 15);
  char text[128];
  std::snprintf(text, sizeof text, "%.*f%s%.*f", decimals, value, sign, decimals, error);
  return text;
}

} // namespace slab
