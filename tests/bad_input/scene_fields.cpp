// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Every field of every struct that a scene takes, with values outside its range.
#include <cmath>
#include <functional>

#include "common/handles.hpp"
#include "scene/scene.hpp"

using namespace tyn_test;

namespace {

// A change that makes a valid struct invalid, and a part of the message it must lead to.
template <class T>
struct Case {
  std::function<void(T &)> spoil;
  const char *message;
};

class BadField : public ::testing::Test {
protected:
  template <class T, class Add>
  void expect_refused(const T &valid, Add add, const std::vector<Case<T>> &cases) {
    EXPECT_EQ(add(scene, &valid), TYN_OK) << scene.message();
    const TynSceneInfo before = scene.info();
    for (const Case<T> &bad : cases) {
      T value = valid;
      bad.spoil(value);
      EXPECT_EQ(add(scene, &value), TYN_ERROR_INVALID_ARGUMENT) << bad.message;
      EXPECT_NE(scene.message().find(bad.message), std::string::npos)
          << "'" << bad.message << "' is not in '" << scene.message() << "'";
    }
    EXPECT_EQ(add(scene, nullptr), TYN_ERROR_INVALID_ARGUMENT);
    T value = valid;
    value.size = 0;
    EXPECT_EQ(add(scene, &value), TYN_ERROR_INVALID_ARGUMENT);
    value.size = sizeof(T) - 4;
    EXPECT_EQ(add(scene, &value), TYN_ERROR_INVALID_ARGUMENT);
    value.size = sizeof(T) + 4;
    EXPECT_EQ(add(scene, &value), TYN_ERROR_INVALID_ARGUMENT);
    const TynSceneInfo after = scene.info();
    EXPECT_EQ(after.medium_count + after.material_count + after.image_count + after.light_count + after.camera_count,
              before.medium_count + before.material_count + before.image_count + before.light_count +
                  before.camera_count);
  }

  Context context;
  Scene scene{context};
};

TEST_F(BadField, OfAMedium) {
  TynMedium medium = tyn_medium();
  medium.sigma_a[0] = 1;
  expect_refused<TynMedium>(medium, [](TynScene *s, const TynMedium *m) { return tyn_scene_add_medium(s, m, nullptr); },
                            {{[](TynMedium &m) { m.sigma_a[1] = -1; }, "sigma_a[1] is -1"},
                             {[](TynMedium &m) { m.sigma_s[2] = NAN; }, "sigma_s[2] is nan"},
                             {[](TynMedium &m) { m.sigma_s[0] = INFINITY; }, "sigma_s[0] is inf"},
                             {[](TynMedium &m) { m.sigma_s[0] = m.sigma_a[0] = 3e38f; }, "sigma_a[0] + sigma_s[0]"},
                             {[](TynMedium &m) { m.g = 1; }, "g is 1"},
                             {[](TynMedium &m) { m.g = -1; }, "g is -1"},
                             {[](TynMedium &m) { m.g = NAN; }, "g is nan"},
                             {[](TynMedium &m) { m.ior = 0.9f; }, "ior is 0.9"},
                             {[](TynMedium &m) { m.ior = 5; }, "ior is 5"},
                             {[](TynMedium &m) { m.ior = NAN; }, "ior is nan"}});
}

TEST_F(BadField, OfAMaterial) {
  expect_refused<TynMaterial>(
      tyn_material(), [](TynScene *s, const TynMaterial *m) { return tyn_scene_add_material(s, m, nullptr); },
      {{[](TynMaterial &m) { m.base_color[2] = 1.5f; }, "base_color[2] is 1.5"},
       {[](TynMaterial &m) { m.metallic = -0.1f; }, "metallic is -0.1"},
       {[](TynMaterial &m) { m.roughness = NAN; }, "roughness is nan"},
       {[](TynMaterial &m) { m.ior = 0; }, "ior is 0"},
       {[](TynMaterial &m) { m.transmission = 2; }, "transmission is 2"},
       {[](TynMaterial &m) { m.emission[0] = -1; }, "emission[0] is -1"},
       {[](TynMaterial &m) { m.emission[1] = INFINITY; }, "emission[1] is inf"},
       {[](TynMaterial &m) { m.normal_scale = NAN; }, "normal_scale is nan"},
       {[](TynMaterial &m) { m.double_sided = 2; }, "double_sided is 2"},
       {[](TynMaterial &m) { m.thin_walled = 7; }, "thin_walled is 7"},
       {[](TynMaterial &m) { m.thin_scatter = 1.1f; }, "thin_scatter is 1.1"},
       {[](TynMaterial &m) { m.thin_scatter_color[0] = -1; }, "thin_scatter_color[0]"},
       {[](TynMaterial &m) { m.thin_scatter_anisotropy = -1.5f; }, "thin_scatter_anisotropy is -1.5"},
       {[](TynMaterial &m) { m.multiscatter_color[0] = NAN; }, "multiscatter_color[0] is nan"},
       {[](TynMaterial &m) { m.multiscatter_color[0] = 0.5f, m.multiscatter_color[1] = 2; },
        "multiscatter_color[1] is 2"},
       {[](TynMaterial &m) { m.scatter_strength = 3; }, "scatter_strength is 3"},
       {[](TynMaterial &m) { m.base_color_texture.image = 0; }, "base_color_texture.image is 0"},
       {[](TynMaterial &m) { m.normal_texture.wrap_u = 3; }, "normal_texture.wrap_u is 3"},
       {[](TynMaterial &m) { m.normal_texture.wrap_v = 9; }, "normal_texture.wrap_v is 9"},
       {[](TynMaterial &m) { m.emission_texture.filter = 2; }, "emission_texture.filter is 2"},
       {[](TynMaterial &m) { m.scatter_strength_texture.transform[5] = NAN; }, "transform[5] is nan"}});
}

TEST_F(BadField, OfALight) {
  TynLight spot = tyn_light();
  spot.type = TYN_LIGHT_SPOT;
  expect_refused<TynLight>(spot, [](TynScene *s, const TynLight *l) { return tyn_scene_add_light(s, l, nullptr); },
                           {{[](TynLight &l) { l.type = 3; }, "type is 3"},
                            {[](TynLight &l) { l.position[0] = NAN; }, "position[0] is nan"},
                            {[](TynLight &l) { l.direction[1] = 2; }, "direction is (0, 2, -1)"},
                            {[](TynLight &l) { l.direction[2] = 0; }, "unit length"},
                            {[](TynLight &l) { l.intensity[1] = -1; }, "intensity[1] is -1"},
                            {[](TynLight &l) { l.intensity[2] = INFINITY; }, "intensity[2] is inf"},
                            {[](TynLight &l) { l.outer_cone = 0; }, "outer_cone is 0"},
                            {[](TynLight &l) { l.outer_cone = 2; }, "outer_cone is 2"},
                            {[](TynLight &l) { l.outer_cone = NAN; }, "outer_cone is nan"},
                            {[](TynLight &l) { l.inner_cone = 1; }, "inner_cone is 1"},
                            {[](TynLight &l) { l.inner_cone = -1; }, "inner_cone is -1"}});
}

TEST_F(BadField, OfACamera) {
  expect_refused<TynCamera>(tyn_camera(),
                            [](TynScene *s, const TynCamera *c) { return tyn_scene_add_camera(s, c, nullptr); },
                            {{[](TynCamera &c) { c.type = 2; }, "type is 2"},
                             {[](TynCamera &c) { c.world_from_camera[3] = NAN; }, "world_from_camera[3] is nan"},
                             {[](TynCamera &c) { c.world_from_camera[0] = 2; }, "columns 0 and 0"},
                             {[](TynCamera &c) { c.world_from_camera[1] = 0.5f; }, "columns 0 and 1"},
                             {[](TynCamera &c) { c.world_from_camera[0] = -1; }, "mirrors"},
                             {[](TynCamera &c) { c.yfov = 0; }, "yfov is 0"},
                             {[](TynCamera &c) { c.yfov = 3.2f; }, "yfov is 3.2"},
                             {[](TynCamera &c) { c.type = TYN_CAMERA_ORTHOGRAPHIC, c.ymag = 0; }, "ymag is 0"},
                             {[](TynCamera &c) { c.aspect_ratio = -1; }, "aspect_ratio is -1"},
                             {[](TynCamera &c) { c.znear = INFINITY; }, "znear is inf"}});
}

TEST_F(BadField, OfAnImage) {
  static const float pixels[8] = {1, 1, 1, 1, 0, 0, 0, 0};
  static const float wrong[8] = {1, 1, 1, 1, 0, NAN, 0, 0};
  TynImage image = tyn_image();
  image.width = 2;
  image.height = 1;
  image.format = TYN_IMAGE_RGBA32F;
  image.pixels = pixels;
  expect_refused<TynImage>(image, [](TynScene *s, const TynImage *i) { return tyn_scene_add_image(s, i, nullptr); },
                           {{[](TynImage &i) { i.width = 0; }, "width is 0"},
                            {[](TynImage &i) { i.height = 32769; }, "height is 32769"},
                            {[](TynImage &i) { i.format = 3; }, "format is 3"},
                            {[](TynImage &i) { i.pixels = nullptr; }, "pixels is NULL"},
                            {[](TynImage &i) { i.row_stride = 16; }, "row_stride is 16"},
                            {[](TynImage &i) { i.row_stride = SIZE_MAX / 2, i.height = 3; }, "overflow"},
                            {[](TynImage &i) { i.pixels = wrong; }, "channel 1 of pixel (1, 0) is nan"}});
}

TEST_F(BadField, OfAnEnvironment) {
  const unsigned char pixel[4] = {1, 2, 3, 4};
  TynImage image = tyn_image();
  image.width = image.height = 1;
  image.pixels = pixel;
  EXPECT_EQ(tyn_scene_add_image(scene, &image, nullptr), TYN_OK);
  expect_refused<TynEnvironment>(tyn_environment(),
                                 [](TynScene *s, const TynEnvironment *e) { return tyn_scene_set_environment(s, e); },
                                 {{[](TynEnvironment &e) { e.radiance[0] = -1; }, "radiance[0] is -1"},
                                  {[](TynEnvironment &e) { e.radiance[2] = NAN; }, "radiance[2] is nan"},
                                  {[](TynEnvironment &e) { e.image = 1; }, "image is 1, but the scene has 1 images"},
                                  {[](TynEnvironment &e) { e.image = 0; }, "must be TYN_IMAGE_RGBA32F"},
                                  {[](TynEnvironment &e) { e.rotation = INFINITY; }, "rotation is inf"},
                                  {[](TynEnvironment &e) { e.hidden_from_camera = 2; }, "hidden_from_camera is 2"}});
}

TEST_F(BadField, OfSceneOptions) {
  for (double metres : {0.0, -1.0, double(NAN), double(INFINITY)}) {
    TynSceneOptions options = tyn_scene_options();
    options.metres_per_unit = metres;
    TynScene *other = scene;
    EXPECT_EQ(tyn_scene_create(context, &options, &other), TYN_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(other, nullptr);
    EXPECT_NE(context.message().find("metres_per_unit"), std::string::npos);
  }
  EXPECT_EQ(tyn_scene_create(context, nullptr, nullptr), TYN_ERROR_INVALID_ARGUMENT);
}

TEST_F(BadField, OfAFrame) {
  TynCamera camera;
  EXPECT_EQ(tyn_scene_frame(scene, 1, &camera), TYN_ERROR_INVALID_OPERATION) << "there is nothing to look at";
  scene.add(cube());
  EXPECT_EQ(tyn_scene_frame(scene, 1, nullptr), TYN_ERROR_INVALID_ARGUMENT);
  for (float aspect_ratio : {0.0f, -1.0f, NAN, INFINITY})
    EXPECT_EQ(tyn_scene_frame(scene, aspect_ratio, &camera), TYN_ERROR_INVALID_ARGUMENT);
}

TEST_F(BadField, ImageRowsMayBePadded) {
  const unsigned char pixels[] = {1, 2, 3, 4, 99, 99, 5, 6, 7, 8};
  TynImage image = tyn_image();
  image.width = 1;
  image.height = 2;
  image.pixels = pixels;
  image.row_stride = 6;
  ASSERT_EQ(tyn_scene_add_image(scene, &image, nullptr), TYN_OK) << scene.message();
  EXPECT_EQ(scene->images[0].pixels, (std::vector<unsigned char>{1, 2, 3, 4, 5, 6, 7, 8}));
}

} // namespace
