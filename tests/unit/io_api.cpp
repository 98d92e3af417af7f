// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The four calls of tyndall_io.h on real handles.
#ifdef TYN_TEST_IO
#include <cmath>
#include <cstdlib>

#include <gtest/gtest.h>

#include "common/gltf_builder.hpp"
#include "common/handles.hpp"
#include "common/meshes.hpp"
#include "io/exr_load.hpp"
#include "tyndall/tyndall_io.h"

using tyn_test::Context;
using tyn_test::Gltf;
using tyn_test::Scene;
using tyn_test::TemporaryFolder;

namespace {

// A tetrahedron of glass with a light and a camera.
Gltf full_model() {
  Gltf model = Gltf::tetrahedron();
  model.material_extension("KHR_materials_transmission") = {{"transmissionFactor", 1}};
  model.material_extension("KHR_materials_volume") = {
      {"thicknessFactor", 1}, {"attenuationDistance", 1}, {"attenuationColor", {0.5, 0.5, 0.5}}};
  model.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}}};
  model.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 0.6}, {"znear", 0.1}}}}};
  model.json["nodes"].push_back({{"name", "both"},
                                 {"camera", 0},
                                 {"translation", {0, 0, 5}},
                                 {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
  model.json["scenes"][0]["nodes"].push_back(1);
  return model;
}

TynStatus load_into(TynScene *scene, const Gltf &model, const TynGltfOptions *options = nullptr) {
  const TemporaryFolder folder;
  folder.write("model.glb", model.glb());
  return tyn_gltf_load(scene, folder.file("model.glb").c_str(), options);
}

void expect_empty(const Scene &scene) {
  const TynSceneInfo info = scene.info();
  EXPECT_EQ(info.mesh_count + info.medium_count + info.material_count + info.image_count, 0u);
  EXPECT_EQ(info.light_count + info.camera_count, 0u);
}

} // namespace

TEST(IoApi, GltfModelIsAddedToTheScene) {
  const Context context;
  Scene scene(context);
  ASSERT_EQ(load_into(scene, full_model()), TYN_OK) << scene.message();
  const TynSceneInfo info = scene.info();
  EXPECT_EQ(info.mesh_count, 1u);
  EXPECT_EQ(info.medium_count, 1u);
  EXPECT_EQ(info.light_count, 1u);
  EXPECT_EQ(info.camera_count, 1u);
  EXPECT_EQ(info.triangle_count, 4u);
  const TynMeshInfo mesh = scene.info(0);
  EXPECT_STREQ(mesh.name, "node");
  EXPECT_EQ(mesh.closed, 1u);
  EXPECT_EQ(mesh.medium, 0u);
  EXPECT_NEAR(mesh.volume, 1 / 6.0, 1e-6);
  TynMedium medium = tyn_medium();
  ASSERT_EQ(tyn_scene_medium(scene, 0, &medium), TYN_OK);
  EXPECT_STREQ(medium.name, "stuff");
  EXPECT_NEAR(medium.sigma_a[0], std::log(2.0), 1e-6);
  TynCamera camera = tyn_camera();
  ASSERT_EQ(tyn_scene_camera(scene, 0, &camera), TYN_OK);
  EXPECT_STREQ(camera.name, "both");
  EXPECT_EQ(tyn_scene_commit(scene), TYN_OK) << scene.message();
}

TEST(IoApi, SecondModelKeepsItsOwnMaterialsAndMedia) {
  const Context context;
  Scene scene(context);
  ASSERT_EQ(load_into(scene, Gltf::tetrahedron()), TYN_OK);
  ASSERT_EQ(load_into(scene, full_model()), TYN_OK) << scene.message();
  EXPECT_EQ(scene.info(0).material, 0u);
  EXPECT_EQ(scene.info(0).medium, TYN_NONE);
  EXPECT_EQ(scene.info(1).material, 1u);
  EXPECT_EQ(scene.info(1).medium, 0u);
}

TEST(IoApi, OpenMeshWithAMediumIsAWarning) {
  const Context context;
  Scene scene(context);
  Gltf model = full_model();
  model.primitive()["indices"] = model.indices({0, 2, 1, 0, 1, 3, 0, 3, 2});
  std::string warned;
  TynGltfOptions options = tyn_gltf_options();
  options.warning = [](void *user, const char *message) { *static_cast<std::string *>(user) += message; };
  options.user = &warned;
  ASSERT_EQ(load_into(scene, model, &options), TYN_OK) << scene.message();
  EXPECT_NE(warned.find("mesh \"node\" holds a medium, but is not closed: it has 3 boundary edges"), std::string::npos)
      << warned;
}

// What is warned of when full_model() has this shape.
std::string warnings_about(const tyn_test::MeshData &mesh, double attenuation_distance = 1) {
  const Context context;
  Scene scene(context);
  Gltf model = full_model();
  model.material_extension("KHR_materials_volume")["attenuationDistance"] = attenuation_distance;
  model.primitive()["attributes"]["POSITION"] = model.floats(mesh.positions, "VEC3");
  model.primitive()["indices"] = model.indices(mesh.indices);
  std::string warned;
  TynGltfOptions options = tyn_gltf_options();
  options.warning = [](void *user, const char *message) { *static_cast<std::string *>(user) += message; };
  options.user = &warned;
  EXPECT_EQ(load_into(scene, model, &options), TYN_OK) << scene.message();
  return warned;
}

// Touching in a point, slivers and thin shapes are nothing to warn of.
TEST(IoApi, UnsoundMeshesWithAMediumAreNamed) {
  const std::string names[4] = {
      "mesh \"node\" holds a medium, but is not closed", "mesh \"node\" holds a medium, but has",
      "mesh \"node\" holds a medium, but of its 2 parts", "mesh \"node\": the mean free path"};
  struct Case {
    const char *mesh;
    bool expected[3];
  };
  const Case cases[] = {{"sliver", {false, false, false}},
                        {"zero areas", {false, false, false}},
                        {"one triangle twice", {true, true, false}},
                        {"every triangle twice", {true, true, false}},
                        {"cubes that share an edge", {true, false, false}},
                        {"cubes that share a face", {true, true, false}},
                        {"cubes that share a vertex", {false, false, false}},
                        {"cubes side by side", {false, false, true}},
                        {"overlapping cubes", {false, false, true}},
                        {"a cross", {false, false, true}},
                        {"a sphere in a sphere", {false, false, true}},
                        {"a needle", {false, false, false}}};
  size_t found = 0;
  for (const tyn_test::NamedMesh &named : tyn_test::hostile_meshes())
    for (const Case &one : cases) {
      if (named.name != one.mesh)
        continue;
      ++found;
      const std::string warned = warnings_about(named.mesh, 1e4);
      for (size_t i = 0; i < 3; i++)
        EXPECT_EQ(warned.find(names[i]) != std::string::npos, one.expected[i]) << named.name << ": " << warned;
      EXPECT_EQ(warned.find(names[3]), std::string::npos) << warned;
    }
  EXPECT_EQ(found, std::size(cases));
  EXPECT_NE(warnings_about(tyn_test::cube(), 1e-6).find(names[3]), std::string::npos);
  EXPECT_EQ(warnings_about(tyn_test::cube(), 1e-3), "");
}

TEST(IoApi, FailedLoadAddsNothingAndNamesTheFile) {
  const Context context;
  Scene scene(context);
  Gltf model = full_model();
  model.json["cameras"][0]["perspective"]["yfov"] = 9; // the last thing that is looked at
  const TemporaryFolder folder;
  folder.write("model.glb", model.glb());
  EXPECT_EQ(tyn_gltf_load(scene, folder.file("model.glb").c_str(), nullptr), TYN_ERROR_FORMAT);
  EXPECT_EQ(scene.message(),
            folder.file("model.glb") + ": cameras[0].perspective.yfov is 9; it must be between 0 and pi");
  expect_empty(scene);
  EXPECT_EQ(tyn_gltf_load(scene, folder.file("none.glb").c_str(), nullptr), TYN_ERROR_FILE);
  EXPECT_EQ(scene.message(), "cannot open " + folder.file("none.glb") + ": No such file or directory");
  expect_empty(scene);
}

TEST(IoApi, WhatASceneRefusesOfAMeshIsFoundBeforeAnythingIsAdded) {
  const Context context;
  Scene scene(context);
  Gltf model = full_model();
  model.json["nodes"][0]["translation"] = {0, 0, 2e10};
  EXPECT_EQ(load_into(scene, model), TYN_ERROR_FORMAT);
  EXPECT_NE(scene.message().find("model.glb: meshes[0].primitives[0]: vertex 0"), std::string::npos) << scene.message();
  expect_empty(scene);
  model = full_model();
  model.primitive()["indices"] = model.indices({0, 0, 0});
  EXPECT_EQ(load_into(scene, model), TYN_OK) << scene.message();
  EXPECT_EQ(scene.info().mesh_count, 0u);
}

TEST(IoApi, WrongArgumentsAreRefused) {
  const Context context;
  Scene scene(context);
  uint32_t image = 0;
  EXPECT_EQ(tyn_gltf_load(nullptr, "x", nullptr), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_gltf_load(scene, nullptr, nullptr), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_exr_load(nullptr, "x", &image), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_exr_load(scene, nullptr, &image), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_exr_load(scene, "x", nullptr), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_exr_write(nullptr, "x", nullptr, 0), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_png_write(nullptr, "x", nullptr), TYN_ERROR_INVALID_ARGUMENT);
  TynGltfOptions options = tyn_gltf_options();
  options.size = 3;
  EXPECT_EQ(load_into(scene, full_model(), &options), TYN_ERROR_INVALID_ARGUMENT);
  options.size = sizeof options + 8;
  EXPECT_EQ(load_into(scene, full_model(), &options), TYN_ERROR_INVALID_ARGUMENT);
  options = tyn_gltf_options();
  options.assignment_count = 1;
  EXPECT_EQ(load_into(scene, full_model(), &options), TYN_ERROR_INVALID_ARGUMENT);
  expect_empty(scene);
}

TEST(IoApi, SceneThatIsNotInMetresOrIsCommittedIsRefused) {
  const Context context;
  TynSceneOptions millimetres = tyn_scene_options();
  millimetres.metres_per_unit = 0.001;
  TynScene *small = nullptr;
  ASSERT_EQ(tyn_scene_create(context, &millimetres, &small), TYN_OK);
  EXPECT_EQ(load_into(small, full_model()), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_NE(context.message().find("metres_per_unit is 0.001"), std::string::npos) << context.message();
  tyn_scene_release(small);
  Scene scene(context);
  ASSERT_EQ(load_into(scene, full_model()), TYN_OK);
  ASSERT_EQ(tyn_scene_commit(scene), TYN_OK) << scene.message();
  EXPECT_EQ(load_into(scene, full_model()), TYN_ERROR_INVALID_OPERATION);
  EXPECT_EQ(scene.info().mesh_count, 1u);
}

TEST(IoApi, FilmIsWrittenWithItsHeaderAndReadBackAsAnEnvironment) {
  const Context context;
  Scene scene(context);
  ASSERT_EQ(load_into(scene, Gltf::tetrahedron()), TYN_OK);
  ASSERT_EQ(tyn_scene_commit(scene), TYN_OK) << scene.message();
  TynRenderOptions options = tyn_render_options();
  options.width = 5;
  options.height = 4;
  options.seed = 77;
  TynRenderer *renderer = nullptr;
  ASSERT_EQ(tyn_renderer_create(scene, &options, &renderer), TYN_OK) << scene.message();
  const TemporaryFolder folder;
  const std::string exr = folder.file("a.exr"), png = folder.file("a.png");
  const TynAttribute attribute = {"tyndall:material", "glass"};
  EXPECT_EQ(tyn_exr_write(renderer, exr.c_str(), &attribute, 1), TYN_OK) << scene.message();
  EXPECT_EQ(tyn_png_write(renderer, png.c_str(), nullptr), TYN_OK) << scene.message();
  EXPECT_EQ(folder.names(), std::vector<std::string>({"a.exr", "a.png"}));
  const std::string bytes = tyn_test::read_whole(exr);
  for (const char *part : {"tyndall:material", "glass", "tyndall:seed", "tyndall:samples", "tyndall:seconds",
                           "tyndall:device", "software", "chromaticities", "subsurface.R", "variance.B"})
    EXPECT_NE(bytes.find(part), std::string::npos) << part;
  Scene second(context);
  uint32_t image = 99;
  EXPECT_EQ(tyn_exr_load(second, exr.c_str(), &image), TYN_OK) << second.message();
  EXPECT_EQ(image, 0u);
  TynEnvironment environment = tyn_environment();
  environment.image = image;
  EXPECT_EQ(tyn_scene_set_environment(second, &environment), TYN_OK) << second.message();

  EXPECT_EQ(tyn_exr_write(renderer, folder.file("none/a.exr").c_str(), nullptr, 0), TYN_ERROR_FILE);
  EXPECT_EQ(scene.message(), "cannot write " + folder.file("none/a.exr") + ": No such file or directory");
  EXPECT_EQ(tyn_exr_write(renderer, nullptr, nullptr, 0), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_exr_write(renderer, exr.c_str(), nullptr, 1), TYN_ERROR_INVALID_ARGUMENT);
  const TynAttribute nameless = {"", "x"};
  EXPECT_EQ(tyn_exr_write(renderer, exr.c_str(), &nameless, 1), TYN_ERROR_INVALID_ARGUMENT);
  TynPngOptions wrong = tyn_png_options();
  wrong.layer = TYN_LAYER_COUNT;
  EXPECT_EQ(tyn_png_write(renderer, png.c_str(), &wrong), TYN_ERROR_INVALID_ARGUMENT);
  wrong = tyn_png_options();
  wrong.tone = 2;
  EXPECT_EQ(tyn_png_write(renderer, png.c_str(), &wrong), TYN_ERROR_INVALID_ARGUMENT);
  wrong = tyn_png_options();
  wrong.exposure = NAN;
  EXPECT_EQ(tyn_png_write(renderer, png.c_str(), &wrong), TYN_ERROR_INVALID_ARGUMENT);
  tyn_renderer_release(renderer);
}

TEST(IoApi, RealHeadIsClosedAndFilledWithSkin) {
  const char *data = std::getenv("TYNDALL_TEST_DATA");
  if (!data)
    GTEST_SKIP() << "no head.glb: set TYNDALL_TEST_DATA to the folder that holds it";
  const Context context;
  Scene scene(context);
  ASSERT_EQ(tyn_gltf_load(scene, (std::string(data) + "/head.glb").c_str(), nullptr), TYN_OK) << scene.message();
  const TynMeshInfo mesh = scene.info(0);
  EXPECT_EQ(mesh.triangle_count, 17684u);
  EXPECT_EQ(mesh.closed, 1u);
  TynMedium medium = tyn_medium();
  ASSERT_EQ(tyn_scene_medium(scene, 0, &medium), TYN_OK);
  // Jensen 2001, skin1, in 1/m: extinction 0.772, 1.05, 1.49 per millimetre.
  EXPECT_NEAR(medium.sigma_a[0] + medium.sigma_s[0], 772, 1);
  EXPECT_NEAR(medium.sigma_a[2] + medium.sigma_s[2], 1490, 1);
  EXPECT_FLOAT_EQ(medium.ior, 1.4f);
}
#endif
