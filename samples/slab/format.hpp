// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
//
// Values as text.
#pragma once

#include <cstdint>
#include <string>

namespace slab {

// "0.09738 +- 0.00012": the value to the second digit of its error; without one if it is exact, which
// rounding aside is below a part in 1e8. `sign` stands between.
std::string with_error(double value, double error, const char *sign = " +- ");

// The shortest text that reads back as the same number.
std::string exactly(double value);

// "10 000 000", with blanks at which no line is broken.
std::string grouped(uint64_t count);

// A unit with a negative power, for plots.
std::string per(const std::string &unit, int power);

} // namespace slab
