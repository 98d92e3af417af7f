// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
//
// From a file and --medium arguments to a scene that is not yet committed.
#pragma once

#include "common/tool.hpp"

#include <string>
#include <vector>

namespace tool {

// --medium NAME or MATERIAL=NAME.
struct MediumArgument {
  std::string material; // empty: every material that is not metallic
  std::string medium;
};

// Throws a usage error for a name that is no preset.
std::vector<MediumArgument> parse_media(const std::vector<std::string> &arguments);

struct LoadRequest {
  std::string path;
  std::vector<MediumArgument> media;
  bool skip_lights = false;
  bool print_warnings = true;
  const char *tool_name = "";
};

struct LoadedScene {
  Scene scene;
  std::vector<std::string> warnings;
};

// Reads a glTF file. Each warning is also a line on standard error unless asked otherwise.
LoadedScene load_scene(TynContext *context, const LoadRequest &request);

TynSceneInfo scene_info(const TynScene *scene);
TynMeshInfo mesh_info(const TynScene *scene, uint32_t mesh);

// The names of the presets, separated by commas.
std::string preset_names();

} // namespace tool
