// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The calls of tyndall_phase.h on phase functions. They have no context: errors are statuses only.
#include <algorithm>
#include <cmath>

#include "core/context.hpp"
#include "core/input.hpp"
#include "core/opencl_shim.hpp"
#include "media/phase.hpp"

namespace tyn {
namespace {

TynPhase read_phase(const TynPhase *given) {
  const TynPhase phase = read_struct("TynPhase", given, tyn_phase());
  validate(phase);
  return phase;
}

void require_cosines(const double *cosines, size_t count) {
  if (count > 0)
    require_pointer("cosines", cosines);
  for (size_t i = 0; i < count; i++)
    require_between("cosines", cosines[i], -1, 1);
}

// scale * p(cos) for every cosine; nothing is written unless all can be.
TynStatus evaluate(const TynPhase *given, const double *cosines, size_t count, double scale, double *values) {
  return guarded(nullptr, [&] {
    const TynPhase phase = read_phase(given);
    require_cosines(cosines, count);
    if (count > 0)
      require_pointer("values", values);
    const auto density = phase_density(phase);
    std::transform(cosines, cosines + count, values, [&](double cosine) { return scale * density(cosine); });
  });
}

// The cosine that belongs to a number of the stream: a function of seed and number alone.
double sample(const TynPhaseRecord &record, const float *tables, uint64_t seed, uint64_t number) {
  using namespace tyn_kernel;
  const uint4 counter = tyn_uint4(uint(number), uint(number >> 32), 0, TYN_DOMAIN_PHASE);
  const uint4 random = tyn_philox(counter, tyn_uint2(uint(seed), uint(seed >> 32)));
  return std::max(-1.0, 1 - double(tyn_phase_sample_away(record, tables, random)));
}

} // namespace
} // namespace tyn

using namespace tyn;

extern "C" {

TynStatus tyn_phase_value(const TynPhase *phase, const double *cosines, size_t count, double *values) {
  return evaluate(phase, cosines, count, 1, values);
}

TynStatus tyn_phase_pdf(const TynPhase *phase, const double *cosines, size_t count, double *pdf) {
  return evaluate(phase, cosines, count, 6.28318530717958647693, pdf);
}

TynStatus tyn_phase_sample(const TynPhase *phase, uint64_t seed, uint64_t first, size_t count, double *cosines) {
  return guarded(nullptr, [&] {
    const TynPhase valid = read_phase(phase);
    if (count > 0)
      require_pointer("cosines", cosines);
    PhaseTables tables;
    const TynPhaseRecord record = tables.add(valid);
    for (size_t i = 0; i < count; i++)
      cosines[i] = sample(record, tables.data.data(), seed, first + i);
  });
}

TynStatus tyn_phase_moments(const TynPhase *phase, size_t count, double *moments) {
  return guarded(nullptr, [&] {
    const TynPhase valid = read_phase(phase);
    if (count > 0)
      require_pointer("moments", moments);
    const std::vector<double> result = phase_moments(valid, count);
    std::copy(result.begin(), result.end(), moments);
  });
}

TynStatus tyn_phase_mean_cosine(const TynPhase *phase, double *mean_cosine) {
  return guarded(nullptr, [&] {
    const TynPhase valid = read_phase(phase);
    require_pointer("mean_cosine", mean_cosine);
    *mean_cosine = phase_mean_cosine(valid);
  });
}

} // extern "C"
