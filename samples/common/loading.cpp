// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "common/loading.hpp"

#include <tyndall/tyndall_io.h>

#include <cstdio>

namespace tool {
namespace {

bool is_preset(const std::string &name) {
  for (uint32_t i = 0; i < tyn_medium_preset_count(); ++i)
    if (name == tyn_medium_preset_name(i))
      return true;
  return false;
}

struct WarningSink {
  const LoadRequest *request;
  std::vector<std::string> *lines;
};

void on_warning(void *user, const char *message) {
  const WarningSink &sink = *static_cast<WarningSink *>(user);
  const std::string line = printable(message);
  sink.lines->push_back(line);
  if (sink.request->print_warnings)
    std::fprintf(stderr, "%s: warning: %s\n", sink.request->tool_name, line.c_str());
}

std::vector<TynMediumAssignment> assignments(const std::vector<MediumArgument> &media) {
  std::vector<TynMediumAssignment> result;
  for (const MediumArgument &argument : media)
    result.push_back({argument.material.empty() ? nullptr : argument.material.c_str(), argument.medium.c_str()});
  return result;
}

// What a failed load is to the user: a wrong --medium, a bad file, or bad luck.
ExitCode load_exit_code(TynStatus status) {
  switch (status) {
  case TYN_ERROR_INVALID_ARGUMENT:
    return kUsage;
  case TYN_ERROR_FILE:
  case TYN_ERROR_FORMAT:
    return kBadInput;
  default:
    return kFailed;
  }
}

} // namespace

std::vector<MediumArgument> parse_media(const std::vector<std::string> &arguments) {
  std::vector<MediumArgument> result;
  for (const std::string &argument : arguments) {
    // The last '=' separates: a preset's name has none, a material's may.
    const size_t split = argument.rfind('=');
    MediumArgument parsed;
    if (split != std::string::npos)
      parsed.material = argument.substr(0, split);
    parsed.medium = split == std::string::npos ? argument : argument.substr(split + 1);
    if (split == 0)
      throw Error(kUsage, "--medium " + argument + ": no material before the '='");
    if (!is_preset(parsed.medium))
      throw Error(kUsage, "--medium: no medium is named '" + parsed.medium + "'; there are " + preset_names());
    result.push_back(parsed);
  }
  return result;
}

LoadedScene load_scene(TynContext *context, const LoadRequest &request) {
  LoadedScene loaded;
  TynScene *scene = nullptr;
  check(tyn_scene_create(context, nullptr, &scene), context);
  loaded.scene.reset(scene);

  WarningSink sink = {&request, &loaded.warnings};
  const std::vector<TynMediumAssignment> media = assignments(request.media);
  TynGltfOptions options = tyn_gltf_options();
  options.assignments = media.empty() ? nullptr : media.data();
  options.assignment_count = media.size();
  options.skip_lights = request.skip_lights;
  options.warning = on_warning;
  options.user = &sink;
  const TynStatus status = tyn_gltf_load(scene, request.path.c_str(), &options);
  check(status, context, load_exit_code(status));
  return loaded;
}

TynSceneInfo scene_info(const TynScene *scene) {
  TynSceneInfo info = {};
  info.size = sizeof info;
  check(tyn_scene_info(scene, &info), tyn_scene_context(scene));
  return info;
}

TynMeshInfo mesh_info(const TynScene *scene, uint32_t mesh) {
  TynMeshInfo info = {};
  info.size = sizeof info;
  check(tyn_scene_mesh_info(scene, mesh, &info), tyn_scene_context(scene));
  return info;
}

std::string preset_names() {
  std::string names;
  for (uint32_t i = 0; i < tyn_medium_preset_count(); ++i)
    names += (i ? ", " : "") + std::string(tyn_medium_preset_name(i));
  return names;
}

} // namespace tool
