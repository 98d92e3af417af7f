// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// What a model is: a name, and a function that brings a medium's profile to one of the shapes of profile.hpp. A new model is a
// file with that function, an enumerator in tyndall_types.h, and a row in models.cpp.
#pragma once

#include <cstdint>
#include <string>

#include "bssrdf/profile.hpp"
#include "slab/validate.hpp"
#include "tyndall/tyndall_bssrdf.h"

namespace tyn {

class ExactTables;

// One channel of what is modelled.
struct BssrdfInput {
  const Slab &slab;
  const TynBssrdfOptions &options; // checked
  uint32_t channel;
  ExactTables &tables;

  const SlabLayer &top() const { return slab.layers[0]; }
  double sigma_a() const { return top().sigma_a[channel]; }
  double sigma_s() const { return top().sigma_s[channel]; }
  double ior() const { return top().ior / slab.ior_above; } // relative to outside
};

struct BssrdfModel {
  const char *name;
  bool takes_slabs;  // else only half-spaces: one layer without end
  bool takes_stacks; // several layers, of any indices of refraction
  Profile (*prepare)(const BssrdfInput &input);
};

// models.cpp; nullptr past the end.
const BssrdfModel *find_model(uint32_t model);
std::string model_names();

// One file each. Light that arrives perpendicularly, per power that gets into the medium.
Profile standard_dipole(const BssrdfInput &input);
Profile better_dipole(const BssrdfInput &input);
Profile photon_beam_diffusion(const BssrdfInput &input);
Profile multipole(const BssrdfInput &input);
Profile multipole_stack(const BssrdfInput &input); // of several layers
Profile normalized_diffusion(const BssrdfInput &input);
Profile gaussians(const BssrdfInput &input);
Profile single_scattering(const BssrdfInput &input);
Profile quantized_diffusion(const BssrdfInput &input);
Profile directional_dipole(const BssrdfInput &input);
Profile exact(const BssrdfInput &input);

} // namespace tyn
