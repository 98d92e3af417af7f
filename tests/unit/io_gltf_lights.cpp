// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// KHR_lights_punctual and cameras.
#ifdef TYN_TEST_IO
#include <cmath>

#include <gtest/gtest.h>

#include "common/gltf_builder.hpp"

using tyn_test::Gltf;
using tyn_test::load;
using tyn_test::Loading;

namespace {

// A light on a node that is moved to (1, 2, 3) and looks along +x (its -z turned by a quarter about y).
Gltf with_light(const nlohmann::json &light) {
  Gltf model = Gltf::tetrahedron();
  model.json["extensions"]["KHR_lights_punctual"]["lights"] = {light};
  model.json["nodes"].push_back({{"translation", {1, 2, 3}},
                                 {"rotation", {0, -std::sqrt(0.5), 0, std::sqrt(0.5)}},
                                 {"scale", {3, 3, 3}},
                                 {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
  model.json["scenes"][0]["nodes"].push_back(1);
  return model;
}

Gltf with_camera(const nlohmann::json &camera) {
  Gltf model = Gltf::tetrahedron();
  model.json["cameras"] = {camera};
  model.json["nodes"].push_back({{"translation", {1, 2, 3}}, {"camera", 0}, {"scale", {2, 2, 2}}});
  model.json["scenes"][0]["nodes"].push_back(1);
  return model;
}

TynLight only_light(const Loading &loading) {
  EXPECT_EQ(loading.status, TYN_OK) << loading.message;
  EXPECT_EQ(loading.scene.lights.size(), 1u);
  return loading.scene.lights.empty() ? tyn_light() : loading.scene.lights[0].value;
}

TynCamera only_camera(const Loading &loading) {
  EXPECT_EQ(loading.status, TYN_OK) << loading.message;
  EXPECT_EQ(loading.scene.cameras.size(), 1u);
  return loading.scene.cameras.empty() ? tyn_camera() : loading.scene.cameras[0].value;
}

} // namespace

TEST(GltfLights, PointLightKeepsItsIntensityAndStandsWhereItsNodeIs) {
  const Loading loading =
      load(with_light({{"type", "point"}, {"name", "lamp"}, {"color", {1, 0.5, 0.25}}, {"intensity", 8}}));
  const TynLight light = only_light(loading);
  EXPECT_EQ(light.type, uint32_t(TYN_LIGHT_POINT));
  EXPECT_FLOAT_EQ(light.intensity[0], 8);
  EXPECT_FLOAT_EQ(light.intensity[2], 2);
  EXPECT_FLOAT_EQ(light.position[2], 3);
  EXPECT_EQ(loading.scene.lights[0].name, "lamp");
}

TEST(GltfLights, SpotAndDirectionalLightsShineAlongMinusZOfTheirNode) {
  const TynLight spot =
      only_light(load(with_light({{"type", "spot"}, {"spot", {{"innerConeAngle", 0.2}, {"outerConeAngle", 0.4}}}})));
  EXPECT_EQ(spot.type, uint32_t(TYN_LIGHT_SPOT));
  EXPECT_NEAR(spot.direction[0], 1, 1e-6);
  EXPECT_NEAR(spot.direction[2], 0, 1e-6);
  EXPECT_FLOAT_EQ(spot.inner_cone, 0.2f);
  EXPECT_FLOAT_EQ(spot.outer_cone, 0.4f);
  const TynLight sun = only_light(load(with_light({{"type", "directional"}, {"intensity", 3}})));
  EXPECT_EQ(sun.type, uint32_t(TYN_LIGHT_DIRECTIONAL));
  EXPECT_NEAR(sun.direction[0], 1, 1e-6);
  EXPECT_FLOAT_EQ(sun.intensity[1], 3);
}

TEST(GltfLights, SpotWithASharpEdgeIsValid) {
  const TynLight light =
      only_light(load(with_light({{"type", "spot"}, {"spot", {{"innerConeAngle", 0.4}, {"outerConeAngle", 0.4}}}})));
  EXPECT_LT(light.inner_cone, light.outer_cone);
}

TEST(GltfLights, AreLeftOutIfAskedAndTheirRangeIsWarnedAbout) {
  Gltf model = with_light({{"type", "point"}, {"range", 5}});
  EXPECT_TRUE(load(model).warned("range"));
  TynGltfOptions options = tyn_gltf_options();
  options.skip_lights = 1;
  EXPECT_TRUE(load(model, options).scene.lights.empty());
}

TEST(GltfCameras, PerspectiveCameraIsPlacedWithoutTheScaleOfItsNode) {
  const TynCamera camera = only_camera(
      load(with_camera({{"type", "perspective"},
                        {"perspective", {{"yfov", 0.6}, {"aspectRatio", 1.5}, {"znear", 0.1}, {"zfar", 10}}}})));
  EXPECT_EQ(camera.type, uint32_t(TYN_CAMERA_PERSPECTIVE));
  EXPECT_FLOAT_EQ(camera.yfov, 0.6f);
  EXPECT_FLOAT_EQ(camera.aspect_ratio, 1.5f);
  EXPECT_FLOAT_EQ(camera.znear, 0.1f);
  const float expected[12] = {1, 0, 0, 1, 0, 1, 0, 2, 0, 0, 1, 3};
  for (int i = 0; i < 12; i++)
    EXPECT_NEAR(camera.world_from_camera[i], expected[i], 1e-6) << i;
}

TEST(GltfCameras, OrthographicCameraKeepsItsMagnifications) {
  const TynCamera camera = only_camera(load(with_camera(
      {{"type", "orthographic"}, {"orthographic", {{"xmag", 3}, {"ymag", 2}, {"znear", 0}, {"zfar", 10}}}})));
  EXPECT_EQ(camera.type, uint32_t(TYN_CAMERA_ORTHOGRAPHIC));
  EXPECT_FLOAT_EQ(camera.ymag, 2);
  EXPECT_FLOAT_EQ(camera.aspect_ratio, 1.5f);
}

TEST(GltfCameras, NameIsTheNodesThenTheCameras) {
  Gltf model =
      with_camera({{"type", "perspective"}, {"name", "portrait"}, {"perspective", {{"yfov", 1}, {"znear", 1}}}});
  EXPECT_EQ(load(model).scene.cameras[0].name, "portrait");
  model.json["nodes"][1]["name"] = "shot 1";
  EXPECT_EQ(load(model).scene.cameras[0].name, "shot 1");
}

TEST(GltfCameras, MirroredNodeStillGivesARotation) {
  Gltf model = with_camera({{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 1}}}});
  model.json["nodes"][1]["scale"] = {-1, 1, 1};
  const TynCamera camera = only_camera(load(model));
  const float *m = camera.world_from_camera;
  const float determinant =
      m[0] * (m[5] * m[10] - m[6] * m[9]) - m[1] * (m[4] * m[10] - m[6] * m[8]) + m[2] * (m[4] * m[9] - m[5] * m[8]);
  EXPECT_NEAR(determinant, 1, 1e-6);
}
#endif
