// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace tyn {

struct Quadrature {
  std::vector<double> points, weights;
};

// Gauss-Legendre quadrature on [0, 1], points increasing.
Quadrature gauss_legendre(unsigned count);

} // namespace tyn
