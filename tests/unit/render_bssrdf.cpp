// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// A BSSRDF model in place of walks: the same bits however the samples are split, an account of all light, and older callers.
#include <cstddef>
#include <cstring>

#include <gtest/gtest.h>

#include "common/render_scene.hpp"
#include "common/walk_scene.hpp"

namespace {

using namespace tyn_test;

class RenderBssrdf : public testing::Test {
protected:
  Context context;
  Scene scene{context};

  void build(const MeshData &mesh) {
    const TynMedium medium = rgb_medium({0.1f, 0.5f, 1}, {5, 4, 3}, 0.3f, 1.3f);
    TynMaterial material = tyn_material();
    material.ior = 1.3f;
    material.transmission = 1;
    uint32_t medium_index = TYN_NONE, material_index = TYN_NONE;
    ASSERT_EQ(tyn_scene_add_medium(scene, &medium, &medium_index), TYN_OK);
    ASSERT_EQ(tyn_scene_add_material(scene, &material, &material_index), TYN_OK);
    scene.add(mesh, medium_index, material_index);
    const TynEnvironment environment = constant_environment(1);
    ASSERT_EQ(tyn_scene_set_environment(scene, &environment), TYN_OK);
    scene.commit();
  }

  static TynRenderOptions options() {
    TynRenderOptions options = film_options(24, 16, look_at({0, 1, 5}, {0, 0, 0}, {0, 1, 0}, 0.5));
    options.bssrdf = TYN_BSSRDF_NORMALIZED_DIFFUSION;
    return options;
  }
};

TEST_F(RenderBssrdf, IsTheSameHoweverItsSamplesAreSplit) {
  build(torus(1, 0.4f, 24, 12));
  Render whole(scene, options()), parts(scene, options());
  whole.run(5);
  parts->largest_pass = 100;
  parts.run(2);
  parts.run(3);
  EXPECT_EQ(whole.layer(TYN_LAYER_BEAUTY), parts.layer(TYN_LAYER_BEAUTY));
}

TEST_F(RenderBssrdf, AccountsForAllLight) {
  build(torus(1, 0.4f, 24, 12));
  Render render(scene, options());
  render.run(8);
  const TynRenderStats stats = render.stats();
  const TynLedger &ledger = stats.ledger;
  EXPECT_GT(ledger.walks, 300u);
  EXPECT_GT(ledger.escaped_walks, ledger.walks / 3);
  EXPECT_EQ(ledger.lost_walks, 0u);
  EXPECT_EQ(stats.nonfinite_paths, 0u);
  EXPECT_GT(stats.seconds_walks, 0);
  for (int c = 0; c < 3; c++) {
    EXPECT_NEAR(accounted(ledger, c) / ledger.entered[c], 1, 1e-6);
    EXPECT_GT(ledger.absorbed[c], 0);
  }
}

// What comes through a hole has no place where it got in.
TEST_F(RenderBssrdf, LeavesOutLightFromInside) {
  build(open_hemisphere(3));
  TynRenderOptions from_below = options();
  from_below.camera = look_at({0, -4, 1}, {0, 0, 0}, {0, 1, 0}, 0.6);
  Render render(scene, from_below);
  render.run(4);
  const TynLedger ledger = render.stats().ledger;
  EXPECT_GT(ledger.leaked_walks, 100u);
  EXPECT_GT(ledger.leaked[0], 0);
  for (int c = 0; c < 3; c++)
    EXPECT_NEAR(accounted(ledger, c) / ledger.entered[c], 1, 1e-6);
}

// Programs that were compiled before there was the option get walks, whatever is behind their struct.
TEST_F(RenderBssrdf, IsNotWhatOlderCallersMean) {
  build(icosphere(2));
  TynRenderOptions older = options();
  older.size = offsetof(TynRenderOptions, bssrdf);
  older.bssrdf = 12345;
  TynRenderer *renderer = nullptr;
  ASSERT_EQ(tyn_renderer_create(scene, &older, &renderer), TYN_OK) << scene.message();
  EXPECT_EQ(renderer->options.bssrdf, TYN_NONE);
  tyn_renderer_release(renderer);
  EXPECT_EQ(tyn_render_options().bssrdf, TYN_NONE);
}

// Nothing to prepare.
TEST_F(RenderBssrdf, WorksWithoutMedia) {
  scene.add(icosphere(2));
  scene.commit();
  Render render(scene, options());
  render.run(1);
  EXPECT_EQ(render.stats().ledger.walks, 0u);
}

} // namespace
