// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "common/render_setup.hpp"

#include <tyndall/tyndall_io.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace tool {
namespace {

constexpr uint32_t kDefaultWidth = 640;
constexpr double kDefaultAspect = 4.0 / 3.0;
constexpr float kPi = 3.14159265f;

TynCamera scene_camera(const TynScene *scene, uint32_t index) {
  TynCamera camera = tyn_camera();
  check(tyn_scene_camera(scene, index, &camera), tyn_scene_context(scene));
  return camera;
}

std::string camera_name(const TynCamera &camera) { return camera.name ? camera.name : ""; }

// Index of the camera called `wanted`, by name first: a name may be a number.
uint32_t find_camera(const TynScene *scene, const std::string &wanted) {
  const uint32_t count = scene_info(scene).camera_count;
  std::string names;
  for (uint32_t i = 0; i < count; ++i) {
    const std::string name = camera_name(scene_camera(scene, i));
    if (name == wanted)
      return i;
    names += (i ? ", " : "") + std::to_string(i) + (name.empty() ? "" : " '" + name + "'");
  }
  uint32_t index = 0;
  const char *end = wanted.data() + wanted.size();
  const std::from_chars_result parsed = std::from_chars(wanted.data(), end, index);
  if (parsed.ec == std::errc() && parsed.ptr == end && index < count)
    return index;
  throw Error(kUsage,
              "--camera " + wanted + ": the file has " + (count ? "cameras " + names : std::string("no camera")));
}

uint32_t scaled(uint32_t size, double factor) {
  return static_cast<uint32_t>(std::clamp(std::round(size * factor), 1.0, 32768.0));
}

void choose_size(const RenderArguments &arguments, double aspect, View &view) {
  view.width = arguments.width;
  view.height = arguments.height;
  if (!view.width && !view.height)
    view.width = kDefaultWidth;
  if (!view.width)
    view.width = scaled(view.height, aspect);
  if (!view.height)
    view.height = scaled(view.width, 1.0 / aspect);
}

void set_environment(TynScene *scene, const RenderArguments &arguments) {
  TynContext *context = tyn_scene_context(scene);
  TynEnvironment environment = tyn_environment();
  std::copy_n(arguments.environment.radiance, 3, environment.radiance);
  environment.rotation = static_cast<float>(arguments.environment_rotation) * (kPi / 180.0f);
  if (!arguments.environment.file.empty()) {
    const TynStatus status = tyn_exr_load(scene, arguments.environment.file.c_str(), &environment.image);
    const bool bad_file = status == TYN_ERROR_FILE || status == TYN_ERROR_FORMAT;
    check(status, context, bad_file ? kBadInput : kFailed);
  }
  check(tyn_scene_set_environment(scene, &environment), context);
}

// A key light from over the viewer's left shoulder, softened by an even, dim and slightly cool surrounding.
void add_default_light(TynScene *scene, const TynCamera &camera) {
  TynContext *context = tyn_scene_context(scene);
  TynLight key = tyn_light();
  key.name = "default key light";
  key.type = TYN_LIGHT_DIRECTIONAL;
  const float towards[3] = {0.5f, -0.6f, -0.6244998f}; // unit, in the camera's frame
  const float *m = camera.world_from_camera;
  for (int row = 0; row < 3; ++row)
    key.direction[row] = m[4 * row] * towards[0] + m[4 * row + 1] * towards[1] + m[4 * row + 2] * towards[2];
  key.intensity[0] = 2.2f;
  key.intensity[1] = 2.1f;
  key.intensity[2] = 2.0f;
  check(tyn_scene_add_light(scene, &key, nullptr), context);

  TynEnvironment fill = tyn_environment();
  fill.radiance[0] = 0.22f;
  fill.radiance[1] = 0.24f;
  fill.radiance[2] = 0.27f;
  check(tyn_scene_set_environment(scene, &fill), context);
}

} // namespace

View choose_view(const TynScene *scene, const RenderArguments &arguments) {
  View view = {tyn_camera(), "", 0, 0};
  const bool has_camera = scene_info(scene).camera_count > 0;
  if (has_camera || !arguments.camera.empty()) {
    view.camera = scene_camera(scene, arguments.camera.empty() ? 0 : find_camera(scene, arguments.camera));
    view.name = camera_name(view.camera);
    const double aspect = view.camera.aspect_ratio;
    choose_size(arguments, aspect > 0.0 ? aspect : kDefaultAspect, view);
    return view;
  }
  choose_size(arguments, kDefaultAspect, view);
  const float aspect = static_cast<float>(view.width) / static_cast<float>(view.height);
  check(tyn_scene_frame(scene, aspect, &view.camera), tyn_scene_context(scene));
  return view;
}

Lighting set_lighting(TynScene *scene, const RenderArguments &arguments, const TynCamera &camera) {
  if (arguments.environment.given)
    set_environment(scene, arguments);
  const TynSceneInfo info = scene_info(scene);
  if (info.light_count || info.emissive_triangle_count || info.has_environment)
    return Lighting::kScene;
  if (arguments.no_lights || arguments.environment.given)
    return Lighting::kNone;
  add_default_light(scene, camera);
  return Lighting::kDefault;
}

} // namespace tool
