// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Budgets, progress, cancelling, the film in between, and what a renderer says about itself.
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "common/render_scene.hpp"

namespace {

using namespace tyn_test;

class Progress : public testing::Test {
protected:
  Context context;
  Scene scene{context};

  void SetUp() override {
    scene.add(icosphere(2));
    const TynEnvironment environment = constant_environment(1);
    ASSERT_EQ(tyn_scene_set_environment(scene, &environment), TYN_OK);
    TynLight light = tyn_light();
    light.position[1] = 3;
    ASSERT_EQ(tyn_scene_add_light(scene, &light, nullptr), TYN_OK);
    scene.commit();
  }
  TynRenderOptions options() const { return film_options(16, 16, look_at({0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 0.5)); }
};

struct Calls {
  std::vector<double> fractions;
  size_t cancel_at = SIZE_MAX;
  static int32_t take(void *user, double fraction) {
    Calls &calls = *static_cast<Calls *>(user);
    calls.fractions.push_back(fraction);
    return calls.fractions.size() > calls.cancel_at;
  }
};

TEST_F(Progress, GoesFromNothingToOneWithoutTurningBack) {
  Render render(scene, options());
  render->largest_pass = 100;
  Calls calls;
  TynRenderBudget budget = tyn_render_budget();
  budget.samples = 5;
  budget.progress = Calls::take;
  budget.user = &calls;
  ASSERT_EQ(tyn_renderer_run(render, &budget), TYN_OK) << render.message();
  ASSERT_GT(calls.fractions.size(), 5u);
  EXPECT_EQ(calls.fractions.front(), 0);
  EXPECT_EQ(calls.fractions.back(), 1);
  for (size_t i = 1; i < calls.fractions.size(); i++)
    EXPECT_GE(calls.fractions[i], calls.fractions[i - 1]);
}

TEST_F(Progress, ACancelledRenderIsValidAndCanGoOn) {
  Render whole(scene, options());
  whole.run(5);
  Render render(scene, options());
  render->largest_pass = 100; // 256 pixels: three passes a sample
  Calls calls;
  calls.cancel_at = 7; // in the middle of a sample
  TynRenderBudget budget = tyn_render_budget();
  budget.samples = 5;
  budget.progress = Calls::take;
  budget.user = &calls;
  ASSERT_EQ(tyn_renderer_run(render, &budget), TYN_ERROR_CANCELLED);
  const TynRenderStats stats = render.stats();
  EXPECT_EQ(stats.samples, 2u);
  EXPECT_EQ(stats.paths, 2u * 256 + 100);
  const std::vector<float> counts = render.layer(TYN_LAYER_SAMPLES);
  EXPECT_EQ(counts.front(), 3);
  EXPECT_EQ(counts.back(), 2);
  for (const float x : render.layer(TYN_LAYER_BEAUTY))
    EXPECT_TRUE(std::isfinite(x));
  render.run(3); // 2 + 3: the half-done third sample is among them
  EXPECT_EQ(render.layer(TYN_LAYER_BEAUTY), whole.layer(TYN_LAYER_BEAUTY));
}

TEST_F(Progress, CancellingAtOnceLeavesAnEmptyFilm) {
  Render render(scene, options());
  Calls calls;
  calls.cancel_at = 0;
  TynRenderBudget budget = tyn_render_budget();
  budget.progress = Calls::take;
  budget.user = &calls;
  EXPECT_EQ(tyn_renderer_run(render, &budget), TYN_ERROR_CANCELLED);
  EXPECT_EQ(render.stats().samples, 0u);
  EXPECT_EQ(render.stats().error, 0);
  EXPECT_EQ(render.layer(TYN_LAYER_BEAUTY), std::vector<float>(16 * 16 * 4, 0.0f));
}

TEST_F(Progress, TheFirstSampleComesAloneAsAPreview) {
  Render render(scene, options());
  Calls calls;
  calls.cancel_at = 1;
  TynRenderBudget budget = tyn_render_budget();
  budget.progress = Calls::take;
  budget.user = &calls;
  EXPECT_EQ(tyn_renderer_run(render, &budget), TYN_ERROR_CANCELLED);
  EXPECT_EQ(render.layer(TYN_LAYER_SAMPLES), std::vector<float>(16 * 16, 1.0f));
}

TEST_F(Progress, StopsAtTheTargetErrorAndNotBefore16Samples) {
  Render render(scene, options());
  TynRenderBudget budget = tyn_render_budget();
  budget.samples = 0;
  budget.target_error = 1e6;
  ASSERT_EQ(tyn_renderer_run(render, &budget), TYN_OK);
  EXPECT_EQ(render.stats().samples, 16u);
  budget.target_error = 0.7 * render.stats().error;
  ASSERT_EQ(tyn_renderer_run(render, &budget), TYN_OK);
  EXPECT_LE(render.stats().error, budget.target_error);
  // about 16 / 0.7^2; the steps there are of 8
  EXPECT_GT(render.stats().samples, 24u);
  EXPECT_LT(render.stats().samples, 64u);
}

TEST_F(Progress, StopsAfterTheTimeItWasGiven) {
  Render render(scene, options());
  render.run(1); // kernels are compiled
  TynRenderBudget budget = tyn_render_budget();
  budget.samples = 0;
  budget.seconds = 0.3;
  const double before = render.stats().seconds;
  ASSERT_EQ(tyn_renderer_run(render, &budget), TYN_OK);
  const TynRenderStats stats = render.stats();
  EXPECT_GE(stats.seconds - before, 0.3);
  EXPECT_GT(stats.samples, 1u);
}

TEST_F(Progress, ARendererOutlivesTheHandlesItWasMadeFrom) {
  TynContext *own = nullptr;
  ASSERT_EQ(tyn_context_create(nullptr, &own), TYN_OK);
  TynScene *inside = nullptr;
  ASSERT_EQ(tyn_scene_create(own, nullptr, &inside), TYN_OK);
  const MeshData data = icosphere(1);
  const TynMesh mesh = data.view();
  ASSERT_EQ(tyn_scene_add_mesh(inside, &mesh, nullptr), TYN_OK);
  ASSERT_EQ(tyn_scene_commit(inside), TYN_OK);
  TynRenderer *renderer = nullptr;
  const TynRenderOptions small = options();
  ASSERT_EQ(tyn_renderer_create(inside, &small, &renderer), TYN_OK);
  EXPECT_EQ(tyn_renderer_scene(renderer), inside);
  tyn_scene_release(inside);
  tyn_context_release(own);
  tyn_renderer_retain(renderer);
  tyn_renderer_release(renderer);
  TynRenderBudget budget = tyn_render_budget();
  budget.samples = 1;
  EXPECT_EQ(tyn_renderer_run(renderer, &budget), TYN_OK);
  tyn_renderer_release(renderer);
}

TEST(Layers, HaveDistinctNamesAndChannels) {
  std::set<std::string> names;
  for (uint32_t layer = 0; layer < TYN_LAYER_COUNT; layer++) {
    ASSERT_NE(tyn_layer_name(layer), nullptr);
    names.insert(tyn_layer_name(layer));
    EXPECT_GE(tyn_layer_channels(layer), 1u);
    EXPECT_LE(tyn_layer_channels(layer), 4u);
  }
  EXPECT_EQ(names.size(), size_t(TYN_LAYER_COUNT));
  EXPECT_EQ(std::string(tyn_layer_name(TYN_LAYER_BEAUTY)), "beauty");
  EXPECT_EQ(tyn_layer_channels(TYN_LAYER_BEAUTY), 4u);
  EXPECT_EQ(tyn_layer_name(TYN_LAYER_COUNT), nullptr);
  EXPECT_EQ(tyn_layer_channels(TYN_LAYER_COUNT), 0u);
}

} // namespace
