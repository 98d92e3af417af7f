// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace tyn {

// Integrals of f P_l over [-1, 1] for l = 0 .. count - 1, f linear between values[i] at cosines[i], which increase from -1 to 1.
std::vector<double> linear_legendre_moments(const double *cosines, const std::vector<double> &values, size_t count);

} // namespace tyn
