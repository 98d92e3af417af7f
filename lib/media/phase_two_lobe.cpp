// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Two Henyey-Greenstein lobes, weight HG(g) + (1 - weight) HG(g2).
#include "core/argument.hpp"
#include "media/phase_kind.hpp"

namespace tyn {
namespace {

void validate_lobes(const TynPhase &phase) {
  require_anisotropy("g", phase.g);
  require_anisotropy("g2", phase.g2);
  require_between("TynPhase::weight", phase.weight, 0, 1);
}

std::function<double(double)> density(const TynPhase &phase) {
  return [g = phase.g, g2 = phase.g2, weight = phase.weight](double cosine) {
    return weight * henyey_greenstein(cosine, g) + (1 - weight) * henyey_greenstein(cosine, g2);
  };
}

std::vector<double> moments(const TynPhase &phase, size_t count) {
  std::vector<double> first = powers(phase.g, count);
  const std::vector<double> second = powers(phase.g2, count);
  for (size_t l = 0; l < count; l++)
    first[l] = phase.weight * first[l] + (1 - phase.weight) * second[l];
  return first;
}

TynPhaseRecord record(const TynPhase &phase, std::vector<float> &) {
  TynPhaseRecord result{};
  result.kind = TYN_PHASE_TWO_LOBE;
  result.g = inner_float(phase.g);
  result.g2 = inner_float(phase.g2);
  result.weight = float(phase.weight);
  return result;
}

} // namespace

const PhaseKind two_lobe_phase = {"two-lobe", validate_lobes, density, moments, record};

} // namespace tyn
