// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

namespace tyn {

// int f(x) dx from a to b of a smooth function, to about the tolerance times its size (Gauss-Legendre with 16 points; halved
// where two halves disagree with the whole).
double integrate(const std::function<double(double)> &f, double a, double b, double tolerance = 1e-10);

} // namespace tyn
