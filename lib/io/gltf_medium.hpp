// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Media: KHR_materials_volume with either scatter draft, and the presets a caller assigns.
#pragma once

#include <string>

#include <tiny_gltf.h>

#include "io/failure.hpp"

namespace tyn::io {

// What KHR_materials_scatter, or its predecessor KHR_materials_volume_scatter, says about a material.
struct GltfScatter {
  const tinygltf::Value *object = nullptr; // the extension, for its textures; NULL: there is none
  std::string where;                       // its JSON path
  float strength = 1;
  float color[3] = {1, 1, 1}; // multiple-scattering colour
  float g = 0;
};

// Finds the scattering of a material, in all spellings: KHR_materials_scatter is preferred to KHR_materials_volume_scatter,
// multiscatterColorFactor to multiscatterColor and scatterAlbedo.
GltfScatter find_scatter(const tinygltf::Material &material, const std::string &where, Warnings &warnings);

// The medium that KHR_materials_volume describes: sigma_t = -ln(attenuationColor) / attenuationDistance, of which the part
// W = tyn_albedo_from_color(strength x color, g) scatters. Distances are in world space: nodes do not scale them.
TynMedium make_medium(const tinygltf::Value &volume, const GltfScatter &scatter, float ior, const std::string &where,
                      Warnings &warnings);

// The preset that the last matching assignment names for a material; NULL if none matches. `metal`: the material is metallic
// everywhere, so that "ALL" does not mean it.
const char *assigned_preset(const TynGltfOptions &options, const std::string &material, bool metal);

// Throws INVALID_ARGUMENT for a preset that does not exist and for a material that the file does not have.
void check_assignments(const TynGltfOptions &options, const tinygltf::Model &model);

// A preset in metres. Throws INVALID_ARGUMENT.
TynMedium preset_medium(const char *name);

// A number from a file that must lie in [low, high]: moved to the nearer limit with a warning if it does not.
float limited(double value, double low, double high, const std::string &where, Warnings &warnings);

} // namespace tyn::io
