// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// What camera rays meet: depth, alpha, normal, the shape of the film, and the orientation of the environment.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "common/render_scene.hpp"

namespace {

using namespace tyn_test;

const double pi = 3.14159265358979324;

class CameraView : public testing::Test {
protected:
  Context context;
  Scene scene{context};

  std::vector<float> layer(const TynRenderOptions &options, uint32_t which) {
    if (!scene->committed)
      scene.commit();
    Render render(scene, options);
    render.run(4);
    return render.layer(which);
  }
};

// A square of width 2 in the plane y = 0, seen from above.
TynCamera overhead(double height, double yfov) { return look_at({0, height, 0}, {0, 0, 0}, {0, 0, -1}, yfov); }

TEST_F(CameraView, DepthIsMeasuredAlongTheAxis) {
  scene.add(quad(100));
  for (const float z : layer(film_options(8, 8, overhead(3, 1.2)), TYN_LAYER_DEPTH))
    EXPECT_NEAR(z, 3, 1e-5);
  TynCamera flat = look_at_flat({0, 5, 0}, {0, 0, 0}, {0, 0, -1}, 2);
  for (const float z : layer(film_options(8, 8, flat), TYN_LAYER_DEPTH))
    EXPECT_NEAR(z, 5, 1e-5);
}

TEST_F(CameraView, NothingIsInfinitelyFarAndTransparent) {
  scene.add(quad(1));
  const TynRenderOptions options = film_options(4, 4, look_at({0, 3, 0}, {0, 6, 0}, {0, 0, -1}, 1));
  EXPECT_EQ(layer(options, TYN_LAYER_DEPTH), std::vector<float>(16, std::numeric_limits<float>::infinity()));
  EXPECT_EQ(layer(options, TYN_LAYER_BEAUTY), std::vector<float>(64, 0.0f));
}

TEST_F(CameraView, WhatIsNearerThanZnearIsNotSeen) {
  scene.add(quad(100));
  scene.add(translated(quad(100), 0, 2, 0));
  TynCamera camera = overhead(3, 1.2);
  camera.znear = 0.5f;
  EXPECT_NEAR(layer(film_options(8, 8, camera), TYN_LAYER_DEPTH)[0], 1, 1e-5);
  camera.znear = 1.5f; // also at the corners, where the ray is longer than its depth
  for (const float z : layer(film_options(8, 8, camera), TYN_LAYER_DEPTH))
    EXPECT_NEAR(z, 3, 1e-5);
}

TEST_F(CameraView, NormalsFaceTheCamera) {
  scene.add(quad(100));
  std::vector<float> normals = layer(film_options(2, 2, overhead(3, 0.5)), TYN_LAYER_NORMAL);
  for (size_t i = 0; i < 4; i++)
    EXPECT_NEAR(normals[3 * i + 1], 1, 1e-6);
  const TynCamera below = look_at({0, -3, 0}, {0, 0, 0}, {0, 0, -1}, 0.5);
  normals = layer(film_options(2, 2, below), TYN_LAYER_NORMAL);
  for (size_t i = 0; i < 4; i++)
    EXPECT_NEAR(normals[3 * i + 1], -1, 1e-6);
}

// How much of the film a square covers that just fills the view of a camera made for a square film.
double covered(const std::vector<float> &beauty) {
  double sum = 0;
  for (size_t i = 3; i < beauty.size(); i += 4)
    sum += double(beauty[i]);
  return sum / double(beauty.size() / 4);
}

TEST_F(CameraView, AFilmOfAnotherShapeShowsMoreNeverLess) {
  scene.add(quad(2));
  TynCamera camera = overhead(2, 2 * std::atan(0.5));
  camera.aspect_ratio = 1;
  EXPECT_GT(covered(layer(film_options(64, 64, camera), TYN_LAYER_BEAUTY)), 0.97); // the filter reaches past the edge
  EXPECT_NEAR(covered(layer(film_options(64, 32, camera), TYN_LAYER_BEAUTY)), 0.5, 0.02);
  EXPECT_NEAR(covered(layer(film_options(32, 64, camera), TYN_LAYER_BEAUTY)), 0.5, 0.02);
  TynCamera flat = look_at_flat({0, 2, 0}, {0, 0, 0}, {0, 0, -1}, 1);
  flat.aspect_ratio = 1;
  EXPECT_NEAR(covered(layer(film_options(64, 32, flat), TYN_LAYER_BEAUTY)), 0.5, 0.02);
  EXPECT_NEAR(covered(layer(film_options(32, 64, flat), TYN_LAYER_BEAUTY)), 0.5, 0.02);
  flat.aspect_ratio = 0; // the film's: ymag is half of what is seen
  EXPECT_NEAR(covered(layer(film_options(64, 32, flat), TYN_LAYER_BEAUTY)), 0.5, 0.02);
  EXPECT_GT(covered(layer(film_options(32, 64, flat), TYN_LAYER_BEAUTY)), 0.97);
}

TEST_F(CameraView, RightIsRightAndUpIsUp) {
  scene.add(translated(box(1, 1, 1), 2, 1, 0)); // to the right of the middle, and above it
  const std::vector<float> beauty =
      layer(film_options(9, 9, look_at({0, 0, 8}, {0, 0, 0}, {0, 1, 0}, 0.8)), TYN_LAYER_BEAUTY);
  double x = 0, y = 0, sum = 0;
  for (int row = 0; row < 9; row++)
    for (int column = 0; column < 9; column++) {
      const double alpha = double(beauty[size_t(4 * (9 * row + column) + 3)]);
      x += alpha * column;
      y += alpha * row;
      sum += alpha;
    }
  EXPECT_GT(x / sum, 5);
  EXPECT_LT(y / sum, 4);
}

// An environment of 8 x 4 pixels whose red and green are the column and the row.
TynEnvironment numbered_sky(TynScene *scene) {
  std::vector<float> pixels(4 * 8 * 4, 1.0f);
  for (int row = 0; row < 4; row++)
    for (int column = 0; column < 8; column++) {
      pixels[size_t(4 * (8 * row + column))] = float(column);
      pixels[size_t(4 * (8 * row + column) + 1)] = float(row);
    }
  TynImage image = tyn_image();
  image.width = 8;
  image.height = 4;
  image.format = TYN_IMAGE_RGBA32F;
  image.pixels = pixels.data();
  TynEnvironment environment = constant_environment(1);
  EXPECT_EQ(tyn_scene_add_image(scene, &image, &environment.image), TYN_OK);
  return environment;
}

struct Seen {
  double column, row; // in pixels, as interpolated
};

class Sky : public CameraView {
protected:
  // What is seen along a direction.
  Seen look(const double (&direction)[3], float rotation = 0) {
    if (!scene->committed) {
      scene.add(translated(quad(1), 0, -1000, 0)); // a scene must have a mesh
      TynEnvironment environment = numbered_sky(scene);
      environment.rotation = rotation;
      EXPECT_EQ(tyn_scene_set_environment(scene, &environment), TYN_OK);
    }
    const double up[3] = {0.01, 1, 0.02};
    const TynCamera camera = look_at({0, 0, 0}, direction, up, 1e-4);
    const std::vector<float> beauty = layer(film_options(1, 1, camera), TYN_LAYER_BEAUTY);
    return {double(beauty[0]), double(beauty[1])};
  }
};

// Centres of pixels are at whole numbers: u = (column + 1/2) / 8.
TEST_F(Sky, HasItsCentreAtMinusZAndColumnsRunToTheRight) {
  EXPECT_NEAR(look({0, 0, -1}).column, 3.5, 1e-3);
  EXPECT_NEAR(look({0, 0, -1}).row, 1.5, 1e-3);
  EXPECT_NEAR(look({1, 0, 0}).column, 5.5, 1e-3);
  EXPECT_NEAR(look({-1, 0, 0}).column, 1.5, 1e-3);
  EXPECT_NEAR(look({std::sin(pi / 4), 0, -std::cos(pi / 4)}).column, 4.5, 1e-3);
}

TEST_F(Sky, HasItsTopRowAtPlusY) {
  EXPECT_NEAR(look({0, 1, -0.01}).row, 0, 1e-3);
  EXPECT_NEAR(look({0, -1, -0.01}).row, 3, 1e-3);
  EXPECT_NEAR(look({0, std::cos(3 * pi / 8), -std::sin(3 * pi / 8)}).row, 1, 1e-3);
}

TEST_F(Sky, TurnsCounterClockwiseSeenFromAbove) {
  // a quarter turn takes what was along -Z to -X
  EXPECT_NEAR(look({-1, 0, 0}, float(pi / 2)).column, 3.5, 1e-3);
  EXPECT_NEAR(look({0, 0, -1}, float(pi / 2)).column, 5.5, 1e-3);
}

TEST_F(Sky, CanBeHiddenFromTheCameraAlone) {
  const TynMaterial material = matte(1);
  uint32_t index = TYN_NONE;
  ASSERT_EQ(tyn_scene_add_material(scene, &material, &index), TYN_OK);
  scene.add(quad(2), TYN_NONE, index);
  TynEnvironment environment = constant_environment(1);
  environment.hidden_from_camera = 1;
  ASSERT_EQ(tyn_scene_set_environment(scene, &environment), TYN_OK);
  const std::vector<float> beauty = layer(film_options(9, 9, overhead(6, 0.8)), TYN_LAYER_BEAUTY);
  EXPECT_EQ(beauty[0], 0);
  EXPECT_NEAR(beauty[4 * 40], 1, 1e-5);
}

} // namespace
