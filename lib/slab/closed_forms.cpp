// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The closed forms of Hanrahan's lecture on participating media (CS348B, lecture 16, 2005).
#include <cmath>

#include "tyndall/tyndall_exact.h"

namespace {

bool is_cosine(double mu) { return mu > 0 && mu <= 1; }
bool is_albedo(double albedo) { return albedo >= 0 && albedo <= 1; }
bool is_phase(double phase) { return phase >= 0 && std::isfinite(phase); }

} // namespace

double tyn_reduced_intensity(double tau, double mu) {
  if (!(tau >= 0) || !is_cosine(mu))
    return NAN;
  return std::exp(-tau / mu);
}

double tyn_effective_source(double albedo, double phase, double tau, double mu_i) {
  if (!is_albedo(albedo) || !is_phase(phase))
    return NAN;
  return albedo * phase * tyn_reduced_intensity(tau, mu_i);
}

// Seeliger 1887; Chandrasekhar 1950, section 27: the source above, seen through exp(-tau / mu_o) and summed over depth.
double tyn_seeliger_brdf(double albedo, double phase, double mu_i, double mu_o) {
  if (!is_albedo(albedo) || !is_phase(phase) || !is_cosine(mu_i) || !is_cosine(mu_o))
    return NAN;
  return albedo * phase / (mu_i + mu_o);
}
