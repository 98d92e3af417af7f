// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Light that passes a medium unscattered: an empty, index-matched ball is invisible, and frosted glass still sees lights
// without size.
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "common/render_scene.hpp"

namespace {

using namespace tyn_test;

constexpr uint32_t SIZE = 32;

// An environment that is black on the left and white on the right of a camera that looks along -z.
uint32_t add_two_halves(Scene &scene) {
  std::vector<float> pixels(64 * 32 * 4);
  for (size_t i = 0; i < 64 * 32; i++)
    for (size_t c = 0; c < 4; c++)
      pixels[4 * i + c] = i % 64 < 32 ? 0.0f : 1.0f;
  TynImage image = tyn_image();
  image.width = 64;
  image.height = 32;
  image.format = TYN_IMAGE_RGBA32F;
  image.pixels = pixels.data();
  uint32_t index = TYN_NONE;
  EXPECT_EQ(tyn_scene_add_image(scene, &image, &index), TYN_OK) << scene.message();
  return index;
}

// A ball of an empty medium at the origin, or far behind the camera.
void add_clear_ball(Scene &scene, float ior, float roughness, bool in_view) {
  TynMedium medium = tyn_medium();
  medium.ior = ior;
  TynMaterial material = tyn_material();
  material.ior = ior;
  material.roughness = roughness;
  material.transmission = 1.0f;
  uint32_t medium_index = TYN_NONE, material_index = TYN_NONE;
  ASSERT_EQ(tyn_scene_add_medium(scene, &medium, &medium_index), TYN_OK) << scene.message();
  ASSERT_EQ(tyn_scene_add_material(scene, &material, &material_index), TYN_OK) << scene.message();
  MeshData ball = icosphere(3);
  if (!in_view)
    for (size_t i = 2; i < ball.positions.size(); i += 3)
      ball.positions[i] += 100.0f;
  scene.add(ball, medium_index, material_index);
}

std::vector<float> two_halves_through(uint32_t exit, bool in_view) {
  Context context;
  Scene scene(context);
  TynEnvironment environment = constant_environment(1.0f);
  environment.image = add_two_halves(scene);
  EXPECT_EQ(tyn_scene_set_environment(scene, &environment), TYN_OK) << scene.message();
  add_clear_ball(scene, 1.0f, 0.0f, in_view);
  scene.commit();
  TynRenderOptions options = film_options(SIZE, SIZE, look_at({0, 0, 4}, {0, 0, 0}, {0, 1, 0}, 0.6));
  options.exit = exit;
  Render render(scene, options);
  render.run(4);
  return render.layer(TYN_LAYER_BEAUTY);
}

TEST(ClearMedium, AnEmptyIndexMatchedBallIsInvisibleWithBothExits) {
  for (const uint32_t exit : {TYN_EXIT_DIFFUSE, TYN_EXIT_DIELECTRIC}) {
    const std::vector<float> with = two_halves_through(exit, true), without = two_halves_through(exit, false);
    for (size_t i = 0; i < with.size(); i += 4)
      EXPECT_NEAR(with[i], without[i], 1e-4f) << "pixel " << i / 4 << ", exit " << exit;
    EXPECT_LT(without[4 * (SIZE * SIZE / 2 + 2)], 0.01f);
    EXPECT_GT(without[4 * (SIZE * SIZE / 2 + SIZE - 2)], 0.99f);
  }
}

TEST(ClearMedium, FrostedGlassIsLitByAPointLightBehindIt) {
  Context context;
  Scene scene(context);
  add_clear_ball(scene, 1.5f, 0.7f, true);
  TynLight light = tyn_light();
  light.position[2] = -3.0f;
  ASSERT_EQ(tyn_scene_add_light(scene, &light, nullptr), TYN_OK) << scene.message();
  scene.commit();
  Render render(scene, film_options(SIZE, SIZE, look_at({0, 0, 4}, {0, 0, 0}, {0, 1, 0}, 0.6)));
  render.run(64);
  const std::vector<float> light_through = render.layer(TYN_LAYER_SUBSURFACE);
  EXPECT_GT(*std::max_element(light_through.begin(), light_through.end()), 0.0f);
}

} // namespace
