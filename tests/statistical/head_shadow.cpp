// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The scanned head, where it is at hand: a shadow edge across the forehead bleeds red, and the picture is sound.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "common/render_scene.hpp"

#ifdef TYN_TEST_IO
#include "tyndall/tyndall_io.h"

namespace tyn_test {
namespace {

constexpr uint32_t SIZE = 96;
constexpr double HALF_VIEW = 0.02; // metres: the film shows 4 cm of skin

std::string head_path() {
  const char *folder = std::getenv("TYNDALL_TEST_DATA");
  std::string path = std::string(folder ? folder : "") + "/head.glb";
  FILE *file = folder ? std::fopen(path.c_str(), "rb") : nullptr;
  if (file)
    std::fclose(file);
  return file ? path : "";
}

void load_head(Scene &scene, bool own_lights) {
  TynGltfOptions options = tyn_gltf_options();
  options.skip_lights = own_lights ? 0 : 1;
  ASSERT_EQ(tyn_gltf_load(scene, head_path().c_str(), &options), TYN_OK) << scene.message();
}

// Half a plane across light that travels along -x-z: its edge runs along y, and the edge's shadow meets the skin at `at`.
MeshData blocker(const double (&at)[3]) {
  MeshData mesh;
  const double s = std::sqrt(0.5), distance = 0.4, width = 0.3, height = 0.3;
  for (double along : {0.0, width})
    for (double up : {-height, height})
      mesh.add_vertex(at[0] + s * distance - s * along, at[1] + up, at[2] + s * distance + s * along);
  mesh.add_triangle(0, 1, 2);
  mesh.add_triangle(2, 1, 3);
  return mesh;
}

// The subsurface layer of the forehead under a directional light from the side, with or without the blocker.
std::vector<float> forehead(bool blocked) {
  Context context;
  Scene scene(context);
  load_head(scene, false);
  TynLight light = tyn_light();
  light.type = TYN_LIGHT_DIRECTIONAL;
  light.direction[0] = light.direction[2] = -float(std::sqrt(0.5));
  EXPECT_EQ(tyn_scene_add_light(scene, &light, nullptr), TYN_OK);
  const double at[3] = {0.0, 0.11, 0.1};
  if (blocked)
    scene.add(blocker(at));
  scene.commit();
  const double from[3] = {0.0, 0.11, 0.3}, to[3] = {0.0, 0.11, 0.0}, up[3] = {0, 1, 0};
  Render render(scene, film_options(SIZE, SIZE, look_at_flat(from, to, up, HALF_VIEW)));
  render.run(128);
  return render.layer(TYN_LAYER_SUBSURFACE);
}

// Share of light that the shadow leaves in each column of the film, averaged over its rows; the skin's colour cancels.
std::vector<double> shadow_profile(const std::vector<float> &blocked, const std::vector<float> &open, int channel) {
  std::vector<double> profile(SIZE);
  for (uint32_t x = 0; x < SIZE; x++) {
    double with = 0, without = 0;
    for (uint32_t y = 0; y < SIZE; y++) {
      with += blocked[3 * (y * SIZE + x) + size_t(channel)];
      without += open[3 * (y * SIZE + x) + size_t(channel)];
    }
    profile[x] = with / without;
  }
  return profile;
}

// Columns over which the profile climbs from 5 % to 95 %. At 128 samples a column's share has a standard error below 0.5 %.
uint32_t edge_width(const std::vector<double> &profile) {
  return uint32_t(std::count_if(profile.begin(), profile.end(), [](double v) { return v > 0.05 && v < 0.95; }));
}

TEST(Head, AShadowEdgeIsBlurrierInRedThanInBlue) {
  if (head_path().empty())
    GTEST_SKIP() << "TYNDALL_TEST_DATA names no folder with head.glb";
  const std::vector<float> blocked = forehead(true), open = forehead(false);
  const std::vector<double> red = shadow_profile(blocked, open, 0), blue = shadow_profile(blocked, open, 2);
  EXPECT_GT(*std::max_element(red.begin(), red.end()), 0.95);
  EXPECT_LT(*std::min_element(red.begin(), red.end()), 0.1);
  EXPECT_GT(4 * edge_width(red), 5 * edge_width(blue)) << "red " << edge_width(red) << ", blue " << edge_width(blue);
}

TEST(Head, ItsPictureHasNoNanAndNoFireflyAboveFiftyTimesTheMedian) {
  if (head_path().empty())
    GTEST_SKIP() << "TYNDALL_TEST_DATA names no folder with head.glb";
  Context context;
  Scene scene(context);
  load_head(scene, true);
  scene.commit();
  TynCamera camera{};
  camera.size = sizeof camera;
  ASSERT_EQ(tyn_scene_camera(scene, 0, &camera), TYN_OK);
  Render render(scene, film_options(128, 128, camera));
  render.run(64);
  EXPECT_EQ(render.stats().nonfinite_paths, 0u);
  for (uint32_t layer = 0; layer < TYN_LAYER_COUNT; layer++)
    for (float value : render.layer(layer))
      ASSERT_TRUE(std::isfinite(value) || (layer == TYN_LAYER_DEPTH && value > 0)) << tyn_layer_name(layer);
  const std::vector<float> light = render.layer(TYN_LAYER_SUBSURFACE);
  std::vector<float> lit;
  for (size_t i = 0; i < light.size(); i += 3) {
    const float sum = light[i] + light[i + 1] + light[i + 2];
    if (sum > 0)
      lit.push_back(sum);
  }
  ASSERT_GT(lit.size(), 1000u);
  std::nth_element(lit.begin(), lit.begin() + long(lit.size() / 2), lit.end());
  const float median = lit[lit.size() / 2];
  EXPECT_LT(*std::max_element(lit.begin(), lit.end()), 50 * median);
}

} // namespace
} // namespace tyn_test
#endif
