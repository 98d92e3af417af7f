// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Phase functions on the host: checks, copies, closed forms in double precision, and the records that kernels read.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "kernels/shared.h"
#include "tyndall/tyndall_phase.h"

namespace tyn {

// Throws INVALID_ARGUMENT with the field, its value and what is allowed. phase.size is not looked at: see read_struct.
void validate(const TynPhase &phase);

// A valid phase function with a table of its own.
class OwnedPhase {
public:
  OwnedPhase() : OwnedPhase(tyn_phase()) {}
  explicit OwnedPhase(const TynPhase &given);
  OwnedPhase(const OwnedPhase &other) : OwnedPhase(other.phase) {}
  OwnedPhase &operator=(const OwnedPhase &other);

  // Its pointers are good as long as this object lives and is not assigned to.
  const TynPhase &get() const { return phase; }

private:
  TynPhase phase;
  std::vector<double> cosines, values;
};

// Records for kernels/phase.clh, and the tables that they point into.
struct PhaseTables {
  std::vector<float> data;

  // Appends the table of a valid phase function, if it has one.
  TynPhaseRecord add(const TynPhase &phase);
  static TynPhaseRecord henyey_greenstein(double g);
};

// p(cos) in 1/sr of a valid phase function whose pointers outlive the result.
std::function<double(double cosine)> phase_density(const TynPhase &phase);

// Legendre moments chi_0 .. chi_(count - 1) of a valid phase function, to 1e-10.
std::vector<double> phase_moments(const TynPhase &phase, size_t count);
double phase_mean_cosine(const TynPhase &phase);

} // namespace tyn
