// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstring>

#include "common/handles.hpp"
#include "scene/commit.hpp"
#include "scene/scene.hpp"

using namespace tyn_test;

namespace {

TEST(SceneObject, StartsEmptyAndBlack) {
  Context context;
  Scene scene(context);
  const TynSceneInfo info = scene.info();
  EXPECT_EQ(info.mesh_count, 0u);
  EXPECT_EQ(info.triangle_count, 0u);
  EXPECT_EQ(info.has_environment, 0u);
  EXPECT_EQ(info.metres_per_unit, 1.0);
  EXPECT_GT(info.lower[0], info.upper[0]);
  EXPECT_EQ(tyn_scene_context(scene), static_cast<TynContext *>(context));
}

TEST(SceneObject, KeepsItsContextAlive) {
  TynContext *context = nullptr;
  ASSERT_EQ(tyn_context_create(nullptr, &context), TYN_OK);
  TynScene *scene = nullptr;
  ASSERT_EQ(tyn_scene_create(context, nullptr, &scene), TYN_OK);
  tyn_context_release(context);
  const MeshData mesh = cube();
  const TynMesh view = mesh.view();
  EXPECT_EQ(tyn_scene_add_mesh(scene, &view, nullptr), TYN_OK);
  EXPECT_EQ(tyn_scene_commit(scene), TYN_OK);
  tyn_scene_retain(scene);
  tyn_scene_release(scene);
  const TynRay ray = {{0, 0, 0}, 0, {0, 0, 1}, INFINITY};
  TynHit hit;
  EXPECT_EQ(tyn_intersect(scene, TYN_NONE, &ray, 1, &hit), TYN_OK);
  EXPECT_EQ(hit.t, 1.0f);
  tyn_scene_release(scene);
}

TEST(SceneObject, AcceptsNullHandles) {
  tyn_scene_retain(nullptr);
  tyn_scene_release(nullptr);
  EXPECT_EQ(tyn_scene_context(nullptr), nullptr);
  EXPECT_EQ(tyn_scene_create(nullptr, nullptr, nullptr), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_scene_commit(nullptr), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_scene_clear_lights(nullptr), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_scene_info(nullptr, nullptr), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_scene_mesh_info(nullptr, 0, nullptr), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_scene_frame(nullptr, 1, nullptr), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_intersect(nullptr, 0, nullptr, 0, nullptr), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_occluded(nullptr, 0, nullptr, 0, nullptr), TYN_ERROR_INVALID_ARGUMENT);
}

TEST(SceneObject, CountsWhatWasAdded) {
  Context context;
  Scene scene(context);
  const float pixels[4] = {1, 2, 3, 1};
  TynImage image = tyn_image();
  image.width = image.height = 1;
  image.format = TYN_IMAGE_RGBA32F;
  image.pixels = pixels;
  TynMaterial glowing = tyn_material();
  glowing.emission[1] = 2;
  const TynLight light = tyn_light();
  const TynMedium medium = tyn_medium();
  const TynCamera camera = tyn_camera();
  TynEnvironment environment = tyn_environment();
  environment.radiance[2] = 1;
  uint32_t index = 7;
  EXPECT_EQ(tyn_scene_add_image(scene, &image, &index), TYN_OK) << scene.message();
  EXPECT_EQ(index, 0u);
  environment.image = index;
  EXPECT_EQ(tyn_scene_add_material(scene, &glowing, nullptr), TYN_OK) << scene.message();
  EXPECT_EQ(tyn_scene_add_medium(scene, &medium, nullptr), TYN_OK) << scene.message();
  EXPECT_EQ(tyn_scene_add_light(scene, &light, &index), TYN_OK) << scene.message();
  EXPECT_EQ(tyn_scene_add_light(scene, &light, &index), TYN_OK) << scene.message();
  EXPECT_EQ(index, 1u);
  EXPECT_EQ(tyn_scene_add_camera(scene, &camera, nullptr), TYN_OK) << scene.message();
  EXPECT_EQ(tyn_scene_set_environment(scene, &environment), TYN_OK) << scene.message();
  scene.add(cube(), 0, 0);
  scene.add(translated(cube(), 5, 0, 0));
  for (int committed = 0; committed < 2; committed++) {
    const TynSceneInfo info = scene.info();
    EXPECT_EQ(info.image_count, 1u);
    EXPECT_EQ(info.material_count, 1u) << "without the default that commit adds";
    EXPECT_EQ(info.medium_count, 1u);
    EXPECT_EQ(info.light_count, 2u);
    EXPECT_EQ(info.camera_count, 1u);
    EXPECT_EQ(info.mesh_count, 2u);
    EXPECT_EQ(info.triangle_count, 24u);
    EXPECT_EQ(info.emissive_triangle_count, 12u);
    EXPECT_EQ(info.has_environment, 1u);
    EXPECT_EQ(info.upper[0], 6.0f);
    if (!committed)
      scene.commit();
  }
}

TEST(SceneObject, ClearsItsLights) {
  Context context;
  Scene scene(context);
  const TynLight light = tyn_light();
  EXPECT_EQ(tyn_scene_add_light(scene, &light, nullptr), TYN_OK);
  EXPECT_EQ(tyn_scene_clear_lights(scene), TYN_OK);
  EXPECT_EQ(scene.info().light_count, 0u);
}

TEST(SceneObject, GivesBackNamesAndMedia) {
  Context context;
  Scene scene(context);
  char name[] = "skin";
  TynMedium medium = tyn_medium();
  medium.name = name;
  medium.sigma_s[1] = 3;
  EXPECT_EQ(tyn_scene_add_medium(scene, &medium, nullptr), TYN_OK);
  TynCamera camera = tyn_camera();
  camera.name = name;
  camera.yfov = 0.5f;
  EXPECT_EQ(tyn_scene_add_camera(scene, &camera, nullptr), TYN_OK);
  MeshData data = cube();
  TynMesh mesh = data.view();
  mesh.name = name;
  EXPECT_EQ(tyn_scene_add_mesh(scene, &mesh, nullptr), TYN_OK);
  scene.add(cube());
  std::strcpy(name, "----"); // they were copied

  TynMedium medium_back{};
  medium_back.size = sizeof medium_back;
  EXPECT_EQ(tyn_scene_medium(scene, 0, &medium_back), TYN_OK);
  EXPECT_STREQ(medium_back.name, "skin");
  EXPECT_EQ(medium_back.sigma_s[1], 3.0f);
  TynCamera camera_back{};
  camera_back.size = sizeof camera_back;
  EXPECT_EQ(tyn_scene_camera(scene, 0, &camera_back), TYN_OK);
  EXPECT_STREQ(camera_back.name, "skin");
  EXPECT_EQ(camera_back.yfov, 0.5f);
  EXPECT_STREQ(scene.info(0).name, "skin");
  EXPECT_STREQ(scene.info(1).name, "");
  EXPECT_EQ(scene.info(1).medium, TYN_NONE);
}

TEST(SceneObject, ReadsStridedAttributes) {
  struct Vertex {
    float position[3], normal[3], uv[2], more;
  };
  const MeshData sphere = icosphere(1);
  std::vector<Vertex> vertices(sphere.vertex_count());
  for (size_t i = 0; i < vertices.size(); i++) {
    std::memcpy(vertices[i].position, &sphere.positions[3 * i], 12);
    for (int k = 0; k < 3; k++)
      vertices[i].normal[k] = 3 * sphere.normals[3 * i + size_t(k)]; // normalized by the scene
    vertices[i].uv[0] = float(i);
    vertices[i].uv[1] = -1;
    vertices[i].more = NAN;
  }
  TynMesh mesh = sphere.view();
  mesh.positions = vertices[0].position;
  mesh.normals = vertices[0].normal;
  mesh.uvs = vertices[0].uv;
  mesh.position_stride = mesh.normal_stride = mesh.uv_stride = sizeof(Vertex);
  Context context;
  Scene scene(context);
  ASSERT_EQ(tyn_scene_add_mesh(scene, &mesh, nullptr), TYN_OK) << scene.message();
  const tyn::Mesh &copy = scene->meshes[0];
  ASSERT_EQ(copy.positions.size(), vertices.size());
  for (size_t i = 0; i < vertices.size(); i++) {
    EXPECT_EQ(copy.positions[i].y, vertices[i].position[1]);
    EXPECT_NEAR(copy.normals[i].z, sphere.normals[3 * i + 2], 1e-6f);
    EXPECT_EQ(copy.uvs[i].x, float(i));
  }
}

TEST(SceneObject, RepairsNormalsOfLengthZero) {
  MeshData sphere = icosphere(3);
  const std::vector<float> normals = sphere.normals;
  std::fill(sphere.normals.begin(), sphere.normals.end(), 0.0f);
  sphere.add_vertex(0, 0, 0); // one that no triangle uses
  sphere.normals.insert(sphere.normals.end(), {0, 0, 0});
  Context context;
  Scene scene(context);
  scene.add(sphere);
  for (size_t i = 0; i < normals.size() / 3; i++)
    EXPECT_NEAR(scene->meshes[0].normals[i].x, normals[3 * i], 0.03f);
  EXPECT_EQ(scene->meshes[0].normals.back().y, 1.0f);
}

TEST(SceneCommit, FillsTheRecordsOfMeshesAndTriangles) {
  Context context;
  Scene scene(context);
  TynMaterial material = tyn_material();
  material.roughness = 0.25f;
  EXPECT_EQ(tyn_scene_add_material(scene, &material, nullptr), TYN_OK);
  TynMedium medium = tyn_medium();
  EXPECT_EQ(tyn_scene_add_medium(scene, &medium, nullptr), TYN_OK);
  scene.add(icosphere(1), 0, 0);
  MeshData box_data = cube();
  std::vector<uint32_t> materials(12, 0);
  materials[5] = TYN_NONE;
  TynMesh view = box_data.view();
  view.triangle_materials = materials.data();
  ASSERT_EQ(tyn_scene_add_mesh(scene, &view, nullptr), TYN_OK) << scene.message();
  scene.add(quad(3));
  scene.commit();

  ASSERT_EQ(scene->mesh_records.size(), 3u);
  const TynMeshRecord &sphere = scene->mesh_records[0], &box_record = scene->mesh_records[1],
                      &flat = scene->mesh_records[2];
  EXPECT_EQ(sphere.flags, TYN_MESH_HAS_NORMALS | TYN_MESH_CLOSED);
  EXPECT_EQ(box_record.flags, TYN_MESH_CLOSED);
  EXPECT_EQ(flat.flags, TYN_MESH_HAS_UVS);
  EXPECT_EQ(sphere.medium, 0u);
  EXPECT_EQ(flat.medium, TYN_NONE);
  EXPECT_EQ(box_record.first_triangle, 80u);
  EXPECT_EQ(flat.first_triangle, 92u);
  EXPECT_EQ(box_record.slack, std::ldexp(1.0f, -20));
  EXPECT_EQ(box_record.upper[1], 1.0f + box_record.slack);
  EXPECT_EQ(scene->triangle_count, 94u);

  std::vector<TynTriangleRecord> records(94);
  scene->context.read(scene->buffers.triangles, records.data(), records.size() * sizeof(TynTriangleRecord));
  EXPECT_EQ(records[80].vertex[0], 42u + box_data.indices[0]);
  EXPECT_EQ(records[80].mesh, 1u);
  EXPECT_EQ(records[80].material, 0u);
  EXPECT_EQ(records[85].material, 1u) << "the default material comes after the caller's";
  EXPECT_EQ(records[93].material, 1u);
  ASSERT_EQ(scene->materials.size(), 2u);
  EXPECT_EQ(scene->materials[1].value.roughness, 1.0f);
  EXPECT_EQ(scene->buffers.normals.size(), scene->buffers.positions.size());
}

TEST(SceneCommit, ComputesExtinctionAndAlbedo) {
  TynMedium medium = tyn_medium();
  medium.sigma_a[0] = 1, medium.sigma_s[0] = 3;
  medium.sigma_s[1] = 1e-30f;
  medium.g = -0.5f;
  medium.ior = 1.25f;
  const TynMediumRecord record = tyn::medium_record(medium);
  EXPECT_EQ(record.sigma_t[0], 4.0f);
  EXPECT_EQ(record.albedo[0], 0.75f);
  EXPECT_EQ(record.albedo[1], 1.0f);
  EXPECT_EQ(record.sigma_t[2], 0.0f);
  EXPECT_EQ(record.albedo[2], 0.0f);
  EXPECT_EQ(record.g, -0.5f);
  EXPECT_EQ(record.ior, 1.25f);
}

TEST(SceneCommit, MakesTheSceneReadOnly) {
  Context context;
  Scene scene(context);
  const MeshData data = cube();
  const TynMesh mesh = data.view();
  scene.add(data);
  scene.commit();
  EXPECT_EQ(tyn_scene_commit(scene), TYN_ERROR_INVALID_OPERATION);
  EXPECT_EQ(tyn_scene_add_mesh(scene, &mesh, nullptr), TYN_ERROR_INVALID_OPERATION);
  EXPECT_EQ(tyn_scene_clear_lights(scene), TYN_ERROR_INVALID_OPERATION);
  const TynEnvironment environment = tyn_environment();
  EXPECT_EQ(tyn_scene_set_environment(scene, &environment), TYN_ERROR_INVALID_OPERATION);
  EXPECT_EQ(scene.info().mesh_count, 1u);
}

TEST(SceneCommit, ThatDoesNotFitInMemoryChangesNothing) {
  TynContextOptions options = tyn_context_options();
  options.memory_limit = 100000;
  Context context(options);
  Scene scene(context);
  scene.add(icosphere(5)); // 20480 triangles of 20 bytes alone
  EXPECT_EQ(tyn_scene_commit(scene), TYN_ERROR_OUT_OF_MEMORY) << scene.message();
  EXPECT_FALSE(scene->committed);
  EXPECT_EQ(scene->materials.size(), 0u);
  EXPECT_EQ(scene->context.memory_available(), 100000u);
}

// All corners of the bounds are in front of the camera and inside its field of view, and one is near the border.
void expect_framed(const TynSceneInfo &info, const TynCamera &camera, double aspect_ratio) {
  const float *m = camera.world_from_camera;
  const double tan_y = std::tan(camera.yfov / 2.0), tan_x = tan_y * aspect_ratio;
  double widest = 0;
  for (int corner = 0; corner < 8; corner++) {
    double p[3], local[3];
    for (int k = 0; k < 3; k++)
      p[k] = (corner >> k & 1 ? info.upper[k] : info.lower[k]) - double(m[4 * k + 3]);
    for (int k = 0; k < 3; k++)
      local[k] = p[0] * m[k] + p[1] * m[4 + k] + p[2] * m[8 + k];
    ASSERT_LT(local[2], 0);
    widest = std::max({widest, std::abs(local[0] / local[2]) / tan_x, std::abs(local[1] / local[2]) / tan_y});
  }
  EXPECT_LT(widest, 1);
  EXPECT_GT(widest, 0.9);
}

TEST(SceneFrame, ShowsTheWholeSceneInEveryShapeOfFilm) {
  Context context;
  for (const MeshData &mesh : {cube(), box(10, 1, 1), box(1, 10, 1), translated(icosphere(3), 50, 0, -7), quad(4)}) {
    Scene scene(context);
    scene.add(mesh);
    for (float aspect_ratio : {0.3f, 1.0f, 16.0f / 9}) {
      TynCamera camera{};
      ASSERT_EQ(tyn_scene_frame(scene, aspect_ratio, &camera), TYN_OK) << scene.message();
      expect_framed(scene.info(), camera, aspect_ratio);
      EXPECT_GT(camera.world_from_camera[7], 0.0f) << "slightly above";
      EXPECT_EQ(tyn_scene_add_camera(scene, &camera, nullptr), TYN_OK) << scene.message();
    }
  }
}

TEST(SceneFrame, ScalesWithTheSceneBitByBit) {
  Context context;
  Scene scene(context), large(context);
  scene.add(bumpy_sphere(2, 0.2f));
  large.add(scaled(bumpy_sphere(2, 0.2f), 4));
  TynCamera a{}, b{};
  ASSERT_EQ(tyn_scene_frame(scene, 1.5f, &a), TYN_OK);
  ASSERT_EQ(tyn_scene_frame(large, 1.5f, &b), TYN_OK);
  for (int i = 0; i < 12; i++)
    EXPECT_EQ(b.world_from_camera[i], a.world_from_camera[i] * (i % 4 == 3 ? 4 : 1));
}

TEST(SceneFrame, LooksAtASinglePoint) {
  Context context;
  Scene scene(context);
  MeshData point = single_triangle();
  point.indices = {0, 0, 0};
  scene.add(point);
  TynCamera camera{};
  EXPECT_EQ(tyn_scene_frame(scene, 1, &camera), TYN_OK);
  EXPECT_TRUE(std::isfinite(camera.world_from_camera[11]));
}

} // namespace
