// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The same scene, options and number of samples give the same bits, however the work was cut up.
#include <algorithm>
#include <cstring>
#include <vector>

#include <gtest/gtest.h>

#include "common/render_scene.hpp"

namespace {

using namespace tyn_test;

// A wax ball, a rough metal ball and a lamp: every kernel has work.
void build(Scene &scene) {
  TynMedium medium = tyn_medium();
  medium.ior = 1.4f;
  medium.g = 0.3f;
  for (int i = 0; i < 3; i++) {
    medium.sigma_s[i] = 4.0f + float(i);
    medium.sigma_a[i] = 0.1f * float(i);
  }
  uint32_t inside = TYN_NONE, wax = TYN_NONE, metal = TYN_NONE, lamp = TYN_NONE;
  ASSERT_EQ(tyn_scene_add_medium(scene, &medium, &inside), TYN_OK);
  TynMaterial material = tyn_material();
  material.ior = 1.4f;
  material.roughness = 0.5f;
  material.transmission = 0.9f;
  ASSERT_EQ(tyn_scene_add_material(scene, &material, &wax), TYN_OK);
  material.metallic = 1;
  material.base_color[1] = 0.5f;
  ASSERT_EQ(tyn_scene_add_material(scene, &material, &metal), TYN_OK);
  material = matte(0.2f);
  material.emission[0] = material.emission[1] = 8;
  ASSERT_EQ(tyn_scene_add_material(scene, &material, &lamp), TYN_OK);
  scene.add(translated(icosphere(2, 0.8f), -0.8f, 0, 0), inside, wax);
  scene.add(translated(icosphere(2, 0.8f), 0.8f, 0, 0), TYN_NONE, metal);
  scene.add(translated(inverted(quad(1)), 0, 2, 0), TYN_NONE, lamp);
  TynEnvironment environment = constant_environment(0.3f);
  ASSERT_EQ(tyn_scene_set_environment(scene, &environment), TYN_OK);
  scene.commit();
}

TynRenderOptions options() {
  TynRenderOptions result = film_options(24, 16, look_at({0, 1, 6}, {0, 0, 0}, {0, 1, 0}, 0.6));
  result.seed = 0x123456789abcdefu;
  return result;
}

struct Outcome {
  std::vector<std::vector<float>> layers;
  TynLedger ledger;
};

Outcome outcome(const Render &render) {
  Outcome result;
  for (uint32_t layer = 0; layer < TYN_LAYER_COUNT; layer++)
    result.layers.push_back(render.layer(layer));
  result.ledger = render.stats().ledger;
  return result;
}

void expect_same_bits(const Outcome &a, const Outcome &b) {
  for (uint32_t layer = 0; layer < TYN_LAYER_COUNT; layer++)
    EXPECT_EQ(std::memcmp(a.layers[layer].data(), b.layers[layer].data(), a.layers[layer].size() * sizeof(float)), 0)
        << tyn_layer_name(layer);
  EXPECT_EQ(std::memcmp(&a.ledger, &b.ledger, sizeof a.ledger), 0) << "ledger";
}

class Determinism : public testing::Test {
protected:
  // 6 samples, in calls of the given sizes, at most `largest_pass` paths a pass (0: as it comes).
  Outcome render(const std::vector<uint32_t> &calls, size_t largest_pass, uint64_t memory_limit = 0,
                 uint32_t lanes = 0) {
    TynContextOptions context_options = tyn_context_options();
    context_options.memory_limit = memory_limit;
    context_options.lane_width = lanes;
    Context context(context_options);
    Scene scene(context);
    build(scene);
    Render render(scene, options());
    if (largest_pass)
      render->largest_pass = largest_pass;
    for (const uint32_t samples : calls)
      render.run(samples);
    return outcome(render);
  }
  const Outcome &reference() {
    static const Outcome result = render({6}, 0);
    return result;
  }
};

TEST_F(Determinism, RendersSomethingInEveryLayer) {
  for (uint32_t layer = 0; layer < TYN_LAYER_COUNT; layer++) {
    const std::vector<float> &pixels = reference().layers[layer];
    EXPECT_GT(*std::max_element(pixels.begin(), pixels.end()), 0) << tyn_layer_name(layer);
  }
  EXPECT_GT(reference().ledger.walks, 100u);
  EXPECT_GT(reference().ledger.absorbed[2], 0);
}

TEST_F(Determinism, RepeatsBitForBit) { expect_same_bits(render({6}, 0), reference()); }

TEST_F(Determinism, DoesNotDependOnHowSamplesAreSplitOverCalls) { expect_same_bits(render({1, 2, 3}, 0), reference()); }

TEST_F(Determinism, DoesNotDependOnThePathsOfAPass) {
  expect_same_bits(render({6}, 1000), reference()); // more than the film's 384 pixels
  expect_same_bits(render({6}, 100), reference());  // less
  expect_same_bits(render({1, 5}, 97), reference());
}

TEST_F(Determinism, DoesNotDependOnTheMemoryLimit) {
  // 330 kB: the scene and the film take half of it
  expect_same_bits(render({6}, 0, 330000), reference());
}

TEST_F(Determinism, DoesNotDependOnTheLaneWidth) { expect_same_bits(render({6}, 0, 0, 1), reference()); }

TEST_F(Determinism, DependsOnTheSeed) {
  Context context;
  Scene scene(context);
  build(scene);
  TynRenderOptions other = options();
  other.seed ^= uint64_t(1) << 40; // the high word counts too
  Render render(scene, other);
  render.run(6);
  EXPECT_NE(render.layer(TYN_LAYER_BEAUTY), reference().layers[TYN_LAYER_BEAUTY]);
}

// Rounding of weights to 2^-32 and of float sums within a walk: 1e-6 of a weight a walk.
TEST_F(Determinism, TheLedgerAccountsForEverything) {
  const TynLedger &l = reference().ledger;
  for (int c = 0; c < 3; c++)
    EXPECT_NEAR(l.entered[c],
                l.reflected[c] + l.escaped[c] + l.absorbed[c] + l.balance[c] + l.capped[c] + l.leaked[c] + l.lost[c],
                1e-6 * double(l.walks));
  EXPECT_EQ(l.walks, l.escaped_walks + l.absorbed_walks + l.capped_walks + l.leaked_walks + l.lost_walks);
}

TEST(NonfinitePaths, AreLeftOutAndCounted) {
  Context context;
  Scene scene(context);
  TynMaterial material = matte(1);
  material.emission[0] = 3e38f; // that and the environment's light are too much for a float
  uint32_t index = TYN_NONE;
  ASSERT_EQ(tyn_scene_add_material(scene, &material, &index), TYN_OK) << scene.message();
  scene.add(icosphere(2), TYN_NONE, index);
  const TynEnvironment environment = constant_environment(3e38f);
  ASSERT_EQ(tyn_scene_set_environment(scene, &environment), TYN_OK) << scene.message();
  scene.commit();
  Render render(scene, film_options(4, 4, look_at({0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 0.1)));
  render.run(2);
  EXPECT_EQ(render.stats().nonfinite_paths, 2u * 16);
  EXPECT_EQ(render.layer(TYN_LAYER_EMISSION), std::vector<float>(48, 0.0f));
  for (const float x : render.layer(TYN_LAYER_BEAUTY))
    EXPECT_TRUE(x == 0 || x == 1); // alpha
}

// Lengths enter only as they are: no epsilon is absolute. Only the depth layer changes, by the factor.
TEST_F(Determinism, ScalingTheSceneByTwoChangesNoBit) {
  const auto scaled_render = [](float factor) {
    Context context;
    Scene scene(context);
    TynMedium medium = tyn_medium();
    medium.ior = 1.3f;
    for (int i = 0; i < 3; i++)
      medium.sigma_s[i] = 3.0f / factor;
    uint32_t inside = TYN_NONE, wax = TYN_NONE;
    EXPECT_EQ(tyn_scene_add_medium(scene, &medium, &inside), TYN_OK);
    TynMaterial material = tyn_material();
    material.ior = 1.3f;
    material.transmission = 0.7f;
    EXPECT_EQ(tyn_scene_add_material(scene, &material, &wax), TYN_OK);
    scene.add(scaled(icosphere(2), factor), inside, wax);
    TynLight light = tyn_light();
    light.position[0] = 2 * factor;
    light.position[1] = 3 * factor;
    for (float &x : light.intensity)
      x = 7 * factor * factor;
    EXPECT_EQ(tyn_scene_add_light(scene, &light, nullptr), TYN_OK);
    const TynEnvironment environment = constant_environment(0.5f);
    EXPECT_EQ(tyn_scene_set_environment(scene, &environment), TYN_OK);
    scene.commit();
    Render render(scene, film_options(16, 16, look_at({0, 0, 4 * double(factor)}, {0, 0, 0}, {0, 1, 0}, 0.6)));
    render.run(4);
    return render.layer(TYN_LAYER_BEAUTY);
  };
  EXPECT_EQ(scaled_render(1), scaled_render(2));
}

} // namespace
