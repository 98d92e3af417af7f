// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Light that enters a body evenly (uniform over the surface, cosine-distributed) and is not absorbed travels 4 V / S inside
// on average, whatever scatters it (Blanco & Fournier 2003). One number that geometry, rays, flights, phase function and
// boundaries must all be right for.
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "common/statistics.hpp"
#include "common/walk_scene.hpp"

namespace {

using namespace tyn_test;

// Reduced scattering coefficients, with as many paths as bring the standard error to about 0.04 %.
struct Density {
  float reduced_sigma_s; // sigma_s (1 - g)
  size_t paths;
};
const Density densities[] = {{0.2f, 1400000}, {0.7f, 2000000}, {2.0f, 3600000}};

Mean mean_path_length(TynScene *scene, const MeshData &mesh, size_t paths) {
  const size_t batch = 200000;
  Mean mean;
  for (size_t begin = 0; begin < paths; begin += batch) {
    TynWalkOptions options = tyn_walk_options();
    options.seed = 1;
    options.first_path = begin;
    Walked walked = walk(scene, surface_entries(mesh, batch, uint32_t(begin / batch)), options);
    EXPECT_EQ(walked.ledger.escaped_walks, batch);
    for (const TynWalkExit &exit : walked.exits)
      mean.add(exit.path_length);
  }
  return mean;
}

// False-alarm rate of the four standard errors: 6e-5 each. Of the 0.1 %, 2.5 standard errors: 1 % each; it is there because
// the size of the error is promised too.
void expect_four_v_over_s(const MeshData &mesh, float g, size_t times = 1) {
  for (const Density &density : densities) {
    SceneHandle scene = make_scene(shared_context(), mesh, grey_medium(0, density.reduced_sigma_s / (1 - g), g));
    TynMeshInfo info = mesh_info(scene.get());
    double exact = 4 * info.volume / info.area;
    Mean mean = mean_path_length(scene.get(), mesh, times * density.paths);
    EXPECT_LT(mean.standard_error(), 5e-4 * exact) << "too few paths for sigma_s' = " << density.reduced_sigma_s;
    EXPECT_NEAR(mean.mean(), exact, four_sigma * mean.standard_error()) << density.reduced_sigma_s;
    EXPECT_NEAR(mean.mean(), exact, 1e-3 * exact) << density.reduced_sigma_s;
    printf("sigma_s' = %.1f: 4V/S = %.5f, mean path %.5f, %+.3f %% +- %.3f %%\n", density.reduced_sigma_s, exact,
           mean.mean(), 100 * (mean.mean() / exact - 1), 100 * mean.standard_error() / exact);
  }
}

class MeanPathLength : public testing::TestWithParam<float> {};

// A cube's chords vary more than those of the other two: twice as many paths.
TEST_P(MeanPathLength, InASphereIs4VOverS) { expect_four_v_over_s(icosphere(3), GetParam()); }
TEST_P(MeanPathLength, InACubeIs4VOverS) { expect_four_v_over_s(cube(), GetParam(), 2); }
TEST_P(MeanPathLength, InATorusIs4VOverS) { expect_four_v_over_s(torus(1.0f, 0.4f, 48, 24), GetParam()); }

INSTANTIATE_TEST_SUITE_P(ForAllAnisotropies, MeanPathLength, testing::Values(-0.5f, 0.0f, 0.8f, 0.95f),
                         [](const auto &parameter) {
                           return std::string(parameter.param < 0 ? "GMinus" : "G") +
                                  std::to_string(int(std::lround(std::abs(parameter.param) * 100))) + "Hundredths";
                         });

} // namespace
