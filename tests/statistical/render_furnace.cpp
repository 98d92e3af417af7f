// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The white furnace: where nothing absorbs and the environment is 1 everywhere, every pixel is 1. Nothing may be gained or
// lost by an interface, a walk, a base, a lobe or a shading normal.
//
// 48 x 48 pixels, 8 samples: the pixels that the object fills must have mean 1 within 0.1 % and 3 standard errors. (Weights of
// a renderer without defects are exactly 1 here, so there is no chance of a false alarm but by rounding, for which 1e-5 is let
// pass.)
#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "common/render_scene.hpp"

namespace {

using namespace tyn_test;

struct Case {
  std::string name;
  MeshData mesh;
  TynMaterial material;
  TynMedium medium; // sigma_s[0] < 0: none
  uint32_t exit = TYN_EXIT_DIFFUSE;
  uint32_t max_bounces = 64;
};

class Furnace : public testing::TestWithParam<Case> {};

TEST_P(Furnace, IsOneEverywhere) {
  const Case &c = GetParam();
  Context context;
  Scene scene(context);
  uint32_t material = TYN_NONE, medium = TYN_NONE;
  ASSERT_EQ(tyn_scene_add_material(scene, &c.material, &material), TYN_OK) << scene.message();
  if (c.medium.sigma_s[0] >= 0) {
    ASSERT_EQ(tyn_scene_add_medium(scene, &c.medium, &medium), TYN_OK) << scene.message();
  }
  scene.add(c.mesh, medium, material);
  TynEnvironment environment = constant_environment(1);
  environment.hidden_from_camera = 1; // so that only light that met the object is seen
  ASSERT_EQ(tyn_scene_set_environment(scene, &environment), TYN_OK);
  scene.commit();

  TynCamera camera = tyn_camera();
  ASSERT_EQ(tyn_scene_frame(scene, 1, &camera), TYN_OK);
  TynRenderOptions options = film_options(48, 48, camera);
  options.exit = c.exit;
  options.max_bounces = c.max_bounces;
  options.seed = 20;
  Render render(scene, options);
  render.run(8);

  const std::vector<float> beauty = render.layer(TYN_LAYER_BEAUTY), variance = render.layer(TYN_LAYER_VARIANCE);
  for (size_t channel = 0; channel < 3; channel++) {
    double sum = 0, spread = 0, filled = 0;
    for (size_t i = 0; i < beauty.size() / 4; i++) {
      if (beauty[4 * i + 3] != 1)
        continue;
      sum += double(beauty[4 * i + channel]);
      spread += double(variance[3 * i + channel]);
      filled++;
    }
    ASSERT_GT(filled, 100);
    const double mean = sum / filled, standard_error = std::sqrt(spread) / filled;
    EXPECT_NEAR(mean, 1, 1e-3);
    EXPECT_NEAR(mean, 1, 3 * standard_error + 1e-5);
  }
  const TynRenderStats stats = render.stats();
  EXPECT_EQ(stats.nonfinite_paths, 0u);
  EXPECT_EQ(stats.ledger.escaped_walks, stats.ledger.walks);
  if (medium != TYN_NONE) {
    EXPECT_GT(stats.ledger.walks, 1000u);
  }
}

TynMedium no_medium() {
  TynMedium medium = tyn_medium();
  medium.sigma_s[0] = -1;
  return medium;
}

TynMedium white_medium(float sigma_s, float g, float ior) {
  TynMedium medium = tyn_medium();
  std::fill(medium.sigma_s, medium.sigma_s + 3, sigma_s);
  medium.g = g;
  medium.ior = ior;
  return medium;
}

TynMaterial interior(float ior, float roughness) {
  TynMaterial material = tyn_material();
  material.ior = ior;
  material.roughness = roughness;
  material.transmission = 1;
  return material;
}

// g = -0.5, 0, 0.8; ior 1, 1.4 smooth and rough; dense (mean free path 1/30 of the radius) and thin (10 radii).
std::vector<Case> media() {
  std::vector<Case> cases;
  const std::vector<NamedMesh> meshes = {
      {"Sphere", icosphere(3)}, {"Cube", cube()}, {"Torus", torus(1, 0.45f, 32, 16)}};
  struct Boundary {
    const char *name;
    float ior, roughness;
  };
  const Boundary boundaries[] = {{"Matched", 1, 0}, {"Smooth", 1.4f, 0}, {"Rough", 1.4f, 0.6f}};
  size_t turn = 0;
  for (const float g : {-0.5f, 0.0f, 0.8f})
    for (const Boundary &boundary : boundaries)
      for (const bool dense : {true, false})
        for (const uint32_t exit : {TYN_EXIT_DIFFUSE, TYN_EXIT_DIELECTRIC}) {
          const NamedMesh &mesh = meshes[turn++ % meshes.size()];
          Case c;
          c.name = mesh.name +
                   (g < 0   ? "Backward"
                    : g > 0 ? "Forward"
                            : "Isotropic") +
                   boundary.name + (dense ? "Dense" : "Thin") +
                   (exit == TYN_EXIT_DIFFUSE ? "DiffuseExit" : "DielectricExit");
          c.mesh = mesh.mesh;
          c.material = interior(boundary.ior, boundary.roughness);
          c.medium = white_medium(dense ? 30.0f : 0.1f, g, boundary.ior);
          c.exit = exit;
          cases.push_back(c);
        }
  return cases;
}

// The same sigma_t in no two channels: weights differ from 1 and average to it.
Case coloured_medium() {
  Case c{"SphereColoured", icosphere(3), interior(1.4f, 0.3f), white_medium(2, 0, 1.4f)};
  c.medium.sigma_s[0] = 4;
  c.medium.sigma_s[2] = 1;
  return c;
}

std::vector<Case> surfaces() {
  std::vector<Case> cases;
  for (const float roughness : {0.0f, 0.3f, 1.0f}) {
    const std::string suffix = roughness == 0 ? "Smooth" : roughness < 1 ? "Glossy" : "Rough";
    TynMaterial material = tyn_material();
    material.roughness = roughness;
    cases.push_back({"Dielectric" + suffix, torus(1, 0.45f, 24, 12), material, no_medium()});
    material.metallic = 1;
    cases.push_back({"Metal" + suffix, torus(1, 0.45f, 24, 12), material, no_medium()});
    material.metallic = 0.5f;
    material.transmission = 0.5f;
    cases.push_back({"Mixed" + suffix, icosphere(2), material, white_medium(1, 0.5f, 1.5f)});
    material.metallic = 0;
    material.transmission = 0.7f;
    material.thin_walled = 1;
    material.thin_scatter = 0.5f;
    material.thin_scatter_anisotropy = 0.3f;
    // light goes in and out of a thin-walled body many times
    cases.push_back({"ThinWall" + suffix, icosphere(2), material, no_medium(), TYN_EXIT_DIFFUSE, 1000});
  }
  // vertex normals of a cube are far from its faces' normals
  MeshData round_cube = cube();
  round_cube.normals.clear();
  for (const float p : round_cube.positions)
    round_cube.normals.push_back(p / std::sqrt(3.0f));
  cases.push_back({"MatteCubeWithRoundNormals", round_cube, matte(1), no_medium()});
  TynMaterial glossy = tyn_material();
  glossy.roughness = 0.4f;
  cases.push_back({"GlossyCubeWithRoundNormals", round_cube, glossy, no_medium()});
  cases.push_back({"InteriorOfCubeWithRoundNormals", round_cube, interior(1.4f, 0.4f), white_medium(3, 0, 1.4f)});
  return cases;
}

std::string name_of(const testing::TestParamInfo<Case> &info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(OfMedia, Furnace, testing::ValuesIn(media()), name_of);
INSTANTIATE_TEST_SUITE_P(OfSurfaces, Furnace, testing::ValuesIn(surfaces()), name_of);

// 48 x 48 pixels, 64 samples; three channels, 3 standard errors: a right program fails with chance 0.8 %.
TEST(FurnaceOfColouredMedium, IsOneOnAverage) {
  const Case c = coloured_medium();
  Context context;
  Scene scene(context);
  uint32_t material = TYN_NONE, medium = TYN_NONE;
  ASSERT_EQ(tyn_scene_add_material(scene, &c.material, &material), TYN_OK);
  ASSERT_EQ(tyn_scene_add_medium(scene, &c.medium, &medium), TYN_OK);
  scene.add(c.mesh, medium, material);
  const TynEnvironment environment = constant_environment(1);
  ASSERT_EQ(tyn_scene_set_environment(scene, &environment), TYN_OK);
  scene.commit();
  TynCamera camera = tyn_camera();
  ASSERT_EQ(tyn_scene_frame(scene, 1, &camera), TYN_OK);
  Render render(scene, film_options(48, 48, camera));
  render.run(64);
  for (uint32_t channel = 0; channel < 3; channel++) {
    const Estimate found = render.mean(channel);
    EXPECT_LT(found.standard_error, 2e-3);
    EXPECT_NEAR(found.mean, 1, 3 * found.standard_error) << "channel " << channel;
  }
}

} // namespace
