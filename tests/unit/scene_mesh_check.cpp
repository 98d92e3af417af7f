// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "common/meshes.hpp"
#include "scene/mesh_check.hpp"
#include "scene/weld.hpp"

#include <gtest/gtest.h>

using namespace tyn_test;

namespace {

// With a medium inside, unless told otherwise.
tyn::Mesh checked(const MeshData &data, uint32_t medium = 0) {
  tyn::Mesh mesh;
  mesh.medium = medium;
  for (size_t i = 0; i < data.positions.size(); i += 3)
    mesh.positions.push_back({data.positions[i], data.positions[i + 1], data.positions[i + 2]});
  for (size_t i = 0; i < data.normals.size(); i += 3)
    mesh.normals.push_back({data.normals[i], data.normals[i + 1], data.normals[i + 2]});
  mesh.indices = data.indices;
  tyn::check_mesh(mesh);
  return mesh;
}

TEST(MeshCheck, EveryClosedTestMeshIsFoundClosedAndOutward) {
  for (const NamedMesh &named : closed_meshes()) {
    SCOPED_TRACE(named.name);
    const TynMeshInfo info = checked(named.mesh).info;
    EXPECT_EQ(info.closed, 1u);
    EXPECT_EQ(info.boundary_edges, 0u);
    EXPECT_EQ(info.nonmanifold_edges, 0u);
    EXPECT_EQ(info.degenerate_triangles, 0u);
    EXPECT_EQ(info.duplicate_triangles, 0u);
    EXPECT_EQ(info.inverted_components, 0u);
    EXPECT_EQ(info.turned_triangles, 0u);
    EXPECT_EQ(info.components, named.name == "hollow sphere" ? 2u : 1u);
    EXPECT_GT(info.volume, 0);
    EXPECT_NEAR(info.area, named.mesh.area(), 1e-12 * info.area);
    EXPECT_NEAR(info.volume, named.mesh.volume(), 1e-6 * info.volume);
  }
}

TEST(MeshCheck, MeasuresACubeExactly) {
  const TynMeshInfo info = checked(cube()).info;
  EXPECT_EQ(info.area, 24.0);
  EXPECT_EQ(info.volume, 8.0);
  EXPECT_EQ(info.vertex_count, 8u);
  EXPECT_EQ(info.triangle_count, 12u);
  for (int k = 0; k < 3; k++) {
    EXPECT_EQ(info.lower[k], -1.0f);
    EXPECT_EQ(info.upper[k], 1.0f);
  }
}

TEST(MeshCheck, SphereApproachesItsClosedForm) {
  const TynMeshInfo info = checked(icosphere(6)).info;
  EXPECT_NEAR(info.volume, 4.0 / 3.0 * M_PI, 2e-3);
  EXPECT_NEAR(info.area, 4.0 * M_PI, 4e-3);
}

TEST(MeshCheck, VolumeOfAMeshFarFromTheOriginKeepsItsDigits) {
  // Powers of two, so that the moved vertices are exact.
  const TynMeshInfo info = checked(translated(cube(), 4194304, -4194304, 4194304)).info;
  EXPECT_EQ(info.volume, 8.0);
}

TEST(MeshCheck, WeldsVerticesOfEqualPosition) {
  const TynMeshInfo info = checked(unwelded(icosphere(2))).info;
  EXPECT_EQ(info.vertex_count, 960u);
  EXPECT_EQ(info.welded_vertex_count, 162u);
  EXPECT_EQ(info.closed, 1u);
}

TEST(MeshCheck, MinusZeroEqualsZero) {
  const tyn::Welded welded = tyn::weld({{0.0f, 1, -0.0f}, {-0.0f, 1, 0.0f}, {0, 1, 1e-45f}});
  EXPECT_EQ(welded.count, 2u);
  EXPECT_EQ(welded.vertex, (std::vector<uint32_t>{0, 0, 1}));
}

TEST(MeshCheck, CountsBoundaryEdges) {
  const TynMeshInfo triangle = checked(single_triangle()).info;
  EXPECT_EQ(triangle.boundary_edges, 3u);
  EXPECT_EQ(triangle.closed, 0u);
  EXPECT_EQ(checked(quad(1)).info.boundary_edges, 4u);
  MeshData open = cube();
  open.indices.resize(30); // without one triangle pair
  EXPECT_EQ(checked(open).info.boundary_edges, 4u);
  EXPECT_GT(checked(open_hemisphere(3)).info.boundary_edges, 0u);
}

TEST(MeshCheck, CountsNonManifoldEdges) {
  const TynMeshInfo info = checked(three_fins()).info;
  EXPECT_EQ(info.nonmanifold_edges, 1u);
  EXPECT_EQ(info.boundary_edges, 6u);
  EXPECT_EQ(info.components, 1u);
  EXPECT_EQ(info.closed, 0u);
}

TEST(MeshCheck, TwoCubesThatTouchAlongAnEdgeAreNotManifold) {
  MeshData mesh = cube();
  mesh.append(translated(cube(), 2, 2, 0));
  const TynMeshInfo info = checked(mesh).info;
  EXPECT_EQ(info.nonmanifold_edges, 1u);
  EXPECT_EQ(info.boundary_edges, 0u);
  EXPECT_EQ(info.closed, 0u);
}

TEST(MeshCheck, CountsDegenerateAndDuplicateTriangles) {
  const TynMeshInfo degenerate = checked(with_zero_area_triangles(cube())).info;
  EXPECT_EQ(degenerate.degenerate_triangles, 2u);
  EXPECT_EQ(degenerate.closed, 1u) << "triangles with a repeated position have no edges";
  EXPECT_EQ(degenerate.components, 1u);
  MeshData doubled = cube();
  doubled.add_triangle(doubled.indices[1], doubled.indices[2], doubled.indices[0]);
  EXPECT_EQ(checked(doubled).info.duplicate_triangles, 1u);
}

TEST(MeshCheck, ASliverWithThreeVerticesClosesItsSurface) {
  const TynMeshInfo info = checked(cube_with_sliver()).info;
  EXPECT_EQ(info.closed, 1u);
  EXPECT_EQ(info.degenerate_triangles, 1u);
  EXPECT_EQ(info.volume, 8.0);
}

TEST(MeshCheck, TurnsTheMinorityOfTriangles) {
  const MeshData sphere = icosphere(3);
  const tyn::Mesh mesh = checked(with_flipped(sphere, 3));
  EXPECT_EQ(mesh.info.turned_triangles, (sphere.triangle_count() + 2) / 3);
  EXPECT_EQ(mesh.info.inverted_components, 0u);
  EXPECT_EQ(mesh.indices, sphere.indices);
  EXPECT_GT(mesh.info.volume, 4.0);
  EXPECT_EQ(mesh.turned[0], 1u);
  EXPECT_EQ(mesh.turned[1], 0u);
}

TEST(MeshCheck, TurnsAnInsideOutMeshAndItsNormals) {
  const MeshData sphere = icosphere(2);
  const tyn::Mesh mesh = checked(inverted(sphere));
  EXPECT_EQ(mesh.info.inverted_components, 1u);
  EXPECT_EQ(mesh.info.turned_triangles, 0u);
  EXPECT_EQ(mesh.indices, sphere.indices);
  EXPECT_GT(mesh.info.volume, 0);
  for (size_t i = 0; i < mesh.normals.size(); i++)
    EXPECT_EQ(mesh.normals[i].x, sphere.normals[3 * i]);
}

TEST(MeshCheck, LeavesNormalsThatPointOutwardsWhenTheWindingIsInsideOut) {
  MeshData sphere = inverted(icosphere(2));
  sphere.normals = icosphere(2).normals;
  const tyn::Mesh mesh = checked(sphere);
  EXPECT_EQ(mesh.info.inverted_components, 1u);
  EXPECT_EQ(mesh.normals[5].y, sphere.normals[16]);
}

TEST(MeshCheck, KeepsACavityWoundInwards) {
  const MeshData hollow = hollow_sphere(2, 1, 0.5f);
  const tyn::Mesh mesh = checked(hollow);
  EXPECT_EQ(mesh.indices, hollow.indices);
  EXPECT_EQ(mesh.info.components, 2u);
  const double outer = checked(icosphere(2)).info.volume;
  EXPECT_NEAR(mesh.info.volume, outer * (1 - 0.125), 1e-6);
}

TEST(MeshCheck, TurnsAllComponentsOfAnInsideOutHollowSphere) {
  const tyn::Mesh mesh = checked(inverted(hollow_sphere(2, 1, 0.5f)));
  EXPECT_EQ(mesh.info.inverted_components, 2u);
  EXPECT_EQ(mesh.indices, hollow_sphere(2, 1, 0.5f).indices);
}

MeshData with(MeshData mesh, const MeshData &other) {
  mesh.append(other);
  return mesh;
}

TEST(MeshCheck, TurnsAnInsideOutComponentBesideALargerGoodOne) {
  const MeshData small = translated(scaled(cube(), 0.25f), 3, 0, 0);
  const tyn::Mesh mesh = checked(with(cube(), inverted(small)));
  EXPECT_EQ(mesh.info.components, 2u);
  EXPECT_EQ(mesh.info.inverted_components, 1u);
  EXPECT_EQ(mesh.info.turned_triangles, 0u);
  EXPECT_EQ(mesh.indices, with(cube(), small).indices);
  EXPECT_NEAR(mesh.info.volume, 8.125, 1e-12);
  EXPECT_EQ(mesh.turned[11], 0u);
  EXPECT_EQ(mesh.turned[12], 1u);
}

TEST(MeshCheck, TurnsOnlyTheNormalsOfTheInsideOutComponent) {
  const MeshData away = translated(icosphere(1), 3, 0, 0);
  MeshData data = with(inverted(icosphere(1)), away); // and the other's normals point inwards, which is its own affair
  for (size_t i = icosphere(1).normals.size(); i < data.normals.size(); i++)
    data.normals[i] = -data.normals[i];
  const tyn::Mesh mesh = checked(data);
  EXPECT_EQ(mesh.info.inverted_components, 1u);
  const size_t count = icosphere(1).vertex_count();
  EXPECT_EQ(mesh.normals[3].y, icosphere(1).normals[10]);
  EXPECT_EQ(mesh.normals[count + 3].y, -away.normals[10]);
}

TEST(MeshCheck, WhatIsOnlyInsideTheBoxOfAnotherIsNoCavity) {
  const MeshData ring = without_normals(torus(1, 0.3f, 48, 24)), small = scaled(cube(), 0.1f);
  const tyn::Mesh in_the_hole = checked(with(ring, inverted(small)));
  EXPECT_EQ(in_the_hole.info.inverted_components, 1u);
  EXPECT_EQ(in_the_hole.indices, with(ring, small).indices);
  const MeshData cavity = with(ring, inverted(translated(small, 1, 0, 0)));
  EXPECT_EQ(checked(cavity).info.inverted_components, 0u);
  EXPECT_EQ(checked(cavity).indices, cavity.indices);
}

TEST(MeshCheck, ACavityStaysAlsoWhereItComesFirstOrItsShellIsTurned) {
  const MeshData outer = icosphere(2), cavity = inverted(icosphere(2, 0.5f));
  EXPECT_EQ(checked(with(cavity, outer)).info.inverted_components, 0u);
  const tyn::Mesh mesh = checked(with(inverted(outer), cavity));
  EXPECT_EQ(mesh.info.inverted_components, 1u);
  EXPECT_EQ(mesh.indices, with(outer, cavity).indices);
}

TEST(MeshCheck, TurnsNestedShellsThatAreInsideOutTogether) {
  const MeshData good =
      with(without_normals(hollow_sphere(2, 1, 0.5f)), translated(scaled(cube(), 0.125f), 0.1f, 0, 0));
  const tyn::Mesh mesh = checked(with(inverted(good), translated(cube(), 4, 0, 0)));
  EXPECT_EQ(mesh.info.components, 4u);
  EXPECT_EQ(mesh.info.inverted_components, 3u);
  EXPECT_EQ(mesh.indices, with(good, cube()).indices);
  EXPECT_EQ(checked(good).info.inverted_components, 0u);
  EXPECT_EQ(checked(good).indices, good.indices);
}

TEST(MeshCheck, AnOpenComponentDoesNotKeepOthersFromBeingTurned) {
  const MeshData sphere = without_normals(icosphere(2)),
                 open = without_normals(translated(open_hemisphere(2), 4, 0, 0));
  const tyn::Mesh mesh = checked(with(inverted(sphere), inverted(open)));
  EXPECT_EQ(mesh.info.closed, 0u);
  EXPECT_EQ(mesh.info.inverted_components, 1u);
  EXPECT_EQ(mesh.indices, with(sphere, inverted(open)).indices);
}

TEST(MeshCheck, LooksThroughThousandsOfComponents) {
  MeshData many;
  for (int i = 0; i < 8000; i++)
    many.append(inverted(translated(tetrahedron(), 2 * float(i % 20), 2 * float(i / 20 % 20), 2 * float(i / 400))));
  const TynMeshInfo info = checked(many).info;
  EXPECT_EQ(info.components, 8000u);
  EXPECT_EQ(info.inverted_components, 8000u);
  EXPECT_EQ(info.overlapping_components, 0u);
  EXPECT_NEAR(info.volume, 8000.0 / 6, 1e-3);
}

TEST(MeshCheck, WithoutAMediumTheWindingIsTheCallers) {
  const MeshData dome = inverted(icosphere(2)), mixed = with_flipped(icosphere(2), 3);
  for (const MeshData &data : {dome, mixed}) {
    const tyn::Mesh mesh = checked(data, TYN_NONE);
    EXPECT_EQ(mesh.indices, data.indices);
    EXPECT_EQ(mesh.normals[5].y, data.normals[16]);
    EXPECT_EQ(mesh.turned, std::vector<uint8_t>(data.triangle_count(), 0));
    EXPECT_EQ(mesh.info.inverted_components, 0u);
    EXPECT_EQ(mesh.info.turned_triangles, 0u);
    EXPECT_EQ(mesh.info.components, 1u);
    EXPECT_EQ(mesh.info.closed, 1u);
    EXPECT_NEAR(mesh.info.area, data.area(), 1e-9);
  }
  EXPECT_NEAR(checked(dome, TYN_NONE).info.volume, icosphere(2).volume(), 1e-6);
  EXPECT_GT(checked(inverted(open_hemisphere(2)), TYN_NONE).info.boundary_edges, 0u);
}

TEST(MeshCheck, LeavesASurfaceAloneThatCannotBeOriented) {
  const MeshData strip = mobius_strip(24);
  const tyn::Mesh mesh = checked(strip);
  EXPECT_EQ(mesh.indices, strip.indices);
  EXPECT_EQ(mesh.info.closed, 0u);
  EXPECT_EQ(mesh.info.turned_triangles, 0u);
}

TEST(MeshCheck, LeavesAnOpenMeshFacingAsItIs) {
  const MeshData open = inverted(open_hemisphere(2));
  EXPECT_EQ(checked(open).indices, open.indices);
}

TEST(MeshCheck, AMeshOfDegenerateTrianglesOnlyIsNotClosed) {
  MeshData mesh = single_triangle();
  mesh.indices = {0, 0, 0, 1, 1, 2};
  const TynMeshInfo info = checked(mesh).info;
  EXPECT_EQ(info.closed, 0u);
  EXPECT_EQ(info.components, 0u);
  EXPECT_EQ(info.degenerate_triangles, 2u);
  EXPECT_EQ(info.area, 0.0);
}

// What reaches into another, or lies on it, is seen. Cavities, islands in them, and parts that are apart are as they should be.
TEST(MeshCheck, CountsComponentsThatOverlap) {
  for (const NamedMesh &named : hostile_meshes()) {
    SCOPED_TRACE(named.name);
    const TynMeshInfo info = checked(named.mesh).info;
    const bool overlap =
        named.name == "overlapping cubes" || named.name == "a cross" || named.name == "a sphere in a sphere";
    if (overlap) {
      EXPECT_GE(info.overlapping_components, 1u);
      EXPECT_LE(info.overlapping_components, 2u);
    } else if (named.name != "cubes side by side") {
      EXPECT_EQ(info.overlapping_components, 0u);
    }
  }
  for (const NamedMesh &named : closed_meshes())
    EXPECT_EQ(checked(named.mesh).info.overlapping_components, 0u) << named.name;
  const MeshData hollow = without_normals(hollow_sphere(2, 1, 0.5f)), island = scaled(cube(), 0.125f);
  EXPECT_EQ(checked(with(hollow, island)).info.overlapping_components, 0u);
  EXPECT_EQ(checked(with(inverted(hollow), inverted(island))).info.overlapping_components, 0u);
  EXPECT_EQ(checked(with(hollow, translated(island, 0.75f, 0, 0))).info.overlapping_components, 1u); // in the solid
  EXPECT_EQ(checked(with(cube(), translated(cube(), 1.1f, 0.9f, 0.7f)), TYN_NONE).info.overlapping_components, 0u);
  EXPECT_EQ(checked(with(torus(1, 0.3f, 48, 24), without_normals(torus(1, 0.3f, 48, 24)))).info.closed, 0u);
}

} // namespace
