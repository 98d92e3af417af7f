// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The white furnace of walks: without absorption everything that enters leaves. For grey media every single weight is 1, so
// this holds to rounding and not only on average.
#include <cmath>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "common/statistics.hpp"
#include "common/walk_scene.hpp"

namespace {

using namespace tyn_test;

struct Furnace {
  const char *name;
  float g, ior, roughness, sigma_s;
};

class WhiteFurnace : public testing::TestWithParam<Furnace> {};

// Turns entries into light from outside, from random directions of the upper hemisphere of each triangle.
void arrive_from_outside(const MeshData &mesh, std::vector<TynWalkEntry> &entries) {
  std::mt19937 random(21);
  std::normal_distribution<double> normal;
  for (TynWalkEntry &entry : entries) {
    double p[3][3], d[3], length = 0, along = 0;
    for (int i = 0; i < 9; ++i)
      p[i / 3][i % 3] = mesh.positions[3 * mesh.indices[3 * entry.triangle + uint32_t(i / 3)] + uint32_t(i % 3)];
    for (double &x : d) {
      x = normal(random);
      length += x * x;
    }
    for (int k = 0; k < 3; ++k) {
      int a = (k + 1) % 3, b = (k + 2) % 3;
      along += d[k] * ((p[1][a] - p[0][a]) * (p[2][b] - p[0][b]) - (p[1][b] - p[0][b]) * (p[2][a] - p[0][a]));
    }
    for (int k = 0; k < 3; ++k)
      entry.direction[k] = static_cast<float>(d[k] / std::sqrt(length) * (along > 0 ? -1 : 1));
    entry.kind = TYN_ENTRY_REFRACT;
  }
}

TEST_P(WhiteFurnace, GivesBackWhatEnters) {
  const Furnace &f = GetParam();
  MeshData mesh = torus(1.0f, 0.4f, 48, 24);
  SceneHandle scene = make_scene(shared_context(), mesh, grey_medium(0, f.sigma_s, f.g, f.ior));
  for (bool outside : {false, true}) {
    std::vector<TynWalkEntry> entries = surface_entries(mesh, 50000, 20);
    if (outside)
      arrive_from_outside(mesh, entries);
    for (TynWalkEntry &entry : entries)
      entry.roughness = f.roughness;
    TynWalkOptions options = tyn_walk_options();
    options.roulette_off = outside; // what grazing light refracts in may be below the threshold from the start
    TynLedger ledger = walk(scene.get(), entries, options).ledger;
    EXPECT_EQ(ledger.escaped_walks + ledger.reflected_walks, entries.size());
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(ledger.escaped[c] + ledger.reflected[c], ledger.entered[c], 1e-6 * ledger.entered[c]);
      EXPECT_EQ(ledger.absorbed[c], 0);
      EXPECT_EQ(ledger.balance[c], 0);
      if (outside && f.ior != 1) {
        EXPECT_GT(ledger.reflected[c], 0.02 * ledger.entered[c]);
      } else {
        EXPECT_EQ(ledger.reflected[c], 0);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    OfATorus, WhiteFurnace,
    testing::Values(Furnace{"MatchedThinBackward", -0.5f, 1, 0, 0.5f}, Furnace{"MatchedThin", 0, 1, 0, 0.5f},
                    Furnace{"MatchedDense", 0, 1, 0, 20}, Furnace{"MatchedForward", 0.8f, 1, 0, 20},
                    Furnace{"SmoothThin", 0, 1.4f, 0, 0.5f}, Furnace{"SmoothDense", 0, 1.4f, 0, 20},
                    Furnace{"SmoothForward", 0.8f, 1.4f, 0, 20}, Furnace{"SmoothBackward", -0.5f, 1.4f, 0, 5},
                    Furnace{"RoughThin", 0, 1.4f, 0.3f, 0.5f}, Furnace{"RoughDense", 0, 1.4f, 0.3f, 20},
                    Furnace{"RoughForward", 0.8f, 1.4f, 0.5f, 20}, Furnace{"VeryRough", -0.5f, 1.4f, 1.0f, 5}),
    [](const auto &parameter) { return std::string(parameter.param.name); });

// In a coloured medium the weights differ from walk to walk and only their mean is 1. N = 1e6; false-alarm rate 6e-5 a channel.
TEST(WhiteFurnaceInColour, GivesBackWhatEntersOnAverage) {
  MeshData mesh = icosphere(2);
  SceneHandle scene = make_scene(shared_context(), mesh, rgb_medium({0, 0, 0}, {0.5f, 2, 6}, 0.3f));
  Mean weight[3];
  TynWalkOptions options = tyn_walk_options();
  for (uint32_t batch = 0; batch < 5; ++batch) {
    options.first_path = batch * 200000u;
    Walked walked = walk(scene.get(), surface_entries(mesh, 200000, batch), options);
    for (const TynWalkExit &exit : walked.exits)
      for (int c = 0; c < 3; ++c)
        weight[c].add(exit.status == TYN_WALK_ESCAPED ? exit.weight[c] : 0);
  }
  for (const Mean &w : weight) {
    EXPECT_NEAR(w.mean(), 1, four_sigma * w.standard_error());
    EXPECT_LT(w.standard_error(), 2e-3);
  }
}

} // namespace
