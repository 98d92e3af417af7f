// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Meshes and rays that must be refused: the right status, a message that names the element, and a scene as it was.
#include <cmath>
#include <limits>

#include "common/handles.hpp"
#include "scene/scene.hpp"

using namespace tyn_test;

namespace {

class BadMesh : public ::testing::Test {
protected:
  // `text`: part of the message
  void expect_refused(const TynMesh &mesh, const char *text) {
    uint32_t index = 1234;
    EXPECT_EQ(tyn_scene_add_mesh(scene, &mesh, &index), TYN_ERROR_INVALID_ARGUMENT);
    EXPECT_NE(scene.message().find(text), std::string::npos) << scene.message();
    EXPECT_EQ(index, 1234u);
    EXPECT_EQ(scene.info().mesh_count, 0u);
  }

  Context context;
  Scene scene{context};
  MeshData data = icosphere(1);
};

TEST_F(BadMesh, NanPosition) {
  data.positions[7 * 3 + 1] = NAN;
  expect_refused(data.view(), "positions[7].y is nan");
}

TEST_F(BadMesh, InfinitePosition) {
  data.positions[2] = -INFINITY;
  expect_refused(data.view(), "positions[0].z is -inf");
}

TEST_F(BadMesh, PositionTooFarAway) {
  data.positions[0] = 1e20f;
  expect_refused(data.view(), "positions[0].x is 1e+20");
}

TEST_F(BadMesh, NanNormal) {
  data.normals[4] = NAN;
  expect_refused(data.view(), "normals[1].y is nan");
}

TEST_F(BadMesh, NanTextureCoordinate) {
  data.uvs.assign(2 * data.vertex_count(), 0.5f);
  data.uvs[9] = NAN;
  expect_refused(data.view(), "uvs[4]");
}

TEST_F(BadMesh, IndexOutOfRange) {
  data.indices[10] = data.vertex_count();
  expect_refused(data.view(), "indices[10] (triangle 3) is 42");
}

TEST_F(BadMesh, LargestIndex) {
  data.indices[0] = TYN_NONE;
  expect_refused(data.view(), "indices[0]");
}

TEST_F(BadMesh, WithoutTriangles) {
  TynMesh mesh = data.view();
  mesh.triangle_count = 0;
  expect_refused(mesh, "triangle_count");
}

TEST_F(BadMesh, WithoutVertices) {
  TynMesh mesh = data.view();
  mesh.vertex_count = 0;
  expect_refused(mesh, "vertex_count");
  mesh.vertex_count = 2;
  expect_refused(mesh, "vertex_count is 2");
}

TEST_F(BadMesh, NullArrays) {
  TynMesh mesh = data.view();
  mesh.positions = nullptr;
  expect_refused(mesh, "TynMesh::positions is NULL");
  mesh = data.view();
  mesh.indices = nullptr;
  expect_refused(mesh, "TynMesh::indices is NULL");
  EXPECT_EQ(tyn_scene_add_mesh(scene, nullptr, nullptr), TYN_ERROR_INVALID_ARGUMENT);
}

TEST_F(BadMesh, MoreThanTheSceneCanHold) {
  TynMesh mesh = data.view();
  mesh.triangle_count = 0xffffffffu;
  expect_refused(mesh, "triangle_count is 4294967295");
  mesh = data.view();
  mesh.vertex_count = 0xffffffffu;
  expect_refused(mesh, "vertex_count is 4294967295");
}

TEST_F(BadMesh, StrideTooSmallOrOverflowing) {
  TynMesh mesh = data.view();
  mesh.position_stride = 8;
  expect_refused(mesh, "position_stride is 8");
  mesh.position_stride = std::numeric_limits<size_t>::max() / 2;
  expect_refused(mesh, "overflow");
  mesh = data.view();
  mesh.normal_stride = 4;
  expect_refused(mesh, "normal_stride is 4");
}

TEST_F(BadMesh, UnknownMediumOrMaterial) {
  TynMesh mesh = data.view();
  mesh.medium = 0;
  expect_refused(mesh, "TynMesh::medium is 0, but the scene has 0 media");
  mesh = data.view();
  mesh.material = 3;
  expect_refused(mesh, "TynMesh::material is 3");
  mesh = data.view();
  std::vector<uint32_t> materials(data.triangle_count(), TYN_NONE);
  materials[5] = 9;
  mesh.triangle_materials = materials.data();
  expect_refused(mesh, "triangle_materials[5] is 9");
}

TEST_F(BadMesh, StructOfAnotherSize) {
  TynMesh mesh = data.view();
  mesh.size = 0;
  expect_refused(mesh, "TynMesh::size is 0");
  mesh.size = sizeof(TynMesh) + 8;
  expect_refused(mesh, "later version");
}

TEST_F(BadMesh, ZeroAreaTrianglesAreReportedNotRefused) {
  scene.add(with_zero_area_triangles(data));
  EXPECT_EQ(scene.info(0).degenerate_triangles, 2u);
  scene.commit();
}

TEST_F(BadMesh, OnlyZeroAreaTrianglesRenderAsNothing) {
  MeshData flat = single_triangle();
  flat.indices = {0, 0, 0, 1, 1, 1};
  scene.add(flat);
  scene.commit();
  EXPECT_EQ(scene.info(0).closed, 0u);
}

TEST_F(BadMesh, OpenInsideOutAndNonManifoldMeshesAreReportedNotRefused) {
  TynMedium medium = tyn_medium();
  uint32_t inside = TYN_NONE;
  ASSERT_EQ(tyn_scene_add_medium(scene, &medium, &inside), TYN_OK) << scene.message();
  scene.add(open_hemisphere(2));
  scene.add(inverted(cube()), inside); // without a medium a mesh keeps its winding
  scene.add(three_fins());
  scene.add(mobius_strip(8));
  scene.commit();
  EXPECT_EQ(scene.info(0).closed, 0u);
  EXPECT_EQ(scene.info(1).inverted_components, 1u);
  EXPECT_EQ(scene.info(2).nonmanifold_edges, 1u);
}

TEST_F(BadMesh, CommitOfAnEmptySceneIsRefused) {
  EXPECT_EQ(tyn_scene_commit(scene), TYN_ERROR_INVALID_OPERATION);
  EXPECT_NE(scene.message().find("no mesh"), std::string::npos);
  scene.add(data);
  EXPECT_EQ(tyn_scene_commit(scene), TYN_OK);
}

TEST_F(BadMesh, InfoOfAMeshThatIsNotThere) {
  TynMeshInfo info{};
  info.size = sizeof info;
  EXPECT_EQ(tyn_scene_mesh_info(scene, 0, &info), TYN_ERROR_INVALID_ARGUMENT);
  scene.add(data);
  EXPECT_EQ(tyn_scene_mesh_info(scene, 0, nullptr), TYN_ERROR_INVALID_ARGUMENT);
  info.size = 0;
  EXPECT_EQ(tyn_scene_mesh_info(scene, 0, &info), TYN_ERROR_INVALID_ARGUMENT);
}

class BadRay : public BadMesh {
protected:
  void SetUp() override {
    scene.add(data);
    scene.commit();
  }
  void expect_ray_refused(const TynRay &bad, const char *text) {
    TynRay rays[3];
    for (TynRay &ray : rays)
      ray = {{0, 0, 0}, 0, {0, 0, 1}, INFINITY};
    rays[2] = bad;
    TynHit hits[3];
    uint32_t occluded[3];
    EXPECT_EQ(tyn_intersect(scene, 0, rays, 3, hits), TYN_ERROR_INVALID_ARGUMENT);
    EXPECT_NE(scene.message().find(std::string("rays[2].") + text), std::string::npos) << scene.message();
    EXPECT_EQ(tyn_occluded(scene, 0, rays, 3, occluded), TYN_ERROR_INVALID_ARGUMENT);
  }
};

TEST_F(BadRay, NotFinite) {
  expect_ray_refused({{0, NAN, 0}, 0, {0, 0, 1}, 1}, "origin[1] is nan");
  expect_ray_refused({{0, 0, INFINITY}, 0, {0, 0, 1}, 1}, "origin[2] is inf");
  expect_ray_refused({{0, 0, 0}, 0, {NAN, 0, 1}, 1}, "direction[0] is nan");
}

TEST_F(BadRay, DirectionNotOfUnitLength) {
  expect_ray_refused({{0, 0, 0}, 0, {0, 0, 0}, 1}, "direction");
  expect_ray_refused({{0, 0, 0}, 0, {0, 1, 1}, 1}, "direction");
}

TEST_F(BadRay, EmptyRange) {
  expect_ray_refused({{0, 0, 0}, -1, {0, 0, 1}, 1}, "t_min is -1");
  expect_ray_refused({{0, 0, 0}, NAN, {0, 0, 1}, 1}, "t_min is nan");
  expect_ray_refused({{0, 0, 0}, 2, {0, 0, 1}, 2}, "t_max is 2");
  expect_ray_refused({{0, 0, 0}, 2, {0, 0, 1}, NAN}, "t_max is nan");
}

TEST_F(BadRay, NullArraysAndUnknownMesh) {
  const TynRay ray = {{0, 0, 0}, 0, {0, 0, 1}, 1};
  TynHit hit;
  EXPECT_EQ(tyn_intersect(scene, 0, nullptr, 1, &hit), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_intersect(scene, 0, &ray, 1, nullptr), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_intersect(scene, 1, &ray, 1, &hit), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_NE(scene.message().find("mesh is 1, but the scene has 1 meshes"), std::string::npos) << scene.message();
}

TEST(BadCall, RaysBeforeCommit) {
  Context context;
  Scene scene(context);
  scene.add(cube());
  const TynRay ray = {{0, 0, 0}, 0, {0, 0, 1}, 1};
  TynHit hit;
  EXPECT_EQ(tyn_intersect(scene, 0, &ray, 1, &hit), TYN_ERROR_INVALID_OPERATION);
  EXPECT_NE(scene.message().find("not committed"), std::string::npos);
}

} // namespace
