// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// From the plane's spatial frequencies back to radii: f(r) = 1 / (2 pi) int_0^inf s F(s) J_0(s r) ds, the inverse of
// F(s) = int_0^inf 2 pi r f(r) J_0(s r) dr; so F(0) is the integral of f over the plane.
#pragma once

#include <complex>
#include <functional>
#include <vector>

namespace tyn {

using HankelTransform = std::function<std::complex<double>(std::complex<double>)>;

// `magnitude` is the sum of the absolute values of the terms that `value` is the sum of: value is known to about 1e-12 of it.
struct HankelValue {
  double value, magnitude;
};

constexpr double HANKEL_STEP = 0.0625; // of ln r

// f at the radii first exp(i HANKEL_STEP), i = 0 .. count - 1. `transform`: real for real s, analytic and bounded where
// 0 <= arg s <= pi / 4 and, for the precision above, without poles near that wedge.
std::vector<HankelValue> inverse_hankel(const HankelTransform &transform, double first, size_t count);

// Kelvin's functions ker x + i kei x = K_0(x exp(i pi / 4)), x > 0.
std::complex<double> kelvin(double x);

} // namespace tyn
