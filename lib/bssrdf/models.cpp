// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// All models, in the order of TYN_BSSRDF_*.
#include <cstring>

#include "bssrdf/model.hpp"

namespace tyn {
namespace {

const BssrdfModel models[] = {
    {"standard-dipole", false, false, standard_dipole},
    {"better-dipole", false, false, better_dipole},
    {"photon-beam-diffusion", false, false, photon_beam_diffusion},
    {"multipole", true, true, multipole},
    {"normalized-diffusion", false, false, normalized_diffusion},
    {"gaussians", true, false, gaussians},
    {"single-scattering", true, false, single_scattering},
    {"quantized-diffusion", false, false, quantized_diffusion},
    {"directional-dipole", false, false, directional_dipole},
    {"exact", false, false, exact},
};
static_assert(sizeof models / sizeof models[0] == TYN_BSSRDF_MODEL_COUNT, "a row for each TYN_BSSRDF_*");

} // namespace

const BssrdfModel *find_model(uint32_t model) { return model < TYN_BSSRDF_MODEL_COUNT ? &models[model] : nullptr; }

std::string model_names() {
  std::string names;
  for (const BssrdfModel &model : models)
    names += std::string(names.empty() ? "" : ", ") + model.name;
  return names;
}

} // namespace tyn

const char *tyn_bssrdf_model_name(uint32_t model) {
  const tyn::BssrdfModel *found = tyn::find_model(model);
  return found ? found->name : nullptr;
}

uint32_t tyn_bssrdf_find_model(const char *name) {
  uint32_t model = 0;
  while (name && model < TYN_BSSRDF_MODEL_COUNT && std::strcmp(tyn::models[model].name, name) != 0)
    model++;
  return name ? model : uint32_t(TYN_BSSRDF_MODEL_COUNT);
}
