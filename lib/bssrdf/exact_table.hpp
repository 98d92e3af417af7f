// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The walks that the exact model is made of: counted when they are first needed, then kept in the cache's folder.
#pragma once

#include <array>
#include <memory>
#include <string>

#include "bssrdf/escape_light.hpp"
#include "kernels/shared_bssrdf.h"
#include "slab/escapes.hpp"

namespace tyn {

// For one phase function and one index of refraction.
struct ExactTable {
  static constexpr int STEPS = 16; // of (1 - albedo)^(1/4), which holds many of albedos near 1

  Escapes escapes;
  double mean_cosine = 0;
  // What comes back scattered twice or more, by adding and doubling over what the walks give, at albedos with
  // (1 - albedo)^(1/4) = i / STEPS: it takes the statistical error out of the totals.
  std::array<double, STEPS + 1> corrections{};
  // By adding and doubling too, at the same albedos: what comes back of light that arrived with a cosine of i / (COSINES - 1),
  // over what comes back of perpendicular light.
  static constexpr int COSINES = TYN_ANGLES_ENTRIES;
  std::array<std::array<double, COSINES>, STEPS + 1> entries{};

  // That light, corrected.
  EscapeLight light(double absorption) const;
  std::array<double, COSINES> entries_at(double absorption) const;
};

// The tables that a model's channels share.
class ExactTables {
public:
  ExactTables(TynContext &context_, const EscapeOptions &options_) : context(context_), options(options_) {}

  // `ior`: inside over outside. Throws CANCELLED.
  const ExactTable &table(const TynPhase &phase, double ior);

private:
  ExactTable make(const TynPhase &phase, double ior) const;

  TynContext &context;
  const EscapeOptions options;
  std::string key; // of what `last` is
  std::unique_ptr<ExactTable> last;
};

} // namespace tyn
