// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Sampling lights alone, following lobes alone, and both with multiple importance sampling must agree on every scene. This holds
// each density against the sampling that it claims to describe: of the rough interface at every bounce, of folded lobes, of
// walks' exits, of emissive triangles and of an environment image.
//
// Each image is cut into 4 x 4 tiles, whose means are compared in units of their joint standard error: 16 tiles x 3 channels x 2
// pairs; none may be beyond 4.5 (chance 6e-4 in all), the root mean square must be below 1.6 (about 1e-3, since a tile's
// channels go together).
#include <cmath>
#include <functional>
#include <string>

#include <gtest/gtest.h>

#include "common/render_scene.hpp"

namespace {

using namespace tyn_test;

constexpr uint32_t size = 32, tiles = 4, tile = size / tiles;

struct Tiles {
  double mean[tiles * tiles][3] = {}, variance[tiles * tiles][3] = {};
};

Tiles render_tiles(TynScene *scene, const TynRenderOptions &options, uint32_t strategy, uint32_t samples) {
  Render render(scene, options, strategy);
  render.run(samples);
  const std::vector<float> beauty = render.layer(TYN_LAYER_BEAUTY), variance = render.layer(TYN_LAYER_VARIANCE);
  Tiles result;
  for (uint32_t y = 0; y < size; y++)
    for (uint32_t x = 0; x < size; x++)
      for (uint32_t c = 0; c < 3; c++) {
        const uint32_t at = y / tile * tiles + x / tile, pixel = y * size + x;
        result.mean[at][c] += double(beauty[4 * pixel + c]) / (tile * tile);
        result.variance[at][c] += double(variance[3 * pixel + c]) / (tile * tile) / (tile * tile);
      }
  return result;
}

void expect_same(const Tiles &a, const Tiles &b, const std::string &what) {
  double squares = 0, count = 0;
  for (uint32_t i = 0; i < tiles * tiles; i++)
    for (uint32_t c = 0; c < 3; c++) {
      const double error = std::sqrt(a.variance[i][c] + b.variance[i][c]);
      if (error <= 1e-6 * a.mean[i][c])
        continue; // black, or nothing but the sky
      const double z = (a.mean[i][c] - b.mean[i][c]) / error;
      EXPECT_LT(std::abs(z), 4.5) << what << ", tile " << i << ", channel " << c << ": " << a.mean[i][c] << " and "
                                  << b.mean[i][c] << " +- " << error;
      squares += z * z;
      count++;
    }
  ASSERT_GT(count, 20) << what;
  EXPECT_LT(std::sqrt(squares / count), 1.6) << what;
}

// An image of a bright spot on a dim gradient, 32 x 16.
void set_sky(TynScene *scene) {
  const uint32_t w = 32, h = 16;
  std::vector<float> pixels(4 * w * h, 1.0f);
  for (uint32_t y = 0; y < h; y++)
    for (uint32_t x = 0; x < w; x++) {
      float *p = &pixels[4 * (y * w + x)];
      const bool sun = (x == 20 || x == 21) && y == 4;
      p[0] = sun ? 40.0f : 0.2f + 0.02f * float(x);
      p[1] = sun ? 30.0f : 0.3f;
      p[2] = sun ? 20.0f : 0.6f - 0.03f * float(y);
    }
  TynImage image = tyn_image();
  image.width = w;
  image.height = h;
  image.format = TYN_IMAGE_RGBA32F;
  image.pixels = pixels.data();
  TynEnvironment environment = constant_environment(1);
  environment.rotation = 0.4f;
  ASSERT_EQ(tyn_scene_add_image(scene, &image, &environment.image), TYN_OK);
  ASSERT_EQ(tyn_scene_set_environment(scene, &environment), TYN_OK);
}

uint32_t add_material(Scene &scene, const TynMaterial &material) {
  uint32_t index = TYN_NONE;
  EXPECT_EQ(tyn_scene_add_material(scene, &material, &index), TYN_OK) << scene.message();
  return index;
}

// A square lamp at height 2, half a unit wide, that shines down, or up and down.
void add_lamp(Scene &scene, bool both_sides) {
  TynMaterial material = matte(0.5f);
  material.emission[0] = 12;
  material.emission[1] = 9;
  material.emission[2] = 6;
  material.double_sided = both_sides;
  scene.add(translated(inverted(quad(0.6f)), -0.6f, 2, 0.3f), TYN_NONE, add_material(scene, material));
}

struct Case {
  std::string name;
  std::function<void(Scene &)> build;
};

void add_floor(Scene &scene, const TynMaterial &material) {
  scene.add(translated(quad(6), 0, -1, 0), TYN_NONE, add_material(scene, material));
}

// A lamp whose light varies over it, by a texture that light sampling does not know of.
void add_textured_lamp(Scene &scene) {
  const unsigned char pixels[16] = {255, 40, 10, 255, 0, 0, 0, 255, 30, 60, 90, 255, 200, 255, 255, 255};
  TynImage image = tyn_image();
  image.width = image.height = 2;
  image.pixels = pixels;
  TynMaterial material = matte(0);
  for (float &x : material.emission)
    x = 10;
  ASSERT_EQ(tyn_scene_add_image(scene, &image, &material.emission_texture.image), TYN_OK) << scene.message();
  scene.add(translated(inverted(quad(2)), 0.3f, 2, 0.3f), TYN_NONE, add_material(scene, material));
}

std::vector<Case> cases() {
  TynMaterial glossy = tyn_material();
  glossy.roughness = 0.5f;
  glossy.base_color[0] = 0.5f;
  TynMaterial metal = glossy;
  metal.metallic = 1;
  metal.roughness = 0.6f;
  metal.base_color[1] = 0.7f;
  TynMaterial wax = tyn_material();
  wax.ior = 1.4f;
  wax.roughness = 0.7f;
  wax.transmission = 0.8f;
  wax.multiscatter_color[0] = 0.8f;
  wax.multiscatter_color[1] = 0.5f;
  wax.multiscatter_color[2] = 0.4f;
  TynMaterial leaf = tyn_material();
  leaf.thin_walled = 1;
  leaf.transmission = 0.9f;
  leaf.thin_scatter = 0.8f;
  leaf.thin_scatter_anisotropy = 0.2f;
  leaf.roughness = 0.8f;
  MeshData round_cube = cube();
  for (const float p : round_cube.positions)
    round_cube.normals.push_back(p / std::sqrt(3.0f));

  const auto with = [](const MeshData &mesh, const TynMaterial &material, bool lamp, bool sky) {
    return [=](Scene &scene) {
      uint32_t medium = TYN_NONE;
      if (material.transmission > 0 && !material.thin_walled) {
        TynMedium inside = tyn_medium();
        inside.ior = material.ior;
        inside.sigma_s[0] = inside.sigma_s[1] = inside.sigma_s[2] = 5;
        EXPECT_EQ(tyn_scene_add_medium(scene, &inside, &medium), TYN_OK);
      }
      scene.add(mesh, medium, add_material(scene, material));
      add_floor(scene, matte(0.6f));
      if (lamp)
        add_lamp(scene, sky);
      if (sky)
        set_sky(scene);
    };
  };
  return {
      {"MatteUnderLamp", with(icosphere(2), matte(0.8f), true, false)},
      {"MatteUnderSky", with(icosphere(2), matte(0.8f), false, true)},
      {"GlossyUnderLampAndSky", with(icosphere(2), glossy, true, true)},
      {"MetalUnderLampAndSky", with(icosphere(2), metal, true, true)},
      {"RoundedCubeUnderSky", with(scaled(round_cube, 0.7f), glossy, false, true)},
      {"WaxUnderLampAndSky", with(icosphere(2), wax, true, true)},
      {"MatteUnderTexturedLamp",
       [with](Scene &scene) {
         with(icosphere(2), matte(0.7f), false, false)(scene);
         add_textured_lamp(scene);
       }},
      {"LeafUnderLampAndSky", with(icosphere(2), leaf, true, true)},
  };
}

class Strategies : public testing::TestWithParam<Case> {};

TEST_P(Strategies, AgreeOnTheImage) {
  Context context;
  Scene scene(context);
  GetParam().build(scene);
  scene.commit();
  TynRenderOptions options = film_options(size, size, look_at({0, 1, 4}, {0, 0.2, 0}, {0, 1, 0}, 0.9));
  options.seed = 5;
  options.max_bounces = 4;
  const uint32_t samples = 256;
  const Tiles both = render_tiles(scene, options, TYN_STRATEGY_MIS, samples);
  options.seed = 6;
  const Tiles lights = render_tiles(scene, options, TYN_STRATEGY_LIGHTS, samples);
  options.seed = 7;
  const Tiles lobes = render_tiles(scene, options, TYN_STRATEGY_LOBES, samples);
  expect_same(both, lights, "both and lights");
  expect_same(both, lobes, "both and lobes");
}

INSTANTIATE_TEST_SUITE_P(OfScenes, Strategies, testing::ValuesIn(cases()),
                         [](const auto &at) { return at.param.name; });

} // namespace
