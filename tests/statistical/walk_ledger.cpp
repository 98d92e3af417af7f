// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The ledger: whatever happens to light, it is written down, and it adds up to what entered.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "common/statistics.hpp"
#include "common/walk_scene.hpp"

namespace {

using namespace tyn_test;

void expect_balanced(const TynLedger &ledger) {
  for (int c = 0; c < 3; ++c)
    EXPECT_NEAR(accounted(ledger, c), ledger.entered[c], 1e-5 * ledger.entered[c]) << "channel " << c;
  EXPECT_EQ(ledger.walks, ledger.escaped_walks + ledger.absorbed_walks + ledger.capped_walks + ledger.leaked_walks +
                              ledger.lost_walks + ledger.reflected_walks);
}

TynMedium coloured_medium(float ior = 1) { return rgb_medium({0.3f, 0.1f, 0.02f}, {1, 4, 9}, 0.6f, ior); }

TEST(WalkLedger, SumsToWhatEnteredInColouredMedia) {
  MeshData mesh = icosphere(3);
  for (float ior : {1.0f, 1.4f}) {
    SceneHandle scene = make_scene(shared_context(), mesh, coloured_medium(ior));
    std::vector<TynWalkEntry> entries = surface_entries(mesh, 50000, 1);
    for (size_t i = 0; i < entries.size(); ++i) {
      entries[i].roughness = i % 2 ? 0.4f : 0.0f;
      for (size_t c = 0; c < 3; ++c)
        entries[i].weight[c] = 0.1f * static_cast<float>((i + c) % 5); // 0 included
    }
    TynLedger ledger = walk(scene.get(), entries).ledger;
    expect_balanced(ledger);
    for (int c = 0; c < 3; ++c) {
      EXPECT_GT(ledger.absorbed[c], 0);
      EXPECT_GT(ledger.escaped[c], 0);
      EXPECT_EQ(ledger.lost[c], 0);
      EXPECT_EQ(ledger.leaked[c], 0);
    }
  }
}

// 64 batches of 5000 walks give its standard error; false-alarm rate 6e-5 a channel.
TEST(WalkLedger, BalanceIsZeroOnAverage) {
  MeshData mesh = icosphere(2);
  SceneHandle scene = make_scene(shared_context(), mesh, coloured_medium());
  Mean balance[3];
  TynWalkOptions options = tyn_walk_options();
  options.seed = 2;
  for (uint32_t batch = 0; batch < 64; ++batch) {
    options.first_path = batch * 5000u;
    TynLedger ledger = walk(scene.get(), surface_entries(mesh, 5000, batch), options).ledger;
    for (int c = 0; c < 3; ++c)
      balance[c].add(ledger.balance[c] / 5000);
  }
  for (const Mean &b : balance) {
    EXPECT_NEAR(b.mean(), 0, four_sigma * b.standard_error());
    EXPECT_LT(b.standard_error(), 5e-3);
    EXPECT_GT(b.standard_error(), 0);
  }
}

// The balance heuristic over three channels. Roulette raises weights to its threshold at most.
TEST(WalkLedger, NoWeightExceedsThreeTimesWhatEntered) {
  MeshData mesh = icosphere(2);
  SceneHandle scene = make_scene(shared_context(), mesh, rgb_medium({0, 0, 0}, {0.01f, 1, 100}));
  for (uint32_t off : {0u, 1u}) {
    TynWalkOptions options = tyn_walk_options();
    options.roulette_off = off;
    float largest = 0;
    for (const TynWalkExit &exit : walk(scene.get(), surface_entries(mesh, 30000, 3), options).exits)
      largest = std::max({largest, exit.weight[0], exit.weight[1], exit.weight[2]});
    EXPECT_LE(largest, 3 * (1 + 1e-4f)); // rounding over many flights
    EXPECT_GT(largest, 2);               // the bound is nearly reached
  }
}

TEST(WalkLedger, NamesWhatACapCut) {
  MeshData mesh = icosphere(2);
  SceneHandle scene = make_scene(shared_context(), mesh, coloured_medium());
  std::vector<TynWalkEntry> entries = surface_entries(mesh, 20000, 4);
  double cut_before = INFINITY;
  for (uint32_t cap : {1u, 2u, 8u, 64u}) {
    TynWalkOptions options = tyn_walk_options();
    options.max_scatterings = cap;
    Walked walked = walk(scene.get(), entries, options);
    expect_balanced(walked.ledger);
    EXPECT_GT(walked.ledger.capped_walks, 0u) << cap;
    EXPECT_LT(walked.ledger.capped[1], cut_before) << cap;
    cut_before = walked.ledger.capped[1];
    for (const TynWalkExit &exit : walked.exits) {
      ASSERT_LE(exit.scatterings, cap);
      ASSERT_TRUE(exit.status != TYN_WALK_CAPPED || exit.scatterings == cap);
    }
  }
}

TEST(WalkLedger, ReportsWhatLeaksThroughAHole) {
  MeshData mesh = open_hemisphere(3);
  SceneHandle scene = make_scene(shared_context(), mesh, grey_medium(0.1f, 1));
  EXPECT_EQ(mesh_info(scene.get()).closed, 0u);
  Walked walked = walk(scene.get(), surface_entries(mesh, 20000, 5));
  expect_balanced(walked.ledger);
  EXPECT_GT(walked.ledger.leaked_walks, 1000u);
  EXPECT_GT(walked.ledger.leaked[0], 0);
  EXPECT_EQ(walked.ledger.lost_walks, 0u);
  for (const TynWalkExit &exit : walked.exits)
    ASSERT_TRUE(exit.status != TYN_WALK_LEAKED || exit.triangle == TYN_NONE);
}

// In a clear cube a diagonal ray meets every face beyond the critical angle, for ever.
TEST(WalkLedger, EndsLightThatIsTrappedForGood) {
  SceneHandle scene = make_scene(shared_context(), cube(), grey_medium(0, 0, 0, 1.5f));
  TynWalkEntry entry = plain_entry(TYN_ENTRY_INSIDE);
  for (int k = 0; k < 3; ++k) {
    entry.position[k] = 0.1f * static_cast<float>(k);
    entry.direction[k] = 0.57735027f;
  }
  Walked walked = walk(scene.get(), std::vector<TynWalkEntry>(100, entry));
  EXPECT_EQ(walked.ledger.capped_walks, 100u);
  expect_balanced(walked.ledger);
}

// A walk is confined to its mesh: nothing is lost, whatever the mesh looks like.
TEST(WalkLedger, LosesAndLeaksNothingInAnyClosedMesh) {
  for (const NamedMesh &named : closed_meshes()) {
    SceneHandle scene = make_scene(shared_context(), named.mesh, grey_medium(0, 2, 0.5f, 1.3f));
    TynLedger ledger = walk(scene.get(), surface_entries(named.mesh, 20000, 6)).ledger;
    EXPECT_EQ(ledger.escaped_walks, 20000u) << named.name;
    EXPECT_EQ(ledger.leaked_walks, 0u) << named.name;
    EXPECT_EQ(ledger.lost_walks, 0u) << named.name;
    expect_balanced(ledger);
  }
}

} // namespace
