// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "common/table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace tool {
namespace {

bool is_number(const std::string &cell) {
  return !cell.empty() && cell.find_first_not_of("0123456789.,+-e %") == std::string::npos;
}

// Columns as terminals count them: one for each UTF-8 character.
size_t display_width(const std::string &cell) {
  return std::count_if(cell.begin(), cell.end(), [](char c) { return (c & 0xc0) != 0x80; });
}

} // namespace

void Table::print(int indent) const {
  std::vector<size_t> widths;
  std::vector<bool> to_right;
  for (size_t row = 0; row < rows_.size(); ++row) {
    for (size_t column = 0; column < rows_[row].size(); ++column) {
      if (column >= widths.size()) {
        widths.push_back(0);
        to_right.push_back(true);
      }
      const std::string &cell = rows_[row][column];
      widths[column] = std::max(widths[column], display_width(cell));
      if (row > 0 && !cell.empty() && !is_number(cell))
        to_right[column] = false;
    }
  }
  for (const std::vector<std::string> &row : rows_) {
    std::string line(indent, ' ');
    for (size_t column = 0; column < row.size(); ++column) {
      const std::string padding(widths[column] - display_width(row[column]), ' ');
      line += (column ? "  " : "") + (to_right[column] ? padding + row[column] : row[column] + padding);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    std::printf("%s\n", line.c_str());
  }
}

std::string number(double value, int digits) {
  if (!std::isfinite(value))
    return "-";
  char text[64];
  const double size = std::fabs(value);
  if (size >= 1.0 && size < 1e9) // keep all digits before the point
    digits = std::max(digits, static_cast<int>(std::floor(std::log10(size))) + 1);
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

} // namespace tool
