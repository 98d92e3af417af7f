// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
//
// Text in aligned columns.
#pragma once

#include <string>
#include <vector>

namespace tool {

class Table {
public:
  // The first row is the heading. Columns whose cells below it are numbers go to the right.
  void add(const std::vector<std::string> &row) { rows_.push_back(row); }

  // Prints on standard output, indented, each line without trailing blanks.
  void print(int indent = 2) const;

private:
  std::vector<std::vector<std::string>> rows_;
};

// `value` with `digits` significant ones, without an exponent where that stays readable; "-" if it is not finite.
std::string number(double value, int digits = 4);

} // namespace tool
