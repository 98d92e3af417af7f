// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Walks in meshes that are not as they should be, with mean free paths from a millionth of their size to a million times it: each
// one ends, its energy is in the ledger, and no surface that is closed leaks.
#include <cmath>

#include <gtest/gtest.h>

#include "common/walk_scene.hpp"

namespace {

using namespace tyn_test;

const size_t walks = 800;

class HostileMesh : public testing::TestWithParam<NamedMesh> {
protected:
  bool is(const char *name) const { return GetParam().name == name; }
};

// Neighbours have mean free paths that are 1e-6, 1e-3, 1 and 1e6 of the longest side, and albedos of 0.8 to 0.99.
std::vector<TynWalkEntry> entries_of_all_densities(const MeshData &mesh, float side) {
  std::vector<TynWalkEntry> entries = surface_entries(mesh, walks, 81);
  for (size_t i = 0; i < walks; ++i) {
    const float mean_free_paths[4] = {1e-6f, 1e-3f, 1, 1e6f};
    for (int c = 0; c < 3; ++c) {
      entries[i].sigma_t[c] = float(1 + c) / (mean_free_paths[i % 4] * side);
      entries[i].albedo[c] = c == 0 ? 0.99f : c == 1 ? 0.95f : 0.8f;
    }
  }
  return entries;
}

// Of a needle whose tips are narrower than the steps between floats at that distance from the origin, a few in a hundred walks
// start outside by their rounding, and leak. Between faces that lie on one another with a boundary, light is reflected from the
// one onto the other's back until it counts as trapped.
TEST_P(HostileMesh, EveryWalkEndsAndIsAccountedFor) {
  const MeshData &mesh = GetParam().mesh;
  TynWalkOptions options = tyn_walk_options();
  options.max_scatterings = 2000; // where nothing absorbs enough, the shortest flights would go on for hours
  for (float ior : {1.0f, 1.4f}) {
    SCOPED_TRACE(ior);
    SceneHandle scene = make_scene(shared_context(), mesh, grey_medium(0, 1, 0.5f, ior));
    const TynMeshInfo info = mesh_info(scene.get());
    float side = 0;
    for (int k = 0; k < 3; ++k)
      side = std::max(side, info.upper[k] - info.lower[k]);
    const Walked walked = walk(scene.get(), entries_of_all_densities(mesh, side), options);
    const TynLedger &ledger = walked.ledger;
    for (int c = 0; c < 3; ++c) {
      EXPECT_EQ(ledger.entered[c], walks);
      EXPECT_NEAR(accounted(ledger, c), ledger.entered[c], 1e-6 * ledger.entered[c]);
      EXPECT_EQ(ledger.lost[c], 0);
    }
    EXPECT_EQ(ledger.escaped_walks + ledger.absorbed_walks + ledger.capped_walks + ledger.leaked_walks, walks);
    EXPECT_GT(ledger.escaped_walks, walks / 2);
    EXPECT_LE(ledger.leaked_walks, is("a needle") ? walks / 20 : 0);
    for (const TynWalkExit &exit : walked.exits)
      for (int k = 0; k < 3; ++k) {
        ASSERT_GE(exit.position[k], info.lower[k] - 1e-5f * side);
        ASSERT_LE(exit.position[k], info.upper[k] + 1e-5f * side);
      }
  }
}

INSTANTIATE_TEST_SUITE_P(Of, HostileMesh, testing::ValuesIn(hostile_meshes()),
                         [](const auto &test) { return test_name(test.param); });

} // namespace
