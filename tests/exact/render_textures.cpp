// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Textures as glTF 2.0 defines them, seen through the albedo and normal layers.
#include <cmath>

#include <gtest/gtest.h>

#include "common/render_scene.hpp"

namespace {

using namespace tyn_test;

// A plane of width 2 that shows an image of 2 x 2 pixels: red channel 0, 64 above, 128, 255 below.
class Texture : public testing::Test {
protected:
  Context context;
  Scene scene{context};
  TynMaterial material = matte(1);

  uint32_t add_image(uint32_t format) {
    const unsigned char pixels[16] = {0, 0, 0, 255, 64, 64, 64, 255, 128, 128, 128, 255, 255, 255, 255, 255};
    TynImage image = tyn_image();
    image.width = image.height = 2;
    image.format = format;
    image.pixels = pixels;
    uint32_t index = TYN_NONE;
    EXPECT_EQ(tyn_scene_add_image(scene, &image, &index), TYN_OK) << scene.message();
    return index;
  }
  // Value of a layer's first channel at texture coordinates (u, v).
  std::vector<float> at(double u, double v, uint32_t layer = TYN_LAYER_ALBEDO) {
    if (!scene->committed) {
      uint32_t index = TYN_NONE;
      EXPECT_EQ(tyn_scene_add_material(scene, &material, &index), TYN_OK) << scene.message();
      scene.add(quad(2), TYN_NONE, index);
      scene.commit();
    }
    // the plane's u runs along x, its v along z
    const double x = 2 * u - 1, z = 2 * v - 1;
    Render render(scene, film_options(1, 1, look_at_flat({x, 3, z}, {x, 0, z}, {0, 0, -1}, 1e-5)));
    render.run(1);
    return render.layer(layer);
  }
  float red(double u, double v) { return at(u, v)[0]; }
};

double srgb(int value) {
  const double c = value / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

TEST_F(Texture, NearestFilteringShowsThePixelsAsTheyAre) {
  material.base_color_texture.image = add_image(TYN_IMAGE_RGBA8_LINEAR);
  material.base_color_texture.filter = TYN_FILTER_NEAREST;
  EXPECT_NEAR(red(0.1, 0.1), 0, 1e-6);
  EXPECT_NEAR(red(0.9, 0.4), 64 / 255.0, 1e-6);
  EXPECT_NEAR(red(0.4, 0.6), 128 / 255.0, 1e-6);
  EXPECT_NEAR(red(0.6, 0.9), 1, 1e-6);
}

TEST_F(Texture, ColoursAreDecodedFromSrgb) {
  material.base_color_texture.image = add_image(TYN_IMAGE_RGBA8_SRGB);
  material.base_color_texture.filter = TYN_FILTER_NEAREST;
  EXPECT_NEAR(red(0.9, 0.4), srgb(64), 1e-6);
  EXPECT_NEAR(red(0.4, 0.6), srgb(128), 1e-6);
}

TEST_F(Texture, LinearFilteringInterpolatesBetweenTheCentresOfPixels) {
  material.base_color_texture.image = add_image(TYN_IMAGE_RGBA8_LINEAR);
  material.base_color_texture.wrap_u = material.base_color_texture.wrap_v = TYN_WRAP_CLAMP;
  EXPECT_NEAR(red(0.5, 0.25), 32 / 255.0, 1e-4);
  EXPECT_NEAR(red(0.25, 0.5), 64 / 255.0, 1e-4);
  EXPECT_NEAR(red(0.5, 0.5), (0 + 64 + 128 + 255) / 4.0 / 255, 1e-4);
  EXPECT_NEAR(red(0.05, 0.05), 0, 1e-4); // beyond the outermost centres: the edge
}

TEST_F(Texture, RepeatingInterpolatesAcrossTheEdge) {
  material.base_color_texture.image = add_image(TYN_IMAGE_RGBA8_LINEAR);
  EXPECT_NEAR(red(0.001, 0.25), 32 / 255.0, 2e-3); // halfway between the last column and the first
}

TEST_F(Texture, WrappingModesContinueTheImage) {
  material.base_color_texture.image = add_image(TYN_IMAGE_RGBA8_LINEAR);
  material.base_color_texture.filter = TYN_FILTER_NEAREST;
  // u' = 3 u - 1 shows columns -2 .. 3, v' = v
  material.base_color_texture.transform[0] = 3;
  material.base_color_texture.transform[2] = -1;
  material.base_color_texture.wrap_u = TYN_WRAP_MIRROR;
  const double left = 0, right = 64 / 255.0;
  const double mirrored[6] = {right, left, left, right, right, left};
  for (int i = 0; i < 6; i++)
    EXPECT_NEAR(red((i + 0.5) / 6, 0.25), mirrored[i], 1e-6) << i;
}

TEST_F(Texture, ClampingRepeatsTheEdge) {
  material.base_color_texture.image = add_image(TYN_IMAGE_RGBA8_LINEAR);
  material.base_color_texture.filter = TYN_FILTER_NEAREST;
  material.base_color_texture.transform[0] = 3;
  material.base_color_texture.transform[2] = -1;
  material.base_color_texture.wrap_u = TYN_WRAP_CLAMP;
  for (int i = 0; i < 6; i++)
    EXPECT_NEAR(red((i + 0.5) / 6, 0.25), i < 3 ? 0 : 64 / 255.0, 1e-6) << i;
}

TEST_F(Texture, TransformsMixBothCoordinates) {
  material.base_color_texture.image = add_image(TYN_IMAGE_RGBA8_LINEAR);
  material.base_color_texture.filter = TYN_FILTER_NEAREST;
  const float swapped[6] = {0, 1, 0, 1, 0, 0}; // u' = v, v' = u
  std::copy(swapped, swapped + 6, material.base_color_texture.transform);
  EXPECT_NEAR(red(0.9, 0.1), 128 / 255.0, 1e-6);
  EXPECT_NEAR(red(0.1, 0.9), 64 / 255.0, 1e-6);
}

TEST_F(Texture, MultipliesItsFactor) {
  material = matte(0.5f);
  material.base_color_texture.image = add_image(TYN_IMAGE_RGBA8_LINEAR);
  material.base_color_texture.filter = TYN_FILTER_NEAREST;
  EXPECT_NEAR(red(0.9, 0.9), 0.5, 1e-6);
}

// x along growing u, y against growing v (up in the image), z out of the surface. Here u runs along x and v along z.
TEST_F(Texture, NormalMapsBendTheNormal) {
  const unsigned char pixels[4] = {204, 166, 230, 255}; // about (0.6, 0.3, 0.8)
  TynImage image = tyn_image();
  image.width = image.height = 1;
  image.format = TYN_IMAGE_RGBA8_LINEAR;
  image.pixels = pixels;
  ASSERT_EQ(tyn_scene_add_image(scene, &image, &material.normal_texture.image), TYN_OK);
  material.normal_scale = 0.5f;
  const double x = (204 / 127.5 - 1) * 0.5, y = (166 / 127.5 - 1) * 0.5, z = 230 / 127.5 - 1;
  const double length = std::sqrt(x * x + y * y + z * z);
  const std::vector<float> normal = at(0.3, 0.6, TYN_LAYER_NORMAL);
  EXPECT_NEAR(normal[0], x / length, 1e-5);
  EXPECT_NEAR(normal[1], z / length, 1e-5);
  EXPECT_NEAR(normal[2], -y / length, 1e-5);
}

} // namespace
