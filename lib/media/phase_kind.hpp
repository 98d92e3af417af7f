// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// What every kind of phase function offers: a row of the table in phase.cpp. Each has a file of its own here, and a namesake in
// kernels/ that draws from it.
#pragma once

#include "core/pi.hpp"
#include "media/phase.hpp"

namespace tyn {

struct PhaseKind {
  const char *name;
  void (*validate)(const TynPhase &phase);
  // p(cos) in 1/sr
  std::function<double(double)> (*density)(const TynPhase &phase);
  // chi_0 .. chi_(count - 1)
  std::vector<double> (*moments)(const TynPhase &phase, size_t count);
  // The parameters of `kind`; a table is appended to `tables`.
  TynPhaseRecord (*record)(const TynPhase &phase, std::vector<float> &tables);
};

extern const PhaseKind isotropic_phase, rayleigh_phase, henyey_greenstein_phase, two_lobe_phase, draine_phase,
    tabulated_phase;

// Throws unless -1 < g < 1.
void require_anisotropy(const char *field, double g);
// p(cos) of Henyey and Greenstein.
double henyey_greenstein(double cosine, double g);
// g, g^2, ... up to g^(count - 1), after 1: the moments of Henyey and Greenstein.
std::vector<double> powers(double g, size_t count);
// The float nearest to g inside (-1, 1): the kernels divide by 1 - |g|.
float inner_float(double g);

} // namespace tyn
