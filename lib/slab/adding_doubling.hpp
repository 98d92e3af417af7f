// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Adding-doubling for one channel of a slab (van de Hulst 1980; Prahl 1995).
#pragma once

#include <vector>

#include "slab/validate.hpp"

namespace tyn {

struct Light {
  bool diffuse;
  double mu; // of collimated light, in the medium above
};

struct Totals {
  double reflectance, transmittance;
  unsigned nodes;
};

struct AngularOutput {
  std::vector<double> reflected, transmitted; // 1/sr
};

// Unscattered light, exactly.
struct Unscattered {
  double reflectance, transmittance;
};

Unscattered unscattered(const Slab &slab, uint32_t channel, const Light &light);

// With about `nodes` nodes. `cosines` and `output`: angular output; may be empty and NULL.
Totals add_layers(const Slab &slab, uint32_t channel, const Light &light, unsigned nodes,
                  const std::vector<double> &cosines, AngularOutput *output);

} // namespace tyn
