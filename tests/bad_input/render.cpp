// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// What the renderer's calls refuse, and how.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "common/render_scene.hpp"

namespace {

using namespace tyn_test;

class BadRender : public testing::Test {
protected:
  Context context;
  Scene scene{context};
  TynRenderer *renderer = nullptr;

  void SetUp() override {
    scene.add(icosphere(1));
    scene.commit();
  }
  void TearDown() override { tyn_renderer_release(renderer); }

  void expect_refused(const TynRenderOptions &options, const std::string &named) {
    EXPECT_EQ(tyn_renderer_create(scene, &options, &renderer), TYN_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(renderer, nullptr);
    EXPECT_NE(scene.message().find(named), std::string::npos) << scene.message();
  }
  void create() {
    const TynRenderOptions options = film_options(4, 3, tyn_camera());
    ASSERT_EQ(tyn_renderer_create(scene, &options, &renderer), TYN_OK) << scene.message();
  }
};

TEST_F(BadRender, NullHandlesAreInvalidArguments) {
  float pixel = 0;
  TynRenderStats stats{};
  TynRenderBudget budget = tyn_render_budget();
  EXPECT_EQ(tyn_renderer_create(nullptr, nullptr, &renderer), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_renderer_create(scene, nullptr, nullptr), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_renderer_run(nullptr, &budget), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_renderer_read(nullptr, 0, &pixel, 1), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_renderer_stats(nullptr, &stats), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_renderer_scene(nullptr), nullptr);
  tyn_renderer_retain(nullptr);
  tyn_renderer_release(nullptr);
}

TEST_F(BadRender, AFilmWithoutPixelsOrTooWideIsRefused) {
  TynRenderOptions options = film_options(0, 4, tyn_camera());
  expect_refused(options, "width");
  options = film_options(4, 32769, tyn_camera());
  expect_refused(options, "height");
}

TEST_F(BadRender, AStructWithoutItsSizeIsRefused) {
  TynRenderOptions options = tyn_render_options();
  options.size = 0;
  expect_refused(options, "TynRenderOptions::size");
  options = tyn_render_options();
  options.camera.size = 0;
  expect_refused(options, "TynCamera::size");
}

TEST_F(BadRender, ACameraThatSeesNothingIsRefused) {
  TynCamera camera = tyn_camera();
  camera.yfov = 0;
  expect_refused(film_options(4, 4, camera), "yfov");
  camera = tyn_camera();
  camera.world_from_camera[3] = std::nanf("");
  expect_refused(film_options(4, 4, camera), "world_from_camera");
}

TEST_F(BadRender, UnknownChoicesAreRefused) {
  TynRenderOptions options = film_options(4, 4, tyn_camera());
  options.exit = 2;
  expect_refused(options, "exit");
  options = film_options(4, 4, tyn_camera());
  options.max_bounces = 0;
  expect_refused(options, "max_bounces");
}

TEST_F(BadRender, BssrdfModelsThatItCannotUseAreRefused) {
  TynRenderOptions options = film_options(4, 4, tyn_camera());
  options.bssrdf = TYN_BSSRDF_MODEL_COUNT;
  expect_refused(options, "bssrdf is " + std::to_string(TYN_BSSRDF_MODEL_COUNT));
  expect_refused(options, "standard-dipole, better-dipole");
  options.bssrdf = TYN_BSSRDF_GAUSSIANS;
  expect_refused(options, "gaussians");
  options.bssrdf = TYN_BSSRDF_STANDARD_DIPOLE;
  options.exit = TYN_EXIT_DIELECTRIC;
  expect_refused(options, "exit is 1 (dielectric)");
}

// Media that no mesh holds do not matter.
TEST_F(BadRender, ABssrdfOfAMediumWithoutExtinctionIsRefused) {
  TynMedium clear = tyn_medium(), red = tyn_medium();
  clear.name = "air";
  red.name = "red glass";
  red.sigma_a[1] = red.sigma_a[2] = red.sigma_s[1] = 1;
  TynRenderOptions options = film_options(4, 4, tyn_camera());
  options.bssrdf = TYN_BSSRDF_STANDARD_DIPOLE;
  for (const bool held : {false, true}) {
    Scene with_media(context);
    uint32_t medium = TYN_NONE;
    ASSERT_EQ(tyn_scene_add_medium(with_media, &clear, nullptr), TYN_OK);
    ASSERT_EQ(tyn_scene_add_medium(with_media, &red, &medium), TYN_OK);
    with_media.add(icosphere(1), held ? medium : TYN_NONE);
    with_media.commit();
    EXPECT_EQ(tyn_renderer_create(with_media, &options, &renderer), held ? TYN_ERROR_INVALID_ARGUMENT : TYN_OK);
    if (held) {
      EXPECT_NE(with_media.message().find("medium 1 (\"red glass\") has no extinction in channel 0"), std::string::npos)
          << with_media.message();
    }
    tyn_renderer_release(renderer);
    renderer = nullptr;
  }
}

TEST_F(BadRender, ASceneMustBeCommittedFirst) {
  Scene open(context);
  open.add(icosphere(1));
  EXPECT_EQ(tyn_renderer_create(open, nullptr, &renderer), TYN_ERROR_INVALID_OPERATION);
  EXPECT_EQ(renderer, nullptr);
}

TEST_F(BadRender, AFilmThatDoesNotFitIsOutOfMemory) {
  TynContextOptions options = tyn_context_options();
  options.memory_limit = 1 << 20;
  Context small(options);
  Scene inside(small);
  inside.add(icosphere(1));
  inside.commit();
  const TynRenderOptions large = film_options(1000, 1000, tyn_camera());
  EXPECT_EQ(tyn_renderer_create(inside, &large, &renderer), TYN_ERROR_OUT_OF_MEMORY);
  EXPECT_EQ(renderer, nullptr);
}

TEST_F(BadRender, ABudgetWithoutAnyLimitIsRefused) {
  create();
  TynRenderBudget budget = tyn_render_budget();
  budget.samples = 0;
  EXPECT_EQ(tyn_renderer_run(renderer, &budget), TYN_ERROR_INVALID_ARGUMENT);
  budget.seconds = std::numeric_limits<double>::infinity();
  EXPECT_EQ(tyn_renderer_run(renderer, &budget), TYN_ERROR_INVALID_ARGUMENT);
  budget.seconds = 0;
  budget.target_error = -1;
  EXPECT_EQ(tyn_renderer_run(renderer, &budget), TYN_ERROR_INVALID_ARGUMENT);
}

TEST_F(BadRender, LayersAreReadWholeOrNotAtAll) {
  create();
  std::vector<float> pixels(4 * 3 * 4, -1.0f);
  EXPECT_EQ(tyn_renderer_read(renderer, TYN_LAYER_BEAUTY, pixels.data(), pixels.size() - 1),
            TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(pixels[0], -1);
  EXPECT_EQ(tyn_renderer_read(renderer, TYN_LAYER_COUNT, pixels.data(), pixels.size()), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_renderer_read(renderer, TYN_LAYER_BEAUTY, nullptr, 0), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_renderer_read(renderer, TYN_LAYER_BEAUTY, pixels.data(), pixels.size()), TYN_OK);
}

} // namespace
