// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Different estimators of one number agree: one walk for three channels and three walks, with and without roulette.
#include <cmath>

#include <gtest/gtest.h>

#include "common/statistics.hpp"
#include "common/walk_scene.hpp"

namespace {

using namespace tyn_test;

struct Escaped {
  Mean weight[3];
};

Escaped escaped(const MeshData &mesh, const TynMedium &medium, uint64_t seed, bool roulette, uint32_t batches) {
  SceneHandle scene = make_scene(shared_context(), mesh, medium);
  Escaped result;
  for (uint32_t batch = 0; batch < batches; ++batch) {
    TynWalkOptions options = tyn_walk_options();
    options.seed = seed;
    options.first_path = batch * 100000u;
    options.roulette_off = roulette ? 0 : 1;
    Walked walked = walk(scene.get(), surface_entries(mesh, 100000, uint32_t(seed) * 100 + batch), options);
    for (const TynWalkExit &exit : walked.exits)
      for (int c = 0; c < 3; ++c)
        result.weight[c].add(exit.status == TYN_WALK_ESCAPED ? exit.weight[c] : 0);
  }
  return result;
}

// False-alarm rate 6e-5.
void expect_equal(const Mean &a, const Mean &b) {
  double error = std::hypot(a.standard_error(), b.standard_error());
  EXPECT_NEAR(a.mean(), b.mean(), four_sigma * error);
  EXPECT_LT(error, 5e-3 * a.mean()) << "too few walks to say anything";
}

// N = 5e5 each.
TEST(WalkEstimators, OneColouredWalkIsThreeGreyOnes) {
  const float sigma_a[3] = {0.05f, 0.1f, 0.4f}, sigma_s[3] = {0.5f, 3, 8};
  MeshData mesh = icosphere(2);
  for (float ior : {1.0f, 1.4f}) {
    Escaped together = escaped(mesh, rgb_medium(sigma_a, sigma_s, 0.4f, ior), 1, true, 5);
    for (uint64_t c = 0; c < 3; ++c) {
      Escaped alone = escaped(mesh, grey_medium(sigma_a[c], sigma_s[c], 0.4f, ior), 2 + c, true, 5);
      expect_equal(together.weight[c], alone.weight[0]);
    }
  }
}

// N = 5e5 each.
TEST(WalkEstimators, RouletteChangesNoMean) {
  MeshData mesh = cube();
  for (float ior : {1.0f, 1.5f}) {
    TynMedium medium = rgb_medium({0.5f, 0.2f, 0.1f}, {2, 4, 3}, 0, ior);
    Escaped with = escaped(mesh, medium, 5, true, 5), without = escaped(mesh, medium, 6, false, 5);
    for (int c = 0; c < 3; ++c)
      expect_equal(with.weight[c], without.weight[c]);
  }
}

// A threshold of 1 plays at every scattering. N = 5e5.
TEST(WalkEstimators, TheRouletteThresholdChangesNoMean) {
  MeshData mesh = icosphere(2);
  TynMedium medium = grey_medium(0.3f, 2);
  Escaped low = escaped(mesh, medium, 7, true, 5);
  SceneHandle scene = make_scene(shared_context(), mesh, medium);
  TynWalkOptions options = tyn_walk_options();
  options.seed = 8;
  options.roulette_threshold = 1;
  Mean high;
  for (const TynWalkExit &exit : walk(scene.get(), surface_entries(mesh, 500000, 8), options).exits)
    high.add(exit.status == TYN_WALK_ESCAPED ? exit.weight[0] : 0);
  expect_equal(low.weight[0], high);
}

} // namespace
