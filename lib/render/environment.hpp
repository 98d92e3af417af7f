// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// How the environment is sampled.
#pragma once

#include <vector>

#include "kernels/shared_render.h"
#include "scene/scene.hpp"

namespace tyn {

struct EnvironmentSampling {
  std::vector<TynEnvironmentTexel> texels; // one for each pixel of the image; empty: constant, or never sampled
  double power = 0;                        // integral over directions of what is sampled; 0: sampled never
};

// Table for an environment that has been checked. With TYN_STRATEGY_MIS only the light above the mean is sampled, because
// sampling surfaces finds the even part better: p ~ max(0, L - mean) (Karlik, Sik, Vevoda, et al. 2019, "MIS compensation"). A
// constant environment is then not sampled at all. With TYN_STRATEGY_LIGHTS p ~ L.
EnvironmentSampling sample_environment(const TynScene &scene, uint32_t strategy);

} // namespace tyn
