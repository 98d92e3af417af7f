// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Henyey & Greenstein 1941; isotropic scattering is their function with g = 0.
#include <algorithm>
#include <cmath>

#include "core/status.hpp"
#include "media/phase_kind.hpp"

namespace tyn {

void require_anisotropy(const char *field, double g) {
  if (!(g > -1 && g < 1))
    fail(TYN_ERROR_INVALID_ARGUMENT, "TynPhase::%s is %g; it must be in (-1, 1)", field, g);
}

double henyey_greenstein(double cosine, double g) {
  // 1 + g^2 - 2 g cos without its cancellation at the peak
  const double a = std::abs(g);
  const double s = (1 - a) * (1 - a) + 2 * a * (1 - std::copysign(1.0, g) * cosine);
  return (1 - a) * (1 + a) / (4 * pi * s * std::sqrt(s));
}

std::vector<double> powers(double g, size_t count) {
  std::vector<double> result(count);
  double power = 1;
  for (double &moment : result) {
    moment = power;
    power *= g;
  }
  return result;
}

float inner_float(double g) {
  const float largest = std::nextafter(1.0f, 0.0f);
  return std::clamp(float(g), -largest, largest);
}

namespace {

void validate_nothing(const TynPhase &) {}

void validate_g(const TynPhase &phase) { require_anisotropy("g", phase.g); }

std::function<double(double)> isotropic_density(const TynPhase &) {
  return [](double) { return 1 / (4 * pi); };
}

std::function<double(double)> density(const TynPhase &phase) {
  return [g = phase.g](double cosine) { return henyey_greenstein(cosine, g); };
}

std::vector<double> isotropic_moments(const TynPhase &, size_t count) { return powers(0, count); }

std::vector<double> moments(const TynPhase &phase, size_t count) { return powers(phase.g, count); }

TynPhaseRecord isotropic_record(const TynPhase &, std::vector<float> &) { return PhaseTables::henyey_greenstein(0); }

TynPhaseRecord record(const TynPhase &phase, std::vector<float> &) { return PhaseTables::henyey_greenstein(phase.g); }

} // namespace

const PhaseKind isotropic_phase = {"isotropic", validate_nothing, isotropic_density, isotropic_moments,
                                   isotropic_record};
const PhaseKind henyey_greenstein_phase = {"henyey-greenstein", validate_g, density, moments, record};

} // namespace tyn
