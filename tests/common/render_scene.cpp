// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "common/render_scene.hpp"

#include <cmath>

namespace tyn_test {

namespace {

void normalize(double (&v)[3]) {
  const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  for (double &x : v)
    x /= length;
}

void cross(const double (&a)[3], const double (&b)[3], double (&out)[3]) {
  for (int i = 0; i < 3; i++)
    out[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

} // namespace

TynCamera look_at(const double (&from)[3], const double (&to)[3], const double (&up)[3], double yfov) {
  double back[3] = {from[0] - to[0], from[1] - to[1], from[2] - to[2]};
  double right[3], above[3];
  normalize(back);
  cross(up, back, right);
  normalize(right);
  cross(back, right, above);
  TynCamera camera = tyn_camera();
  camera.yfov = static_cast<float>(yfov);
  for (int row = 0; row < 3; row++) {
    camera.world_from_camera[4 * row] = static_cast<float>(right[row]);
    camera.world_from_camera[4 * row + 1] = static_cast<float>(above[row]);
    camera.world_from_camera[4 * row + 2] = static_cast<float>(back[row]);
    camera.world_from_camera[4 * row + 3] = static_cast<float>(from[row]);
  }
  return camera;
}

TynCamera look_at_flat(const double (&from)[3], const double (&to)[3], const double (&up)[3], double ymag) {
  TynCamera camera = look_at(from, to, up, 1);
  camera.type = TYN_CAMERA_ORTHOGRAPHIC;
  camera.ymag = static_cast<float>(ymag);
  return camera;
}

TynEnvironment constant_environment(float radiance) {
  TynEnvironment environment = tyn_environment();
  for (float &x : environment.radiance)
    x = radiance;
  return environment;
}

TynMaterial matte(float color) {
  TynMaterial material = tyn_material();
  material.ior = 1;
  for (float &x : material.base_color)
    x = color;
  return material;
}

TynRenderOptions film_options(uint32_t width, uint32_t height, const TynCamera &camera) {
  TynRenderOptions options = tyn_render_options();
  options.width = width;
  options.height = height;
  options.camera = camera;
  return options;
}

Render::Render(TynScene *scene, const TynRenderOptions &options, uint32_t strategy)
    : handle(new TynRenderer(*scene, options, strategy)) {}

void Render::run(uint32_t samples) {
  TynRenderBudget budget = tyn_render_budget();
  budget.samples = samples;
  ASSERT_EQ(tyn_renderer_run(handle, &budget), TYN_OK) << message();
}

std::vector<float> Render::layer(uint32_t layer) const {
  std::vector<float> pixels(size_t(handle->options.width) * handle->options.height * tyn_layer_channels(layer));
  EXPECT_EQ(tyn_renderer_read(handle, layer, pixels.data(), pixels.size()), TYN_OK) << message();
  return pixels;
}

TynRenderStats Render::stats() const {
  TynRenderStats stats{};
  stats.size = sizeof stats;
  EXPECT_EQ(tyn_renderer_stats(handle, &stats), TYN_OK) << message();
  return stats;
}

Estimate Render::mean(uint32_t channel) const {
  const std::vector<float> beauty = layer(TYN_LAYER_BEAUTY), variance = layer(TYN_LAYER_VARIANCE);
  const size_t pixels = beauty.size() / 4;
  double sum = 0, spread = 0;
  for (size_t i = 0; i < pixels; i++) {
    sum += double(beauty[4 * i + channel]);
    spread += double(variance[3 * i + channel]);
  }
  return {sum / double(pixels), std::sqrt(spread) / double(pixels)};
}

std::string Render::message() const { return tyn_context_message(tyn_scene_context(tyn_renderer_scene(handle))); }

} // namespace tyn_test
