// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// A phase function that is linear in cos between the entries of a table.
#include <algorithm>
#include <cmath>

#include "core/status.hpp"
#include "media/legendre.hpp"
#include "media/phase_kind.hpp"

namespace tyn {
namespace {

constexpr uint32_t max_entries = 65536;
// The least integral over cos of a table whose largest value is 1, so that densities and their squares are floats.
constexpr double least_integral = 1e-18;

double largest_value(const TynPhase &phase) { return *std::max_element(phase.values, phase.values + phase.count); }

// Integral over cos of interval i of the table divided by its largest value, which may be near the ends of double's range.
double interval_integral(const TynPhase &phase, double largest, uint32_t i) {
  return 0.5 * (phase.values[i] / largest + phase.values[i + 1] / largest) * (phase.cosines[i + 1] - phase.cosines[i]);
}

double integral(const TynPhase &phase, double largest) {
  double sum = 0;
  for (uint32_t i = 0; i + 1 < phase.count; i++)
    sum += interval_integral(phase, largest, i);
  return sum;
}

void validate_cosines(const TynPhase &phase) {
  if (phase.cosines[0] != -1 || phase.cosines[phase.count - 1] != 1)
    fail(TYN_ERROR_INVALID_ARGUMENT, "TynPhase::cosines go from %g to %g; they must go from -1 to 1", phase.cosines[0],
         phase.cosines[phase.count - 1]);
  for (uint32_t i = 1; i < phase.count; i++)
    if (!(phase.cosines[i] > phase.cosines[i - 1]))
      fail(TYN_ERROR_INVALID_ARGUMENT, "TynPhase::cosines[%u] is %.17g after %.17g; they must increase", i,
           phase.cosines[i], phase.cosines[i - 1]);
}

void validate_values(const TynPhase &phase) {
  for (uint32_t i = 0; i < phase.count; i++)
    if (!(std::isfinite(phase.values[i]) && phase.values[i] >= 0))
      fail(TYN_ERROR_INVALID_ARGUMENT, "TynPhase::values[%u] is %g; it must be finite and >= 0", i, phase.values[i]);
  const double largest = largest_value(phase);
  if (!(largest > 0))
    fail(TYN_ERROR_INVALID_ARGUMENT, "TynPhase::values are all 0; they must not be");
  const double area = integral(phase, largest);
  if (!(area >= least_integral))
    fail(TYN_ERROR_INVALID_ARGUMENT,
         "TynPhase::values are a peak of %g whose integral over cos is %g of that; it must be at least %g", largest,
         area, least_integral);
}

void validate_table(const TynPhase &phase) {
  if (phase.count < 2 || phase.count > max_entries)
    fail(TYN_ERROR_INVALID_ARGUMENT, "TynPhase::count is %u; it must be in 2 .. %u", phase.count, max_entries);
  if (!phase.cosines || !phase.values)
    fail(TYN_ERROR_INVALID_ARGUMENT, "TynPhase::%s is NULL; a tabulated phase function needs it",
         phase.cosines ? "values" : "cosines");
  validate_cosines(phase);
  validate_values(phase);
}

// The table's values in 1/sr.
std::vector<double> normalized(const TynPhase &phase) {
  const double largest = largest_value(phase);
  const double norm = 2 * pi * integral(phase, largest);
  std::vector<double> values(phase.values, phase.values + phase.count);
  for (double &value : values)
    value = value / largest / norm;
  return values;
}

std::function<double(double)> density(const TynPhase &phase) {
  const double *cosines = phase.cosines;
  return [cosines, values = normalized(phase)](double cosine) {
    const size_t last = values.size() - 1;
    const auto above = std::upper_bound(cosines + 1, cosines + last, cosine);
    const size_t i = size_t(above - cosines) - 1;
    const double t = (cosine - cosines[i]) / (cosines[i + 1] - cosines[i]);
    return (1 - t) * values[i] + t * values[i + 1];
  };
}

std::vector<double> moments(const TynPhase &phase, size_t count) {
  std::vector<double> values = normalized(phase);
  for (double &value : values)
    value *= 2 * pi;
  return linear_legendre_moments(phase.cosines, values, count);
}

// See phase_tabulated.clh. Entries run the other way there, from forward to backward.
TynPhaseRecord record(const TynPhase &phase, std::vector<float> &tables) {
  const uint32_t n = phase.count;
  const size_t first = tables.size();
  if (first + 3 * size_t(n) > UINT32_MAX)
    fail(TYN_ERROR_OUT_OF_MEMORY, "the tables of all phase functions have more than 2^32 entries");
  const std::vector<double> values = normalized(phase);
  const double largest = largest_value(phase);
  const double total = integral(phase, largest);
  tables.resize(first + 3 * size_t(n));
  double below = 0, compensation = 0;
  for (uint32_t i = 0; i < n; i++) {
    const uint32_t from = n - 1 - i;
    tables[first + i] = float(1 - phase.cosines[from]);
    tables[first + n + i] = float(values[from]);
    tables[first + 2 * size_t(n) + i] = float(std::min(1.0, below / total));
    if (from == 0)
      break;
    // compensated (Kahan), so that the sum reaches the total, which was added up in the other order, to the last float
    const double term = interval_integral(phase, largest, from - 1) - compensation;
    const double sum = below + term;
    compensation = (sum - below) - term;
    below = sum;
  }
  tables.back() = 1;
  TynPhaseRecord result{};
  result.kind = TYN_PHASE_TABULATED;
  result.table = uint32_t(first);
  result.count = n;
  return result;
}

} // namespace

const PhaseKind tabulated_phase = {"tabulated", validate_table, density, moments, record};

} // namespace tyn
