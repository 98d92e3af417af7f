// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The renderer's kernels under oclgrind: its reports fail the test (see tests/CMakeLists.txt). A film of 4 x 4 pixels of a
// scene with one of everything. Uninitialized reads are left out here: oclgrind 21.10 does not see that clEnqueueFillBuffer
// and writes to a part of a buffer initialize it.
#include <cmath>
#include <cstdlib>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "common/walk_scene.hpp"

namespace {

using namespace tyn_test;

struct ReleaseRenderer {
  void operator()(TynRenderer *renderer) const { tyn_renderer_release(renderer); }
};

// Checks every call; keeps the indices that calls hand out.
class SceneBuilder {
public:
  explicit SceneBuilder(TynContext *owner) : context(owner) {
    TynScene *created = nullptr;
    check(tyn_scene_create(context, nullptr, &created));
    scene.reset(created);
  }

  uint32_t add_image(uint32_t format, uint32_t width, uint32_t height, const void *pixels) {
    TynImage image = tyn_image();
    image.format = format;
    image.width = width;
    image.height = height;
    image.pixels = pixels;
    return index_of([&](uint32_t *index) { return tyn_scene_add_image(scene.get(), &image, index); });
  }
  uint32_t add_medium(const TynMedium &medium) {
    return index_of([&](uint32_t *index) { return tyn_scene_add_medium(scene.get(), &medium, index); });
  }
  uint32_t add_material(const TynMaterial &material) {
    return index_of([&](uint32_t *index) { return tyn_scene_add_material(scene.get(), &material, index); });
  }
  void add_mesh(const MeshData &mesh, uint32_t material, uint32_t medium = TYN_NONE) {
    TynMesh view = mesh.view();
    view.material = material;
    view.medium = medium;
    check(tyn_scene_add_mesh(scene.get(), &view, nullptr));
  }
  void add_light(uint32_t type) {
    TynLight light = tyn_light();
    light.type = type;
    light.position[1] = 3;
    light.direction[1] = -1;
    light.direction[2] = 0;
    check(tyn_scene_add_light(scene.get(), &light, nullptr));
  }
  void set_environment(const float (&radiance)[3], uint32_t image) {
    TynEnvironment environment = tyn_environment();
    std::copy(radiance, radiance + 3, environment.radiance);
    environment.image = image;
    environment.rotation = 0.5f;
    check(tyn_scene_set_environment(scene.get(), &environment));
  }
  void check(TynStatus status) { ASSERT_EQ(status, TYN_OK) << tyn_context_message(context); }

  TynContext *context;
  SceneHandle scene;

private:
  template <class Add>
  uint32_t index_of(Add add) {
    uint32_t index = TYN_NONE;
    check(add(&index));
    return index;
  }
};

void add_textured_floor(SceneBuilder &builder) {
  const unsigned char colours[16] = {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 255};
  const unsigned char bumps[16] = {128, 128, 255, 255, 140, 120, 250, 255, 120, 140, 250, 255, 128, 128, 255, 255};
  TynMaterial floor = tyn_material();
  floor.base_color_texture.image = builder.add_image(TYN_IMAGE_RGBA8_SRGB, 2, 2, colours);
  floor.base_color_texture.wrap_u = TYN_WRAP_MIRROR;
  floor.normal_texture.image = builder.add_image(TYN_IMAGE_RGBA8_LINEAR, 2, 2, bumps);
  floor.normal_texture.filter = TYN_FILTER_NEAREST;
  floor.metallic_roughness_texture = floor.normal_texture;
  floor.double_sided = 1;
  builder.add_mesh(translated(quad(6), 0, -1, 0), builder.add_material(floor));
}

void add_subsurface_sphere(SceneBuilder &builder, float roughness) {
  TynMaterial skin = tyn_material();
  skin.ior = 1.4f;
  skin.roughness = roughness;
  skin.transmission = 1;
  skin.multiscatter_color[0] = 0.8f;
  skin.multiscatter_color[1] = skin.multiscatter_color[2] = 0.3f;
  uint32_t medium = builder.add_medium(rgb_medium({0.2f, 0.5f, 1}, {2, 2, 2}, 0, 1.4f));
  builder.add_mesh(icosphere(1), builder.add_material(skin), medium);
}

void add_metal(SceneBuilder &builder) {
  TynMaterial metal = tyn_material();
  metal.metallic = 1;
  metal.roughness = 0.5f;
  builder.add_mesh(translated(cube(), 2.2f, 0, 0), builder.add_material(metal));
}

void add_thin_leaf_and_lamp(SceneBuilder &builder) {
  TynMaterial leaf = tyn_material();
  leaf.thin_walled = 1;
  leaf.transmission = 0.8f;
  leaf.thin_scatter = 0.5f;
  builder.add_mesh(translated(quad(2), -2, 0.5f, 0), builder.add_material(leaf));
  TynMaterial lamp = tyn_material();
  lamp.emission[0] = lamp.emission[1] = lamp.emission[2] = 4;
  lamp.double_sided = 1;
  builder.add_mesh(translated(single_triangle(), 0, 3, 0), builder.add_material(lamp));
}

void render(SceneBuilder &builder, uint32_t exit, uint32_t bssrdf = TYN_NONE) {
  builder.check(tyn_scene_commit(builder.scene.get()));
  TynRenderOptions options = tyn_render_options();
  options.width = options.height = 4;
  options.exit = exit;
  options.bssrdf = bssrdf;
  options.max_bounces = 8;
  builder.check(tyn_scene_frame(builder.scene.get(), 1, &options.camera));
  TynRenderer *created = nullptr;
  builder.check(tyn_renderer_create(builder.scene.get(), &options, &created));
  std::unique_ptr<TynRenderer, ReleaseRenderer> renderer(created);
  TynRenderBudget budget = tyn_render_budget();
  budget.samples = 2;
  builder.check(tyn_renderer_run(renderer.get(), &budget));
  for (uint32_t layer = 0; layer < TYN_LAYER_COUNT; ++layer) {
    std::vector<float> pixels(16 * tyn_layer_channels(layer));
    builder.check(tyn_renderer_read(renderer.get(), layer, pixels.data(), pixels.size()));
    for (float pixel : pixels)
      EXPECT_FALSE(std::isnan(pixel)) << tyn_layer_name(layer);
  }
  TynRenderStats stats{};
  stats.size = sizeof stats;
  builder.check(tyn_renderer_stats(renderer.get(), &stats));
  EXPECT_EQ(stats.samples, 2u);
  EXPECT_EQ(stats.nonfinite_paths, 0u);
}

class CheckedRender : public testing::TestWithParam<uint32_t> {
protected:
  void SetUp() override { setenv("OCLGRIND_UNINITIALIZED", "0", 1); } // read when a context is created
  void TearDown() override { setenv("OCLGRIND_UNINITIALIZED", "1", 1); }
};

TEST_P(CheckedRender, OfOneOfEverything) {
  ContextHandle context = make_context(GetParam());
  SceneBuilder builder(context.get());
  add_textured_floor(builder);
  add_subsurface_sphere(builder, 0.6f);
  add_metal(builder);
  add_thin_leaf_and_lamp(builder);
  for (uint32_t type : {TYN_LIGHT_POINT, TYN_LIGHT_SPOT, TYN_LIGHT_DIRECTIONAL})
    builder.add_light(type);
  std::vector<float> sky(4 * 2 * 4, 0.5f);
  builder.set_environment({1, 1, 1}, builder.add_image(TYN_IMAGE_RGBA32F, 4, 2, sky.data()));
  render(builder, TYN_EXIT_DIFFUSE);
}

TEST_P(CheckedRender, OfASmoothBodyUnderAConstantSky) {
  ContextHandle context = make_context(GetParam());
  SceneBuilder builder(context.get());
  add_subsurface_sphere(builder, 0);
  builder.set_environment({1, 0.5f, 0.25f}, TYN_NONE);
  render(builder, TYN_EXIT_DIELECTRIC);
}

// A range of albedos is prepared; and one model after the other, tabulated and not.
TEST_P(CheckedRender, WithBssrdfModels) {
  for (const uint32_t model : {TYN_BSSRDF_NORMALIZED_DIFFUSION, TYN_BSSRDF_QUANTIZED_DIFFUSION}) {
    ContextHandle context = make_context(GetParam());
    SceneBuilder builder(context.get());
    add_subsurface_sphere(builder, 0);
    builder.set_environment({1, 0.5f, 0.25f}, TYN_NONE);
    render(builder, TYN_EXIT_DIFFUSE, model);
  }
}

TEST_P(CheckedRender, OfASceneWithoutLight) {
  ContextHandle context = make_context(GetParam());
  SceneBuilder builder(context.get());
  add_metal(builder);
  render(builder, TYN_EXIT_DIFFUSE);
}

INSTANTIATE_TEST_SUITE_P(WithLanes, CheckedRender, testing::Values(1u, 4u), testing::PrintToStringParamName());

} // namespace
