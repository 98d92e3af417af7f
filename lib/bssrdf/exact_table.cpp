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

// By adding and doubling, with single scattering, which is in closed form, taken off.
double multiple_albedo(const TynPhase &phase, double ior, double absorption) {
  const double outside = std::max(1 / ior, 1.0);
  const HalfSpace medium{phase, ior * outside, outside, absorption, 1 - absorption};
  const SingleScattering single(medium.sigma_s, medium.sigma_a, ior, INFINITY, phase);
  const double all = absorption > 0 ? surface_albedo(medium, false) : 1; // a white one gives back all that gets in
  return all - single.half_space_albedo();
}

} // namespace

EscapeLight ExactTable::light(double absorption) const {
  EscapeLight light = light_of(escapes, mean_cosine, absorption);
  const double place = std::min(std::pow(absorption, 0.25), 1.0) * STEPS;
  const int i = std::min(int(place), STEPS - 1);
  const double factor = corrections[size_t(i)] + (place - i) * (corrections[size_t(i) + 1] - corrections[size_t(i)]);
  for (size_t cell = 0; cell < light.power.size(); ++cell) {
    light.power[cell] *= factor;
    light.variance[cell] *= factor * factor;
  }
  return light;
}

ExactTable ExactTables::make(const TynPhase &phase, double ior) const {
  ExactTable table;
  table.mean_cosine = phase_mean_cosine(phase);
  table.escapes = count_escapes(context, phase, ior, options);
  for (int i = 0; i < ExactTable::STEPS; ++i) {
    const double absorption = std::pow(double(i) / ExactTable::STEPS, 4);
    const double counted = light_of(table.escapes, table.mean_cosine, absorption).sum();
    table.corrections[size_t(i)] = counted > 0 ? multiple_albedo(phase, ior, absorption) / counted : 1;
  }
  table.corrections.back() = table.corrections[ExactTable::STEPS - 1];
  return table;
}

const ExactTable &ExactTables::table(const TynPhase &phase, double ior) {
  const std::string wanted = exact_key(phase, ior, options.events, options.seed);
  if (last && key == wanted)
    return *last;
  const std::string &folder = context.cache_folder();
  const std::string path = folder.empty() ? "" : cache_path(folder, "exact", wanted);
  auto table = std::make_unique<ExactTable>();
  if (path.empty() || !load_exact_table(path, wanted, *table)) {
    *table = make(phase, ior);
    if (!path.empty())
      store_exact_table(path, wanted, *table);
  }
  last = std::move(table);
  key = wanted;
  return *last;
}

} // namespace tyn
