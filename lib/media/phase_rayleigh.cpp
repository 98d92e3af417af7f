// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Rayleigh's phase function, 3 / (16 pi) (1 + cos^2) = (P_0 + P_2 / 2) / (4 pi).
#include "media/phase_kind.hpp"

namespace tyn {
namespace {

void validate_nothing(const TynPhase &) {}

std::function<double(double)> density(const TynPhase &) {
  return [](double cosine) { return 3 / (16 * pi) * (1 + cosine * cosine); };
}

std::vector<double> moments(const TynPhase &, size_t count) {
  std::vector<double> result(count, 0.0);
  if (count > 0)
    result[0] = 1;
  if (count > 2)
    result[2] = 0.1;
  return result;
}

TynPhaseRecord record(const TynPhase &, std::vector<float> &) {
  TynPhaseRecord result{};
  result.kind = TYN_PHASE_RAYLEIGH;
  return result;
}

} // namespace

const PhaseKind rayleigh_phase = {"rayleigh", validate_nothing, density, moments, record};

} // namespace tyn
