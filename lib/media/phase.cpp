// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The table of the kinds of phase function, and what is the same for all.
#include "media/phase.hpp"

#include <iterator>

#include "core/argument.hpp"
#include "core/opencl_shim.hpp"
#include "media/phase_kind.hpp"

namespace tyn {
namespace {

static_assert(PHASE_RAYLEIGH == TYN_PHASE_RAYLEIGH && PHASE_HENYEY_GREENSTEIN == TYN_PHASE_HENYEY_GREENSTEIN &&
                  PHASE_TWO_LOBE == TYN_PHASE_TWO_LOBE && PHASE_DRAINE == TYN_PHASE_DRAINE &&
                  PHASE_TABULATED == TYN_PHASE_TABULATED,
              "kernels and API number the kinds alike");

// By TYN_PHASE_*.
const PhaseKind *const kinds[] = {&isotropic_phase, &rayleigh_phase, &henyey_greenstein_phase,
                                  &two_lobe_phase,  &draine_phase,   &tabulated_phase};
static_assert(std::size(kinds) == TYN_PHASE_KIND_COUNT, "every kind has its row");

} // namespace

void validate(const TynPhase &phase) {
  require_choice("TynPhase::kind", phase.kind, TYN_PHASE_KIND_COUNT);
  kinds[phase.kind]->validate(phase);
}

OwnedPhase::OwnedPhase(const TynPhase &given) : phase(given) {
  phase.size = sizeof phase;
  if (phase.kind == TYN_PHASE_TABULATED) {
    cosines.assign(given.cosines, given.cosines + given.count);
    values.assign(given.values, given.values + given.count);
  } else {
    phase.count = 0; // whatever is there is not used
  }
  phase.cosines = cosines.empty() ? nullptr : cosines.data();
  phase.values = values.empty() ? nullptr : values.data();
}

OwnedPhase &OwnedPhase::operator=(const OwnedPhase &other) {
  OwnedPhase copy(other);
  cosines.swap(copy.cosines); // the elements stay where the copy's pointers say
  values.swap(copy.values);
  phase = copy.phase;
  return *this;
}

TynPhaseRecord PhaseTables::add(const TynPhase &phase) { return kinds[phase.kind]->record(phase, data); }

TynPhaseRecord PhaseTables::henyey_greenstein(double g) {
  TynPhaseRecord record{};
  record.kind = TYN_PHASE_HENYEY_GREENSTEIN;
  record.g = inner_float(g);
  return record;
}

std::function<double(double)> phase_density(const TynPhase &phase) { return kinds[phase.kind]->density(phase); }

std::vector<double> phase_moments(const TynPhase &phase, size_t count) {
  return kinds[phase.kind]->moments(phase, count);
}

double phase_mean_cosine(const TynPhase &phase) { return phase_moments(phase, 2)[1]; }

} // namespace tyn

extern "C" const char *tyn_phase_name(uint32_t kind) {
  return kind < TYN_PHASE_KIND_COUNT ? tyn::kinds[kind]->name : nullptr;
}
