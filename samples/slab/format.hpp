// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
//
// Estimates as text.
#pragma once

#include <string>

namespace slab {

// "0.09738 +- 0.00012": the value to the second digit of its error; without one if it is exact, which
// rounding aside is below a part in 1e8. `sign` stands between.
std::string with_error(double value, double error, const char *sign = " +- ");

} // namespace slab
