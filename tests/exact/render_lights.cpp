// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// A matte plane under one light, against the closed form of its irradiance. The camera sees a spot so small that every
// pixel shows the same point.
#include <cmath>

#include <gtest/gtest.h>

#include "common/render_scene.hpp"
#include "common/statistics.hpp"

namespace {

using namespace tyn_test;

const double pi = 3.14159265358979324;
const float albedo = 0.6f;

// Looks straight down at (x, 0, z); the view is 2e-4 high.
TynCamera above(double x, double z) { return look_at_flat({x, 3, z}, {x, 0, z}, {0, 0, -1}, 1e-4); }

class LitPlane : public testing::Test {
protected:
  Context context;
  Scene scene{context};

  void SetUp() override {
    uint32_t material = TYN_NONE;
    const TynMaterial diffuse = matte(albedo);
    ASSERT_EQ(tyn_scene_add_material(scene, &diffuse, &material), TYN_OK) << scene.message();
    scene.add(quad(10), TYN_NONE, material);
  }

  void add_light(const TynLight &light) {
    ASSERT_EQ(tyn_scene_add_light(scene, &light, nullptr), TYN_OK) << scene.message();
  }

  // Radiance of the plane at (x, 0, z).
  Estimate radiance_at(double x, double z, uint32_t samples) {
    scene.commit();
    Render render(scene, film_options(8, 8, above(x, z)));
    render.run(samples);
    return render.mean();
  }
};

TEST_F(LitPlane, ShowsTheIrradianceOfAPointLight) {
  TynLight light = tyn_light();
  light.position[0] = 1;
  light.position[1] = 2;
  light.position[2] = -0.5f;
  light.intensity[0] = 3;
  add_light(light);
  // at (0.25, 0, 0.5): d = (0.75, 2, -1)
  const double distance2 = 0.75 * 0.75 + 2 * 2 + 1;
  const double expected = albedo / pi * 3 * (2 / std::sqrt(distance2)) / distance2;
  EXPECT_NEAR(radiance_at(0.25, 0.5, 1).mean, expected, 1e-3 * expected);
}

TEST_F(LitPlane, ShowsTheIrradianceOfADirectionalLight) {
  TynLight light = tyn_light();
  light.type = TYN_LIGHT_DIRECTIONAL;
  light.direction[0] = 0.6f;
  light.direction[1] = -0.8f;
  light.direction[2] = 0;
  light.intensity[0] = 2;
  add_light(light);
  EXPECT_NEAR(radiance_at(0.25, 0.5, 1).mean, albedo / pi * 2 * 0.8, 1e-6);
}

// The falloff of KHR_lights_punctual: ((cos - cos outer) / (cos inner - cos outer))^2 between the cones.
TEST_F(LitPlane, ShowsTheFalloffOfASpotLight) {
  TynLight light = tyn_light();
  light.type = TYN_LIGHT_SPOT;
  light.position[1] = 2;
  light.direction[1] = -1;
  light.direction[2] = 0;
  light.inner_cone = 0.3f;
  light.outer_cone = 0.7f;
  add_light(light);
  const double angle = 0.5, x = 2 * std::tan(angle), distance2 = 4 + x * x;
  const double fade = (std::cos(angle) - std::cos(0.7)) / (std::cos(0.3) - std::cos(0.7));
  const double expected = albedo / pi * fade * fade * std::cos(angle) / distance2;
  EXPECT_NEAR(radiance_at(x, 0, 1).mean, expected, 1e-3 * expected);
}

TEST_F(LitPlane, IsBlackOutsideASpotLightsCone) {
  TynLight light = tyn_light();
  light.type = TYN_LIGHT_SPOT;
  light.position[1] = 2;
  light.direction[1] = -1;
  light.direction[2] = 0;
  light.outer_cone = 0.7f;
  add_light(light);
  EXPECT_EQ(radiance_at(2 * std::tan(0.72), 0, 1).mean, 0);
}

// Lambert's formula for the irradiance of a uniform polygon: E = L / 2 sum of angle_i (n . g_i) over its edges.
double polygon_irradiance(const double (*corner)[3], int corners) {
  double sum = 0;
  for (int i = 0; i < corners; i++) {
    const double *a = corner[i], *b = corner[(i + 1) % corners];
    const double la = std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
    const double lb = std::sqrt(b[0] * b[0] + b[1] * b[1] + b[2] * b[2]);
    const double c[3] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    const double lc = std::sqrt(c[0] * c[0] + c[1] * c[1] + c[2] * c[2]);
    sum += std::acos((a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) / (la * lb)) * c[1] / lc;
  }
  return std::abs(sum) / 2;
}

// 64 x 4096 samples; two-sided, 4 standard errors: false alarm 6e-5.
TEST_F(LitPlane, ShowsTheIrradianceOfAnEmissiveSquare) {
  TynMaterial glowing = matte(0);
  glowing.emission[0] = 5;
  uint32_t material = TYN_NONE;
  ASSERT_EQ(tyn_scene_add_material(scene, &glowing, &material), TYN_OK);
  // faces down at height 1, from -0.5 to 0.5 in x, beside the camera's view
  MeshData square;
  square.add_vertex(-0.5, 1, -0.5);
  square.add_vertex(0.5, 1, -0.5);
  square.add_vertex(0.5, 1, 0.5);
  square.add_vertex(-0.5, 1, 0.5);
  square.add_triangle(0, 1, 2);
  square.add_triangle(0, 2, 3);
  scene.add(square, TYN_NONE, material);
  const double x = 0.9, z = 0.3;
  const double corners[4][3] = {
      {-0.5 - x, 1, -0.5 - z}, {0.5 - x, 1, -0.5 - z}, {0.5 - x, 1, 0.5 - z}, {-0.5 - x, 1, 0.5 - z}};
  const double expected = albedo / pi * 5 * polygon_irradiance(corners, 4);
  const Estimate found = radiance_at(x, z, 4096);
  EXPECT_LT(found.standard_error, 0.002 * expected);
  EXPECT_NEAR(found.mean, expected, four_sigma * found.standard_error);
}

TEST_F(LitPlane, IsDarkBehindAnOpaqueSquare) {
  TynLight light = tyn_light();
  light.position[1] = 2;
  add_light(light);
  uint32_t black = TYN_NONE;
  const TynMaterial material = matte(0);
  ASSERT_EQ(tyn_scene_add_material(scene, &material, &black), TYN_OK);
  // between the light and (1.2, 0, 0), not between that and the camera
  scene.add(translated(quad(1), 0.5f, 1, 0), TYN_NONE, black);
  EXPECT_EQ(radiance_at(1.2, 0, 1).mean, 0);
}

// The same for the light of a uniform environment, of which a horizontal plane sees half: E = pi L.
TEST_F(LitPlane, ReflectsItsColourOfAUniformEnvironment) {
  const TynEnvironment environment = constant_environment(2);
  ASSERT_EQ(tyn_scene_set_environment(scene, &environment), TYN_OK);
  EXPECT_NEAR(radiance_at(0.1, 0.2, 4).mean, 2 * albedo, 1e-6);
}

} // namespace
