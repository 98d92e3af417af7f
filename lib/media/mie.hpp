// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Lorenz-Mie scattering by one sphere.
#pragma once

#include <complex>
#include <cstddef>
#include <vector>

#include "tyndall/tyndall_phase.h"

namespace tyn {

// The largest size parameter, and the limits of |m|, between which all recurrences stay within double's range.
constexpr double max_size_parameter = 1e5, min_relative_index = 1e-3, max_relative_index = 1e3;

// Throws INVALID_ARGUMENT unless n > 0, k >= 0 and |m| is within the limits.
std::complex<double> read_relative_index(const double *index);

// The coefficients a_n and b_n of the scattered field, n = 1 .. a.size(), each divided by `scale`, which keeps those of the
// smallest spheres in range.
struct MieSeries {
  double x;
  bool absorbs;
  double scale = 1;
  std::vector<std::complex<double>> a, b;
};

MieSeries mie_series(double x, std::complex<double> m);

TynMie mie_efficiencies(const MieSeries &series);

// (|S_1|^2 + |S_2|^2) / 2 at each cosine, divided by scale^2: k^2 / scale^2 times the differential cross-section.
void mie_intensities(const MieSeries &series, const double *cosines, size_t count, double *intensities);

// p(cos) in 1/sr. A sphere of m = 1 scatters nothing; its p counts as isotropic.
void mie_phase_function(const MieSeries &series, const double *cosines, size_t count, double *values);

} // namespace tyn
