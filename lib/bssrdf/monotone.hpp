// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace tyn {

// Slopes of the monotone cubics through points of increasing x, two at least (Fritsch & Carlson 1980, with the mean of Brodlie
// 1980).
std::vector<double> monotone_slopes(const std::vector<double> &x, const std::vector<double> &y);

// The cubic between two points (x[0], y[0]) and (x[1], y[1]) that has those slopes there (Hermite).
double hermite(const double x[2], const double y[2], const double slope[2], double at);

} // namespace tyn
