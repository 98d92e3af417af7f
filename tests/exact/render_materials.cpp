// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// What surfaces do with light, against closed forms; and that the layers add up.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "common/render_scene.hpp"
#include "common/statistics.hpp"
#include "render/fresnel.hpp"

namespace {

using namespace tyn_test;

const double pi = 3.14159265358979324;

double fresnel(double cosine, double n) {
  const double inside = std::sqrt(1 - (1 - cosine * cosine) / (n * n));
  const double s = (cosine - n * inside) / (cosine + n * inside), p = (n * cosine - inside) / (n * cosine + inside);
  return (s * s + p * p) / 2;
}

// Diffuse reflectance of a smooth dielectric from outside (Walsh 1926; as given by Duntley 1942).
double diffuse_fresnel(double n) {
  const double n2 = n * n, n3 = n2 * n, n4 = n2 * n2;
  return 0.5 + (n - 1) * (3 * n + 1) / (6 * (n + 1) * (n + 1)) +
         n2 * (n2 - 1) * (n2 - 1) / std::pow(n2 + 1, 3) * std::log((n - 1) / (n + 1)) -
         2 * n3 * (n2 + 2 * n - 1) / ((n2 + 1) * (n4 - 1)) +
         8 * n4 * (n4 + 1) / ((n2 + 1) * (n4 - 1) * (n4 - 1)) * std::log(n);
}

TEST(MeanTransmittance, FollowsTheClosedForm) {
  for (const double n : {1.05, 1.3, 1.5, 2.0, 4.0})
    EXPECT_NEAR(tyn::mean_transmittance(n), 1 - diffuse_fresnel(n), 1e-7) << n;
  EXPECT_EQ(tyn::mean_transmittance(1), 1);
  EXPECT_NEAR(tyn::mean_transmittance(1.0001), 1, 1e-4);
}

double mean_alpha(const Render &render) {
  const std::vector<float> beauty = render.layer(TYN_LAYER_BEAUTY);
  double sum = 0;
  for (size_t i = 3; i < beauty.size(); i += 4)
    sum += double(beauty[i]);
  return sum / double(beauty.size() / 4);
}

// Looks down at the origin along a direction that makes `angle` with the vertical, within the plane z = 0.
TynCamera tilted(double angle) {
  return look_at_flat({3 * std::sin(angle), 3 * std::cos(angle), 0}, {0, 0, 0}, {0, 0, -1}, 1e-4);
}

class Plane : public testing::Test {
protected:
  Context context;
  Scene scene{context};
  TynMaterial material = tyn_material();
  TynMedium medium = tyn_medium();
  uint32_t exit = TYN_EXIT_DIFFUSE;

  void light_environment(float radiance) {
    const TynEnvironment environment = constant_environment(radiance);
    ASSERT_EQ(tyn_scene_set_environment(scene, &environment), TYN_OK);
  }
  uint32_t add_material() {
    uint32_t index = TYN_NONE;
    EXPECT_EQ(tyn_scene_add_material(scene, &material, &index), TYN_OK) << scene.message();
    return index;
  }
  uint32_t add_medium() {
    uint32_t index = TYN_NONE;
    EXPECT_EQ(tyn_scene_add_medium(scene, &medium, &index), TYN_OK) << scene.message();
    return index;
  }
  Estimate radiance(double angle, uint32_t samples, uint32_t size = 8) {
    scene.commit();
    TynRenderOptions options = film_options(size, size, tilted(angle));
    options.exit = exit;
    Render render(scene, options);
    render.run(samples);
    return render.mean();
  }
};

// BRDF of a smooth coat over a diffuse base: a (1 - F(view)) (1 - F(light)) / (pi c). Statistical in the choice between
// reflection and base: 64 pixels x 4096 samples, 4 standard errors, false alarm 6e-5.
TEST_F(Plane, OfCoatedBaseFollowsTheClosedForm) {
  material.roughness = 0;
  material.ior = 1.6f;
  std::fill(material.base_color, material.base_color + 3, 0.7f);
  scene.add(quad(10), TYN_NONE, add_material());
  TynLight light = tyn_light();
  light.type = TYN_LIGHT_DIRECTIONAL;
  light.direction[0] = 0;
  light.direction[1] = -0.6f;
  light.direction[2] = -0.8f;
  ASSERT_EQ(tyn_scene_add_light(scene, &light, nullptr), TYN_OK);
  const double expected =
      0.7 * (1 - fresnel(std::cos(1.1), 1.6)) * (1 - fresnel(0.6, 1.6)) / (pi * (1 - diffuse_fresnel(1.6))) * 0.6;
  const Estimate found = radiance(1.1, 4096);
  EXPECT_LT(found.standard_error, 0.002 * expected);
  EXPECT_NEAR(found.mean, expected, four_sigma * found.standard_error);
}

TEST_F(Plane, OfSmoothMetalIsAMirrorWithSchlicksReflectance) {
  material.roughness = 0;
  material.metallic = 1;
  material.base_color[0] = 0.6f;
  scene.add(quad(10), TYN_NONE, add_material());
  light_environment(3);
  const double angle = 1.2, expected = 3 * (0.6 + 0.4 * std::pow(1 - std::cos(angle), 5));
  EXPECT_NEAR(radiance(angle, 1).mean, expected, 1e-5 * expected);
}

// Of a thin wall the fraction F is reflected, the rest passes, tinted. Both see the same environment.
TEST_F(Plane, OfThinWallTintsWhatPasses) {
  material.roughness = 0;
  material.thin_walled = 1;
  material.transmission = 1;
  material.base_color[0] = 0.4f;
  scene.add(quad(10), TYN_NONE, add_material());
  light_environment(1);
  const double f = fresnel(std::cos(1.3), 1.5), expected = f + (1 - f) * 0.4;
  const Estimate found = radiance(1.3, 1024);
  EXPECT_NEAR(found.mean, expected, four_sigma * found.standard_error);
}

// A thin wall that scatters everything: (1 + g) / 2 of it comes out on the other side.
TEST_F(Plane, OfScatteringThinWallIsLitFromBehind) {
  material.ior = 1;
  material.thin_walled = 1;
  material.transmission = 1;
  material.thin_scatter = 1;
  material.thin_scatter_color[0] = 0.5f;
  material.thin_scatter_anisotropy = 0.6f;
  scene.add(quad(10), TYN_NONE, add_material());
  TynLight light = tyn_light();
  light.type = TYN_LIGHT_DIRECTIONAL;
  light.direction[0] = 0;
  light.direction[1] = 1; // upwards: onto the side that is not seen
  light.direction[2] = 0;
  ASSERT_EQ(tyn_scene_add_light(scene, &light, nullptr), TYN_OK);
  const double expected = 0.8 * 0.5 / pi;
  const Estimate found = radiance(0.5, 1024);
  EXPECT_NEAR(found.mean, expected, four_sigma * found.standard_error);
}

TEST_F(Plane, EmitsOnItsOutsideOnlyUnlessDoubleSided) {
  material.emission[0] = 4;
  scene.add(quad(10), TYN_NONE, add_material());
  material.double_sided = 1;
  scene.add(translated(quad(10), 0, -10, 0), TYN_NONE, add_material());
  scene.commit();
  const auto seen = [&](double from, double to) {
    Render render(scene, film_options(1, 1, look_at_flat({0, from, 0}, {0, to, 0}, {0, 0, -1}, 1e-4)));
    render.run(4);
    return render.layer(TYN_LAYER_EMISSION)[0];
  };
  EXPECT_EQ(seen(3, 0), 4);
  EXPECT_EQ(seen(-3, 0), 0);
  EXPECT_EQ(seen(-20, -10), 4);
}

// Light along the normal through an absorbing box: exp(-sigma_a d). 64 pixels x 512 samples.
TEST_F(Plane, OfAbsorbingBoxFollowsBeerAndLambert) {
  material.ior = 1;
  material.transmission = 1;
  std::fill(medium.sigma_a, medium.sigma_a + 3, 0.8f);
  scene.add(box(4, 1.5f, 4), add_medium(), add_material());
  light_environment(1);
  for (const uint32_t mode : {TYN_EXIT_DIELECTRIC, TYN_EXIT_DIFFUSE}) {
    if (!scene->committed)
      scene.commit();
    TynRenderOptions options = film_options(8, 8, tilted(0));
    options.exit = mode;
    Render render(scene, options);
    render.run(512);
    const Estimate found = render.mean();
    EXPECT_LT(found.standard_error, 0.01);
    EXPECT_NEAR(found.mean, std::exp(-0.8 * 1.5), four_sigma * found.standard_error);
  }
}

// A camera inside a clear medium sees out, as in front of it.
TEST_F(Plane, OfClearBoxIsSeenThroughFromInside) {
  material.ior = 1;
  material.transmission = 1;
  scene.add(box(20, 20, 20), add_medium(), add_material());
  light_environment(2);
  exit = TYN_EXIT_DIELECTRIC;
  EXPECT_NEAR(radiance(0, 1).mean, 2, 1e-6);
}

// A clear index-matched ball does not bend light: an environment image is seen through it as without it.
TEST_F(Plane, OfClearBallShowsTheSkyBehindIt) {
  material.ior = 1;
  material.transmission = 1;
  scene.add(icosphere(2), add_medium(), add_material());
  std::vector<float> pixels(4 * 8 * 4, 0.0f);
  for (size_t i = 0; i < 32; i++)
    pixels[4 * i] = float(i % 8) + 1;
  TynImage image = tyn_image();
  image.width = 8;
  image.height = 4;
  image.format = TYN_IMAGE_RGBA32F;
  image.pixels = pixels.data();
  TynEnvironment environment = constant_environment(1);
  ASSERT_EQ(tyn_scene_add_image(scene, &image, &environment.image), TYN_OK);
  ASSERT_EQ(tyn_scene_set_environment(scene, &environment), TYN_OK);
  scene.commit();
  TynRenderOptions options = film_options(1, 1, look_at({0, 0, 5}, {0.2, 0, 0}, {0, 1, 0}, 1e-4));
  options.exit = TYN_EXIT_DIELECTRIC;
  Render through(scene, options);
  through.run(4);
  // u = 1/2 + atan2(x, -z) / 2 pi; columns are interpolated
  const double column = 8 * (0.5 + std::atan2(0.2, 5.0) / (2 * pi)) - 0.5 + 1;
  EXPECT_NEAR(through.layer(TYN_LAYER_BEAUTY)[0], column, 1e-3);
  EXPECT_NEAR(through.layer(TYN_LAYER_SUBSURFACE)[0], column, 1e-3);
}

// A dense index-matched ball under an even sky: averaged over its disc, which is over cosine-distributed views, it shows the
// multiple-scattering colour that was asked for, as well as the fit of Kulla & Conty is: within 0.01. 1024 pixels x 64 samples.
TEST_F(Plane, OfDenseBallShowsItsMultipleScatteringColour) {
  material.ior = 1;
  material.transmission = 1;
  material.multiscatter_color[0] = 0.8f;
  material.multiscatter_color[1] = 0.5f;
  material.multiscatter_color[2] = 0.2f;
  std::fill(medium.sigma_a, medium.sigma_a + 3, 100.0f);
  scene.add(icosphere(4), add_medium(), add_material());
  light_environment(1);
  TynEnvironment environment = constant_environment(1);
  environment.hidden_from_camera = 1;
  ASSERT_EQ(tyn_scene_set_environment(scene, &environment), TYN_OK);
  scene.commit();
  Render render(scene, film_options(32, 32, look_at_flat({0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 1.05)));
  render.run(64);
  const double covered = mean_alpha(render);
  for (uint32_t c = 0; c < 3; c++) {
    const Estimate found = render.mean(c);
    EXPECT_NEAR(found.mean / covered, material.multiscatter_color[c], 0.01 + four_sigma * found.standard_error);
    EXPECT_NEAR(render.layer(TYN_LAYER_ALBEDO)[3 * (16 * 32 + 16) + c], material.multiscatter_color[c], 1e-6);
  }
}

// Directions of a point light are never met by a sampled direction: both ways of leaving use the diffuse lobe.
TEST_F(Plane, OfWaxIsLitByAPointLightAlikeInBothExitModes) {
  material.ior = 1.4f;
  material.roughness = 0;
  material.transmission = 1;
  medium.ior = 1.4f;
  std::fill(medium.sigma_s, medium.sigma_s + 3, 10.0f);
  scene.add(icosphere(3), add_medium(), add_material());
  TynLight light = tyn_light();
  light.position[1] = 4;
  ASSERT_EQ(tyn_scene_add_light(scene, &light, nullptr), TYN_OK);
  scene.commit();
  std::vector<float> images[2];
  for (const uint32_t mode : {TYN_EXIT_DIFFUSE, TYN_EXIT_DIELECTRIC}) {
    TynRenderOptions options = film_options(8, 8, look_at({0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 0.4));
    options.exit = mode;
    Render render(scene, options);
    render.run(4);
    images[mode] = render.layer(TYN_LAYER_SUBSURFACE);
  }
  EXPECT_GT(*std::max_element(images[0].begin(), images[0].end()), 0);
  EXPECT_EQ(images[0], images[1]);
}

TEST_F(Plane, LayersSumToBeautyInEveryPixel) {
  TynMaterial wax = tyn_material();
  wax.transmission = 0.6f;
  wax.metallic = 0.2f;
  wax.roughness = 0.4f;
  wax.emission[1] = 0.1f;
  material = wax;
  std::fill(medium.sigma_s, medium.sigma_s + 3, 5.0f);
  medium.ior = 1.5f;
  scene.add(icosphere(2), add_medium(), add_material());
  light_environment(0.5f);
  TynLight light = tyn_light();
  light.position[0] = 4;
  ASSERT_EQ(tyn_scene_add_light(scene, &light, nullptr), TYN_OK);
  scene.commit();
  Render render(scene, film_options(16, 16, look_at({0, 0, 4}, {0, 0, 0}, {0, 1, 0}, 0.6)));
  render.run(64);
  const std::vector<float> beauty = render.layer(TYN_LAYER_BEAUTY);
  std::vector<double> sum(16 * 16 * 3);
  for (const uint32_t part : {TYN_LAYER_SUBSURFACE, TYN_LAYER_SPECULAR, TYN_LAYER_DIFFUSE, TYN_LAYER_EMISSION}) {
    const std::vector<float> pixels = render.layer(part);
    EXPECT_GT(*std::max_element(pixels.begin(), pixels.end()), 0) << tyn_layer_name(part);
    for (size_t i = 0; i < sum.size(); i++)
      sum[i] += double(pixels[i]);
  }
  for (size_t i = 0; i < sum.size(); i++)
    EXPECT_NEAR(sum[i], beauty[i / 3 * 4 + i % 3], 1e-5 * (1 + sum[i]));
}

} // namespace
