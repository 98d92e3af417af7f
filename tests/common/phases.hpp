// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Phase functions of every kind to try things on, and quadrature that follows their peaks.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "media/phase.hpp"

namespace tyn_test {

struct PhaseCase {
  std::string name; // letters and digits
  // Made by the test that needs it: every process of a program lists all cases, and a table takes long.
  std::function<tyn::OwnedPhase()> make;
};

TynPhase henyey_greenstein_phase(double g);
TynPhase two_lobe_phase(double g, double g2, double weight);
TynPhase draine_phase(double g, double alpha);
// A table of `count` entries of the phase function of spheres.
tyn::OwnedPhase mie_phase(double size_parameter, double n, double k, size_t count);

// Of every kind, flat and peaked.
std::vector<PhaseCase> phase_cases();

// Where to cut [-1, 1] so that `phase` is smooth in between: fine near the poles, and at the entries of a table.
std::vector<double> phase_cells(const TynPhase &phase);
// The integral of f over [a, b], by Gauss quadrature with 8 points.
double gauss(double a, double b, const std::function<double(double)> &f);
// The integral of f times the density of the phase function with respect to cos, which tyn_phase_pdf gives.
double phase_integral(const TynPhase &phase, const std::function<double(double)> &f);

// [-1, 1] in bins of about equal share.
struct PhaseBins {
  std::vector<double> edges;  // increasing, from -1 to 1
  std::vector<double> shares; // one less

  PhaseBins(const TynPhase &phase, size_t count);
  size_t find(double cosine) const;
  // Chance of a worse fit of the cosines to the density than theirs.
  double test(const std::vector<double> &cosines) const;
};

} // namespace tyn_test
