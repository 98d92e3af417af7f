// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "bssrdf/exact_table.hpp"

#include <algorithm>
#include <cmath>

#include "bssrdf/exact_file.hpp"
#include "bssrdf/single_scattering.hpp"
#include "bssrdf/surface_albedo.hpp"
#include "core/cache.hpp"
#include "media/phase.hpp"

namespace tyn {
namespace {

constexpr double GRAZING = 1.0 / 64; // the least cosine, in the place of 0

HalfSpace half_space(const TynPhase &phase, double ior, double absorption) {
  return {phase, std::max(ior, 1.0), std::max(1 / ior, 1.0), absorption, 1 - absorption};
}

// By adding and doubling, with single scattering, which is in closed form, taken off.
double multiple_albedo(const TynPhase &phase, double ior, double absorption) {
  const SingleScattering single(1 - absorption, absorption, ior, INFINITY, phase);
  const double all = absorption > 0 ? surface_albedo(half_space(phase, ior, absorption), false)
                                    : 1; // a white one gives back all that gets in
  return all - single.half_space_albedo();
}

std::array<double, ExactTable::COSINES> entry_factors(const TynPhase &phase, double ior, double absorption) {
  std::array<double, ExactTable::COSINES> factors;
  factors.fill(1);
  if (absorption == 0)
    return factors;
  std::vector<double> cosines;
  for (int i = 0; i < ExactTable::COSINES; ++i)
    cosines.push_back(std::max(double(i) / (ExactTable::COSINES - 1), GRAZING));
  const std::vector<double> albedos = surface_albedos(half_space(phase, ior, absorption), cosines);
  for (size_t i = 0; i < factors.size(); ++i)
    factors[i] = albedos[i] / albedos.back();
  return factors;
}

// Between the albedos of the table.
struct Place {
  size_t step;
  double fraction;

  explicit Place(double absorption) {
    const double at = std::min(std::pow(absorption, 0.25), 1.0) * ExactTable::STEPS;
    step = std::min(size_t(at), size_t(ExactTable::STEPS - 1));
    fraction = at - double(step);
  }
  double between(double below, double above) const { return below + fraction * (above - below); }
};

} // namespace

EscapeLight ExactTable::light(double absorption) const {
  EscapeLight light = light_of(escapes, mean_cosine, absorption);
  const Place place(absorption);
  const double factor = place.between(corrections[place.step], corrections[place.step + 1]);
  for (size_t cell = 0; cell < light.power.size(); ++cell) {
    light.power[cell] *= factor;
    light.variance[cell] *= factor * factor;
  }
  return light;
}

std::array<double, ExactTable::COSINES> ExactTable::entries_at(double absorption) const {
  const Place place(absorption);
  std::array<double, COSINES> factors;
  for (size_t i = 0; i < factors.size(); ++i)
    factors[i] = place.between(entries[place.step][i], entries[place.step + 1][i]);
  return factors;
}

ExactTable ExactTables::make(const TynPhase &phase, double ior) const {
  ExactTable table;
  table.mean_cosine = phase_mean_cosine(phase);
  table.escapes = count_escapes(context, phase, ior, options);
  for (int i = 0; i < ExactTable::STEPS; ++i) {
    const double absorption = std::pow(double(i) / ExactTable::STEPS, 4);
    const double counted = light_of(table.escapes, table.mean_cosine, absorption).sum();
    table.corrections[size_t(i)] = counted > 0 ? multiple_albedo(phase, ior, absorption) / counted : 1;
    table.entries[size_t(i)] = entry_factors(phase, ior, absorption);
  }
  table.corrections.back() = table.corrections[ExactTable::STEPS - 1];
  table.entries.back() = table.entries[ExactTable::STEPS - 1];
  return table;
}

const ExactTable &ExactTables::table(const TynPhase &phase, double ior) {
  const std::string wanted = exact_key(phase, ior, options.events, options.seed);
  if (last && key == wanted)
    return *last;
  const std::string &folder = context.cache_folder();
  const std::string path = folder.empty() ? "" : cache_path(folder, "exact", wanted);
  auto table = std::make_unique<ExactTable>();
  if (path.empty() || !load_exact_table(path, wanted, phase, *table)) {
    *table = make(phase, ior);
    if (!path.empty())
      store_exact_table(path, wanted, *table);
  }
  last = std::move(table);
  key = wanted;
  return *last;
}

} // namespace tyn
