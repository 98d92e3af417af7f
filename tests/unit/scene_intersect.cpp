// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstring>
#include <random>

#include "common/handles.hpp"
#include "scene/scene.hpp"
#include "tyndall/tyndall_cl.h"

using namespace tyn_test;

namespace {

TynRay ray_to(float ox, float oy, float oz, float dx, float dy, float dz) {
  const float size = std::sqrt(dx * dx + dy * dy + dz * dz);
  return {{ox, oy, oz}, 0, {dx / size, dy / size, dz / size}, INFINITY};
}

TynHit hit_of(TynScene *scene, const TynRay &ray, uint32_t mesh = TYN_NONE) {
  TynHit hit{};
  EXPECT_EQ(tyn_intersect(scene, mesh, &ray, 1, &hit), TYN_OK) << tyn_context_message(tyn_scene_context(scene));
  return hit;
}

bool occluded(TynScene *scene, const TynRay &ray, uint32_t mesh = TYN_NONE) {
  uint32_t result = 7;
  EXPECT_EQ(tyn_occluded(scene, mesh, &ray, 1, &result), TYN_OK);
  EXPECT_LE(result, 1u);
  return result != 0;
}

std::vector<TynRay> random_rays(size_t count) {
  std::mt19937 random(5);
  std::normal_distribution<float> normal;
  std::vector<TynRay> rays;
  for (size_t i = 0; i < count; i++)
    rays.push_back(
        ray_to(normal(random), normal(random), normal(random), normal(random), normal(random), normal(random)));
  return rays;
}

TEST(Intersect, TellsWhatWasHitAndWhere) {
  Context context;
  Scene scene(context);
  scene.add(translated(cube(), 10, 0, 0));
  scene.add(single_triangle());
  scene.commit();
  const TynHit hit = hit_of(scene, ray_to(0.25f, 0.5f, 3, 0, 0, -1));
  EXPECT_EQ(hit.t, 3.0f);
  EXPECT_EQ(hit.mesh, 1u);
  EXPECT_EQ(hit.triangle, 0u);
  EXPECT_EQ(hit.u, 0.25f);
  EXPECT_EQ(hit.v, 0.5f);
  EXPECT_EQ(hit.normal[0], 0.0f);
  EXPECT_EQ(hit.normal[1], 0.0f);
  EXPECT_EQ(hit.normal[2], 1.0f);
  // from behind: the same normal
  const TynHit back = hit_of(scene, ray_to(0.25f, 0.5f, -3, 0, 0, 1));
  EXPECT_EQ(back.t, 3.0f);
  EXPECT_EQ(back.normal[2], 1.0f);
}

TEST(Intersect, ReportsAMiss) {
  Context context;
  Scene scene(context);
  scene.add(cube());
  scene.commit();
  const TynRay ray = ray_to(3, 0, 0, 1, 0, 0);
  const TynHit hit = hit_of(scene, ray);
  EXPECT_EQ(hit.t, INFINITY);
  EXPECT_EQ(hit.mesh, TYN_NONE);
  EXPECT_EQ(hit.triangle, TYN_NONE);
  EXPECT_FALSE(occluded(scene, ray));
}

TEST(Intersect, RespectsTheRangeOfTheRay) {
  Context context;
  Scene scene(context);
  scene.add(cube());
  scene.commit();
  TynRay ray = ray_to(-3, 0.25f, 0.125f, 1, 0, 0); // crosses at 2 and 4
  ray.t_max = 1.5f;
  EXPECT_EQ(hit_of(scene, ray).mesh, TYN_NONE);
  EXPECT_FALSE(occluded(scene, ray));
  ray.t_max = 2; // the end belongs to it
  EXPECT_EQ(hit_of(scene, ray).t, 2.0f);
  EXPECT_TRUE(occluded(scene, ray));
  ray.t_min = 2.5f;
  ray.t_max = 100;
  EXPECT_EQ(hit_of(scene, ray).t, 4.0f);
  ray.t_min = 4;
  EXPECT_EQ(hit_of(scene, ray).t, 4.0f);
  ray.t_min = 4.5f;
  EXPECT_EQ(hit_of(scene, ray).mesh, TYN_NONE);
  EXPECT_FALSE(occluded(scene, ray));
}

TEST(Intersect, IsConfinedToOneMeshIfAsked) {
  Context context;
  Scene scene(context);
  scene.add(icosphere(3, 2));
  scene.add(icosphere(3, 1));
  scene.commit();
  const TynRay ray = ray_to(0, 0, 0, 0.3f, 0.2f, 1);
  EXPECT_EQ(hit_of(scene, ray).mesh, 1u);
  EXPECT_NEAR(hit_of(scene, ray, 0).t, 2, 0.02);
  EXPECT_EQ(hit_of(scene, ray, 0).mesh, 0u);
  EXPECT_TRUE(occluded(scene, ray, 0));
}

TEST(Intersect, GivesTiesToTheLowestMeshThenTriangle) {
  Context context;
  Scene scene(context);
  MeshData doubled = quad(2);
  doubled.append(quad(2));
  for (int i = 0; i < 12; i++) // enough that they are spread over leaves
    scene.add(doubled);
  scene.commit();
  const TynHit hit = hit_of(scene, ray_to(0.25f, 1, 0.125f, 0, -1, 0));
  EXPECT_EQ(hit.mesh, 0u);
  EXPECT_LT(hit.triangle, 2u);
  EXPECT_EQ(hit_of(scene, ray_to(0.25f, 1, 0.125f, 0, -1, 0), 7).mesh, 7u);
}

TEST(Intersect, BarycentricCoordinatesBelongToTheCallersWinding) {
  // Every third triangle is turned by the scene; u and v must still weight the vertices that the caller listed.
  const MeshData data = with_flipped(bumpy_sphere(3, 0.2f), 3);
  Context context;
  Scene scene(context);
  const TynMedium medium = tyn_medium(); // without one, nothing is turned
  ASSERT_EQ(tyn_scene_add_medium(scene, &medium, nullptr), TYN_OK);
  scene.add(data, 0);
  EXPECT_GT(scene.info(0).turned_triangles, 100u);
  scene.commit();
  const std::vector<TynRay> rays = random_rays(2000);
  std::vector<TynHit> hits(rays.size());
  ASSERT_EQ(tyn_intersect(scene, 0, rays.data(), rays.size(), hits.data()), TYN_OK);
  size_t turned = 0;
  for (size_t i = 0; i < rays.size(); i++) {
    if (hits[i].mesh == TYN_NONE)
      continue;
    turned += hits[i].triangle % 3 == 0;
    const uint32_t *index = &data.indices[3 * size_t(hits[i].triangle)];
    for (size_t k = 0; k < 3; k++) {
      const float p0 = data.positions[3 * size_t(index[0]) + k], p1 = data.positions[3 * size_t(index[1]) + k],
                  p2 = data.positions[3 * size_t(index[2]) + k];
      const float point = (1 - hits[i].u - hits[i].v) * p0 + hits[i].u * p1 + hits[i].v * p2;
      EXPECT_NEAR(point, rays[i].origin[k] + hits[i].t * rays[i].direction[k], 1e-5);
    }
  }
  EXPECT_GT(turned, 100u);
}

TEST(Intersect, NormalsOfTinyAndHugeTrianglesAreUnitVectors) {
  Context context;
  for (float size : {1e-9f, 1e-4f, 1.0f, 1e9f}) {
    Scene scene(context);
    scene.add(scaled(icosphere(2), size));
    scene.commit();
    const TynHit hit = hit_of(scene, ray_to(0, 0, 0, 0.1f, 0.7f, -0.3f));
    ASSERT_EQ(hit.mesh, 0u) << size;
    const double length = std::hypot(hit.normal[0], hit.normal[1], hit.normal[2]);
    EXPECT_NEAR(length, 1, 1e-6);
    EXPECT_GT(hit.normal[1], 0.8f);
  }
}

TEST(Intersect, OfAMeshWithoutAreaHitsNothing) {
  Context context;
  Scene scene(context);
  MeshData nothing = single_triangle();
  nothing.indices = {0, 1, 0};
  scene.add(nothing);
  scene.commit();
  EXPECT_EQ(hit_of(scene, ray_to(0.5f, 0, 3, 0, 0, -1)).mesh, TYN_NONE);
}

TEST(Intersect, ScaledByAPowerOfTwoChangesNoBit) {
  Context context;
  Scene scene(context), large(context);
  scene.add(bumpy_sphere(4, 0.3f));
  large.add(scaled(bumpy_sphere(4, 0.3f), 32));
  scene.commit();
  large.commit();
  std::vector<TynRay> rays = random_rays(20000);
  std::vector<TynHit> hits(rays.size()), large_hits(rays.size());
  ASSERT_EQ(tyn_intersect(scene, 0, rays.data(), rays.size(), hits.data()), TYN_OK);
  for (TynRay &ray : rays)
    for (float &component : ray.origin)
      component *= 32;
  ASSERT_EQ(tyn_intersect(large, 0, rays.data(), rays.size(), large_hits.data()), TYN_OK);
  for (TynHit &hit : hits)
    hit.t *= 32;
  EXPECT_EQ(std::memcmp(hits.data(), large_hits.data(), hits.size() * sizeof(TynHit)), 0);
}

TEST(Intersect, BatchesThatShrinkToTheMemoryLimitChangeNoBit) {
  TynContextOptions options = tyn_context_options();
  options.memory_limit = 400000;
  Context roomy, tight(options);
  const std::vector<TynRay> rays = random_rays(30000); // 1.9 MB with their hits
  std::vector<TynHit> hits[2];
  std::vector<uint32_t> any[2];
  int i = 0;
  for (const Context *context : {&roomy, &tight}) {
    Scene scene(*context);
    scene.add(icosphere(3));
    scene.commit();
    hits[i].resize(rays.size());
    any[i].resize(rays.size());
    ASSERT_EQ(tyn_intersect(scene, 0, rays.data(), rays.size(), hits[i].data()), TYN_OK) << scene.message();
    ASSERT_EQ(tyn_occluded(scene, 0, rays.data(), rays.size(), any[i].data()), TYN_OK) << scene.message();
    i++;
  }
  EXPECT_EQ(std::memcmp(hits[0].data(), hits[1].data(), rays.size() * sizeof(TynHit)), 0);
  EXPECT_EQ(any[0], any[1]);
}

TEST(Intersect, WithoutRaysDoesNothing) {
  Context context;
  Scene scene(context);
  scene.add(cube());
  scene.commit();
  EXPECT_EQ(tyn_intersect(scene, 0, nullptr, 0, nullptr), TYN_OK);
  EXPECT_EQ(tyn_occluded(scene, 0, nullptr, 0, nullptr), TYN_OK);
}

TEST(IntersectOnBuffers, GivesTheSameBitsAsOnHostPointers) {
  Context context;
  Scene scene(context);
  scene.add(bumpy_sphere(3, 0.2f));
  scene.commit();
  std::vector<TynRay> rays = random_rays(1000);
  std::vector<TynHit> hits(rays.size()), buffer_hits(rays.size());
  std::vector<uint32_t> any(rays.size()), buffer_any(rays.size());
  ASSERT_EQ(tyn_intersect(scene, 0, rays.data(), rays.size(), hits.data()), TYN_OK);
  ASSERT_EQ(tyn_occluded(scene, 0, rays.data(), rays.size(), any.data()), TYN_OK);

  cl_context cl = nullptr;
  cl_command_queue queue = nullptr;
  ASSERT_EQ(tyn_context_cl(context, &cl, &queue, nullptr), TYN_OK);
  cl_mem ray_buffer =
      clCreateBuffer(cl, CL_MEM_READ_ONLY | CL_MEM_COPY_HOST_PTR, rays.size() * sizeof(TynRay), rays.data(), nullptr);
  cl_mem hit_buffer = clCreateBuffer(cl, CL_MEM_READ_WRITE, hits.size() * sizeof(TynHit), nullptr, nullptr);
  cl_mem any_buffer = clCreateBuffer(cl, CL_MEM_READ_WRITE, any.size() * sizeof(uint32_t), nullptr, nullptr);
  EXPECT_EQ(tyn_intersect_cl(scene, 0, ray_buffer, rays.size(), hit_buffer), TYN_OK) << scene.message();
  EXPECT_EQ(tyn_occluded_cl(scene, 0, ray_buffer, rays.size(), any_buffer), TYN_OK) << scene.message();
  clEnqueueReadBuffer(queue, hit_buffer, CL_TRUE, 0, hits.size() * sizeof(TynHit), buffer_hits.data(), 0, nullptr,
                      nullptr);
  clEnqueueReadBuffer(queue, any_buffer, CL_TRUE, 0, any.size() * 4, buffer_any.data(), 0, nullptr, nullptr);
  EXPECT_EQ(std::memcmp(hits.data(), buffer_hits.data(), hits.size() * sizeof(TynHit)), 0);
  EXPECT_EQ(any, buffer_any);

  EXPECT_EQ(tyn_intersect_cl(scene, 0, ray_buffer, rays.size() + 1, hit_buffer), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_intersect_cl(scene, 0, ray_buffer, rays.size(), any_buffer), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_NE(scene.message().find("hits has 4000 bytes"), std::string::npos) << scene.message();
  EXPECT_EQ(tyn_occluded_cl(scene, 0, nullptr, 1, any_buffer), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_intersect_cl(scene, 3, ray_buffer, 1, hit_buffer), TYN_ERROR_INVALID_ARGUMENT);
  clReleaseMemObject(ray_buffer);
  clReleaseMemObject(hit_buffer);
  clReleaseMemObject(any_buffer);
}

TEST(IntersectOnBuffers, RefusesBuffersOfAnotherContext) {
  Context context, other;
  Scene scene(context);
  scene.add(cube());
  scene.commit();
  cl_context own_cl = nullptr, other_cl = nullptr;
  ASSERT_EQ(tyn_context_cl(context, &own_cl, nullptr, nullptr), TYN_OK);
  ASSERT_EQ(tyn_context_cl(other, &other_cl, nullptr, nullptr), TYN_OK);
  ASSERT_NE(own_cl, other_cl);
  cl_mem own = clCreateBuffer(own_cl, CL_MEM_READ_WRITE, 1024, nullptr, nullptr);
  cl_mem foreign = clCreateBuffer(other_cl, CL_MEM_READ_WRITE, 1024, nullptr, nullptr);
  EXPECT_EQ(tyn_intersect_cl(scene, 0, foreign, 1, own), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_NE(scene.message().find("rays belongs to another cl_context"), std::string::npos) << scene.message();
  EXPECT_EQ(tyn_occluded_cl(scene, 0, own, 1, foreign), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_NE(scene.message().find("occluded belongs to another cl_context"), std::string::npos) << scene.message();
  clReleaseMemObject(foreign);
  clReleaseMemObject(own);
}

} // namespace
