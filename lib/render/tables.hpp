// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// What the kernels read of the scene beyond its geometry. Made once per renderer.
#pragma once

#include "kernels/shared_render.h"
#include "render/textures.hpp"
#include "scene/scene.hpp"

namespace tyn {

struct SceneTables {
  ImageBuffers images;
  Buffer textures;  // TynTextureRecord
  Buffer materials; // TynMaterialRecord
  Buffer media;     // TynRenderMedium
  Buffer emitters;  // TynEmitterRecord
  Buffer lights;    // TynLightRecord
  Buffer texels;    // TynEnvironmentTexel
  uint32_t emitter_count = 0;
  float environment_probability = 0;
};

SceneTables make_tables(TynScene &scene, uint32_t strategy);

} // namespace tyn
