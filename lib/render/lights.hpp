// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The table from which light samples are drawn: lights, emissive triangles and the environment, each with a chance in
// proportion to the light that it sends into the scene.
#pragma once

#include <vector>

#include "kernels/shared_render.h"
#include "scene/scene.hpp"

namespace tyn {

struct LightTable {
  std::vector<TynLightRecord> lights;
  std::vector<TynEmitterRecord> emitters;
  double environment_probability = 0;
};

// `environment_power`: see EnvironmentSampling. Sets `emission_density` of the materials.
LightTable light_table(const TynScene &scene, double environment_power, std::vector<TynMaterialRecord> &materials);

} // namespace tyn
