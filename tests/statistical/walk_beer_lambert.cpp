// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// At albedo 0 what gets through is what did not collide: exp(-sigma t), Beer and Lambert.
#include <cmath>

#include <gtest/gtest.h>

#include "common/statistics.hpp"
#include "common/walk_scene.hpp"

namespace {

using namespace tyn_test;

TynWalkOptions without_roulette(uint64_t first_path) {
  TynWalkOptions options = tyn_walk_options();
  options.roulette_off = 1;
  options.first_path = first_path;
  return options;
}

// The weight that escapes; what is absorbed counts as 0.
void add_escaped(const Walked &walked, Mean (&mean)[3]) {
  for (const TynWalkExit &exit : walked.exits)
    for (int c = 0; c < 3; ++c)
      mean[c].add(exit.status == TYN_WALK_ESCAPED ? exit.weight[c] : 0);
}

// False-alarm rate 6e-5 for four standard errors.
void expect_transmitted(const Mean &mean, double exact) {
  EXPECT_NEAR(mean.mean(), exact, four_sigma * mean.standard_error());
  EXPECT_NEAR(mean.mean(), exact, 1e-3 * exact);
}

// Straight through the middle of a box of depth 2. N = 4e6.
TEST(BeerLambert, ThroughABoxTransmitsTheExponential) {
  const float sigma_a[3] = {0.05f, 0.1f, 0.2f};
  SceneHandle scene = make_scene(shared_context(), box(1, 1, 2), rgb_medium(sigma_a, {0, 0, 0}));
  TynWalkEntry entry = plain_entry(TYN_ENTRY_INSIDE);
  entry.position[0] = 0.1f;
  entry.position[1] = 0.2f;
  entry.position[2] = -1;
  std::vector<TynWalkEntry> entries(200000, entry);
  Mean transmitted[3];
  for (uint64_t batch = 0; batch < 20; ++batch)
    add_escaped(walk(scene.get(), entries, without_roulette(batch * entries.size())), transmitted);
  for (int c = 0; c < 3; ++c)
    expect_transmitted(transmitted[c], std::exp(-2.0 * sigma_a[c]));
}

// Cosine-distributed chords of a unit sphere: 2 (1 - (1 + x) e^-x) / x^2 with x = 2 sigma, on average. N = 4e6; the
// tessellation's chords are short by 2e-5.
TEST(BeerLambert, ThroughTheChordsOfASphereTransmitsTheClosedForm) {
  const float sigma_a[3] = {0.05f, 0.1f, 0.2f};
  MeshData mesh = icosphere(6);
  SceneHandle scene = make_scene(shared_context(), mesh, rgb_medium(sigma_a, {0, 0, 0}));
  Mean transmitted[3];
  for (uint32_t batch = 0; batch < 20; ++batch)
    add_escaped(walk(scene.get(), surface_entries(mesh, 200000, batch), without_roulette(batch * 200000u)),
                transmitted);
  for (int c = 0; c < 3; ++c) {
    double x = 2.0 * sigma_a[c];
    expect_transmitted(transmitted[c], 2 * (1 - (1 + x) * std::exp(-x)) / (x * x));
  }
}

// No statistics: of the walks that escape, each one's weight is that of the balance heuristic for its own length.
TEST(BeerLambert, EveryWeightIsThatOfItsOwnLength) {
  const double sigma[3] = {0.2, 1, 3};
  MeshData mesh = torus(1.0f, 0.4f, 48, 24);
  SceneHandle scene = make_scene(shared_context(), mesh, rgb_medium({0.2f, 1, 3}, {0, 0, 0}));
  Walked walked = walk(scene.get(), surface_entries(mesh, 100000, 1), without_roulette(0));
  size_t escaped = 0;
  for (const TynWalkExit &exit : walked.exits) {
    if (exit.status != TYN_WALK_ESCAPED) {
      ASSERT_EQ(exit.status, uint32_t(TYN_WALK_ABSORBED));
      ASSERT_EQ(exit.weight[0] + exit.weight[1] + exit.weight[2], 0);
      continue;
    }
    ++escaped;
    double factor[3], sum = 0;
    for (int c = 0; c < 3; ++c)
      sum += factor[c] = std::exp(-sigma[c] * exit.path_length);
    for (int c = 0; c < 3; ++c)
      ASSERT_NEAR(exit.weight[c], 3 * factor[c] / sum, 2e-6);
  }
  EXPECT_GT(escaped, 10000u);
}

// With a cap of one scattering the same walks end where they first collide, and what is cut is the albedo's part of it.
TEST(BeerLambert, ACapOfOneCutsWhatScatters) {
  MeshData mesh = icosphere(6);
  const double sigma_t = 0.5, albedo = 0.75, x = 2 * sigma_t;
  SceneHandle scene = make_scene(shared_context(), mesh, grey_medium(0.125f, 0.375f));
  TynWalkOptions options = without_roulette(0);
  options.max_scatterings = 1;
  Mean escaped[3];
  for (uint32_t batch = 0; batch < 10; ++batch) {
    options.first_path = batch * 200000u;
    Walked walked = walk(scene.get(), surface_entries(mesh, 200000, batch), options);
    add_escaped(walked, escaped);
    const TynLedger &ledger = walked.ledger;
    double collided = ledger.entered[0] - ledger.escaped[0];
    EXPECT_NEAR(ledger.capped[0], albedo * collided, 1e-6 * ledger.entered[0]);
    EXPECT_NEAR(ledger.absorbed[0], (1 - albedo) * collided, 1e-6 * ledger.entered[0]);
  }
  double exact = 2 * (1 - (1 + x) * std::exp(-x)) / (x * x);
  EXPECT_NEAR(escaped[0].mean(), exact, four_sigma * escaped[0].standard_error()); // N = 2e6; false-alarm rate 6e-5
}

} // namespace
