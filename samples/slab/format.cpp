// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "slab/format.hpp"

#include "common/table.hpp"

#include <algorithm>
#include <charconv>
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

std::string exactly(double value) {
  char text[32];
  return std::string(text, std::to_chars(text, text + sizeof text, value).ptr);
}

std::string grouped(uint64_t count) {
  std::string text = std::to_string(count);
  for (size_t end = text.size(); end > 3; end -= 3)
    text.insert(end - 3, "\xc2\xa0");
  return text;
}

std::string per(const std::string &unit, int power) { return unit + "^{\xe2\x88\x92" + std::to_string(power) + "}"; }

} // namespace slab
