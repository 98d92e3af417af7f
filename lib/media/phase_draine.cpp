// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Draine's phase function (Draine 2003, eq. 4).
#include "core/argument.hpp"
#include "media/phase_kind.hpp"

namespace tyn {
namespace {

void validate_parameters(const TynPhase &phase) {
  require_anisotropy("g", phase.g);
  require_between("TynPhase::alpha", phase.alpha, 0, 1e6);
}

// The integral of HG(g) (1 + alpha cos^2).
double integral(const TynPhase &phase) { return 1 + phase.alpha * (1 + 2 * phase.g * phase.g) / 3; }

std::function<double(double)> density(const TynPhase &phase) {
  return [g = phase.g, alpha = phase.alpha, norm = integral(phase)](double cosine) {
    return henyey_greenstein(cosine, g) * (1 + alpha * cosine * cosine) / norm;
  };
}

// From those of Henyey and Greenstein, by the recurrence mu P_l = ((l + 1) P_(l+1) + l P_(l-1)) / (2 l + 1) used twice:
// mu^2 P_l = up P_(l+2) + same P_l + down P_(l-2).
std::vector<double> moments(const TynPhase &phase, size_t count) {
  const std::vector<double> chi = powers(phase.g, count + 2);
  const double norm = integral(phase);
  std::vector<double> result(count);
  for (size_t i = 0; i < count; i++) {
    const double l = double(i);
    const double up = (l + 1) * (l + 2) / ((2 * l + 1) * (2 * l + 3));
    const double same = (l + 1) * (l + 1) / ((2 * l + 1) * (2 * l + 3)) + l * l / ((2 * l + 1) * (2 * l - 1));
    const double down = l * (l - 1) / ((2 * l + 1) * (2 * l - 1));
    const double squared = up * chi[i + 2] + same * chi[i] + (i >= 2 ? down * chi[i - 2] : 0);
    result[i] = (chi[i] + phase.alpha * squared) / norm;
  }
  return result;
}

TynPhaseRecord record(const TynPhase &phase, std::vector<float> &) {
  TynPhaseRecord result{};
  result.kind = TYN_PHASE_DRAINE;
  result.g = inner_float(phase.g);
  result.alpha = float(phase.alpha);
  return result;
}

} // namespace

const PhaseKind draine_phase = {"draine", validate_parameters, density, moments, record};

} // namespace tyn
