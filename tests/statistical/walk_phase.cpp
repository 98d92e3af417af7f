// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Walks in media whose phase function is not Henyey-Greenstein's: one scattering follows the density, and many keep the mean
// path length 4 V / S of light that enters evenly, which no phase function may change (Blanco & Fournier 2003).
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "common/phases.hpp"
#include "common/statistics.hpp"
#include "common/walk_scene.hpp"

namespace {

using namespace tyn_test;

class WalkPhaseFunction : public testing::TestWithParam<PhaseCase> {
protected:
  const tyn::OwnedPhase phase = GetParam().make();

  TynMedium medium(float sigma_s) const {
    TynMedium result = grey_medium(0, sigma_s);
    result.phase = &phase.get();
    return result;
  }
};

// Walks that end with their first scattering, from the middle of a cube a hundred mean free paths wide. N = 2e5 in 100 bins, or
// fewer where a float direction cannot tell them apart; false-alarm rate 1e-4 each.
TEST_P(WalkPhaseFunction, IsFollowedByOneScattering) {
  SceneHandle scene = make_scene(shared_context(), cube(), medium(100));
  TynWalkEntry entry = plain_entry(TYN_ENTRY_INSIDE);
  entry.direction[0] = 0.48f, entry.direction[1] = -0.64f, entry.direction[2] = 0.6f;
  TynWalkOptions options = tyn_walk_options();
  options.max_scatterings = 1;
  std::vector<double> cosines;
  for (const TynWalkExit &exit : walk(scene.get(), std::vector<TynWalkEntry>(200000, entry), options).exits) {
    ASSERT_EQ(exit.status, uint32_t(TYN_WALK_CAPPED));
    double dot = 0, square = 0; // 1 - cos from the difference of the directions, which keeps small angles
    for (int k = 0; k < 3; k++) {
      const double difference = double(exit.direction[k]) - double(entry.direction[k]);
      square += difference * difference;
      dot += double(exit.direction[k]) * double(entry.direction[k]);
    }
    cosines.push_back(dot > 0 ? 1 - 0.5 * square : std::max(-1.0, dot));
  }
  PhaseBins bins(phase.get(), 100);
  for (size_t i = 0; i + 1 < bins.shares.size();) // directions are rounded by 1e-7: angles below 1e-4 go together
    if (1 - bins.edges[i + 1] < 1e-8) {
      bins.shares[i] += bins.shares[i + 1];
      bins.shares.erase(bins.shares.begin() + long(i) + 1);
      bins.edges.erase(bins.edges.begin() + long(i) + 1);
    } else {
      i++;
    }
  EXPECT_GT(bins.test(cosines), 1e-4);
}

// N = 4e5; four standard errors, false-alarm rate 6e-5 each.
TEST_P(WalkPhaseFunction, KeepsTheMeanPathLength) {
  const MeshData mesh = icosphere(3);
  SceneHandle scene = make_scene(shared_context(), mesh, medium(2));
  const TynMeshInfo info = mesh_info(scene.get());
  const double exact = 4 * info.volume / info.area;
  TynWalkOptions options = tyn_walk_options();
  options.seed = 2;
  Walked walked = walk(scene.get(), surface_entries(mesh, 400000, 3), options);
  EXPECT_EQ(walked.ledger.escaped_walks, 400000u);
  Mean mean;
  for (const TynWalkExit &exit : walked.exits)
    mean.add(exit.path_length);
  EXPECT_NEAR(mean.mean(), exact, four_sigma * mean.standard_error());
  printf("4V/S = %.5f, mean path %.5f, %+.3f %% +- %.3f %%\n", exact, mean.mean(), 100 * (mean.mean() / exact - 1),
         100 * mean.standard_error() / exact);
}

INSTANTIATE_TEST_SUITE_P(OfAllKinds, WalkPhaseFunction, testing::ValuesIn(phase_cases()),
                         [](const auto &parameter) { return parameter.param.name; });

} // namespace
