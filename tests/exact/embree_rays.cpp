// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The kernel's rays against Embree's: the same triangle, or the same distance. Both round differently, so a ray that
// passes an edge within rounding may see either of its sides; such rays are told apart in double.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

#include "common/embree_oracle.hpp"
#include "common/handles.hpp"
#include "scene/vector.hpp"
#ifdef TYN_TEST_IO
#include "tyndall/tyndall_io.h"
#endif

using namespace tyn_test;
using tyn::Double3;

namespace {

constexpr size_t RAYS = 1000000;

float extent_of(const TynScene &scene) {
  float extent = 0;
  for (int k = 0; k < 3; k++)
    extent = std::max({extent, std::abs(scene.lower[k]), std::abs(scene.upper[k])});
  return extent;
}

// Half of them in any direction, half towards a point in the bounds; from inside and around the bounds.
std::vector<TynRay> random_rays(const TynScene &scene, size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::normal_distribution<double> normal;
  std::vector<TynRay> rays(count);
  for (size_t i = 0; i < count; i++) {
    double d[3], size = 0;
    for (int k = 0; k < 3; k++) {
      const double low = scene.lower[k], width = double(scene.upper[k]) - low;
      rays[i].origin[k] = float(low + width * (2 * uniform(random) - 0.5));
      d[k] = i % 2 ? normal(random) : low + width * uniform(random) - rays[i].origin[k];
      size += d[k] * d[k];
    }
    for (int k = 0; k < 3; k++)
      rays[i].direction[k] = float(d[k] / std::sqrt(size));
    rays[i].t_min = 0;
    rays[i].t_max = i % 7 ? INFINITY : float(uniform(random) * 2 * (scene.upper[0] - scene.lower[0]));
  }
  return rays;
}

Double3 at(const float (&v)[3]) { return {v[0], v[1], v[2]}; }

// How far the ray misses the nearest edge of a triangle, over the size of the numbers that rounding acts on.
double edge_distance(const tyn::Mesh &mesh, uint32_t triangle, const TynRay &ray, double scale) {
  double nearest = INFINITY;
  const Double3 o = at(ray.origin), d = at(ray.direction);
  for (size_t k = 0; k < 3; k++) {
    const Double3 p = tyn::to_double(mesh.positions[mesh.indices[3 * size_t(triangle) + k]]);
    const Double3 q = tyn::to_double(mesh.positions[mesh.indices[3 * size_t(triangle) + (k + 1) % 3]]);
    const Double3 n = tyn::cross(d, q - p);
    if (tyn::length(n) > 0)
      nearest = std::min(nearest, std::abs(tyn::dot(n, p - o)) / tyn::length(n));
  }
  return nearest / scale;
}

// What rounding of coordinates of size `scale` may do to the distance: more on a triangle that is seen edge-on, and
// more on a thin one, whose barycentric coordinates are differences of large numbers.
double distance_tolerance(const tyn::Mesh &mesh, uint32_t triangle, const TynRay &ray, double scale) {
  const Double3 n = tyn::area_vector(mesh, triangle);
  double longest = 0;
  for (size_t k = 0; k < 3; k++) {
    const Double3 p = tyn::to_double(mesh.positions[mesh.indices[3 * size_t(triangle) + k]]);
    const Double3 q = tyn::to_double(mesh.positions[mesh.indices[3 * size_t(triangle) + (k + 1) % 3]]);
    longest = std::max(longest, tyn::length(q - p));
  }
  const double steepness = tyn::length(n) / std::abs(tyn::dot(n, at(ray.direction)));
  const double thinness = longest * longest / tyn::length(n);
  return scale * 0x1p-20 * steepness * thinness;
}

// Where the ray meets the triangle's plane.
double exact_distance(const tyn::Mesh &mesh, uint32_t triangle, const TynRay &ray) {
  const Double3 n = tyn::area_vector(mesh, triangle);
  const Double3 p = tyn::to_double(mesh.positions[mesh.indices[3 * size_t(triangle)]]);
  return tyn::dot(n, p - at(ray.origin)) / tyn::dot(n, at(ray.direction));
}

bool near_an_edge(const TynScene &scene, const TynHit &hit, const TynRay &ray, double scale) {
  return hit.mesh != TYN_NONE && edge_distance(scene.meshes[hit.mesh], hit.triangle, ray, scale) < 0x1p-20;
}

bool agree(const TynScene &scene, const TynRay &ray, const TynHit &ours, const TynHit &theirs) {
  if (ours.mesh == TYN_NONE && theirs.mesh == TYN_NONE)
    return true;
  double scale = extent_of(scene);
  for (float component : ray.origin)
    scale = std::max(scale, std::abs(double(component)));
  if (ours.mesh != TYN_NONE && theirs.mesh != TYN_NONE) {
    const double tolerance = distance_tolerance(scene.meshes[ours.mesh], ours.triangle, ray, scale);
    if (std::abs(ours.t - exact_distance(scene.meshes[ours.mesh], ours.triangle, ray)) > tolerance)
      return false;
    if (ours.mesh == theirs.mesh && ours.triangle == theirs.triangle)
      return true;
    if (std::abs(double(ours.t) - theirs.t) <= tolerance)
      return true;
  }
  // One of them passed an edge, or the end of the ray, on the other side.
  if (near_an_edge(scene, ours, ray, scale) || near_an_edge(scene, theirs, ray, scale))
    return true;
  const double end = std::min(ours.t, theirs.t);
  return std::abs(end - ray.t_max) <= scale * 0x1p-20 || end <= scale * 0x1p-20;
}

void compare(TynScene *scene, unsigned seed) {
  const std::vector<TynRay> rays = random_rays(*scene, RAYS, seed);
  std::vector<TynHit> hits(RAYS);
  std::vector<uint32_t> occluded(RAYS);
  ASSERT_EQ(tyn_intersect(scene, TYN_NONE, rays.data(), RAYS, hits.data()), TYN_OK)
      << tyn_context_message(&scene->context);
  ASSERT_EQ(tyn_occluded(scene, TYN_NONE, rays.data(), RAYS, occluded.data()), TYN_OK);
  const EmbreeOracle oracle(scene->meshes);
  size_t wrong = 0, others = 0, hit_count = 0, wrong_occlusion = 0;
  for (size_t i = 0; i < RAYS; i++) {
    const TynHit theirs = oracle.intersect(rays[i]);
    hit_count += hits[i].mesh != TYN_NONE;
    others += hits[i].mesh != theirs.mesh || hits[i].triangle != theirs.triangle;
    if (!agree(*scene, rays[i], hits[i], theirs) && wrong++ < 5)
      ADD_FAILURE() << "ray " << i << ": t " << hits[i].t << " triangle " << hits[i].triangle << ", Embree t "
                    << theirs.t << " triangle " << theirs.triangle;
    wrong_occlusion += occluded[i] != (hits[i].mesh != TYN_NONE);
  }
  EXPECT_EQ(wrong, 0u);
  EXPECT_EQ(wrong_occlusion, 0u);
  EXPECT_GT(hit_count, RAYS / 10);
  // Ties and edges only: far below what a defect would show.
  EXPECT_LT(others, RAYS / 1000) << "other triangles than Embree's";
  ::testing::Test::RecordProperty("hits", int(hit_count));
  ::testing::Test::RecordProperty("other_triangles", int(others));
}

class EmbreeRays : public ::testing::TestWithParam<NamedMesh> {};

TEST_P(EmbreeRays, HitTheSameTriangleOrTheSameDistance) {
  Context context;
  Scene scene(context);
  scene.add(GetParam().mesh);
  scene.commit();
  compare(scene, 1);
}

std::vector<NamedMesh> meshes() {
  return {{"BumpySphere", bumpy_sphere(5, 0.3f)},
          {"Torus", torus(1, 0.4f, 64, 32)},
          {"HollowSphere", hollow_sphere(4, 1, 0.6f)},
          {"Needles", needles(200, 20)},
          {"FarAwaySphere", translated(icosphere(4), 1000, -2000, 500)}};
}

INSTANTIATE_TEST_SUITE_P(Meshes, EmbreeRays, ::testing::ValuesIn(meshes()),
                         [](const auto &test) { return test.param.name; });

TEST(EmbreeRaysOfAScene, HitTheSameMeshAmongMany) {
  Context context;
  Scene scene(context);
  std::mt19937 random(3);
  std::uniform_real_distribution<float> place(-4, 4);
  for (int i = 0; i < 60; i++)
    scene.add(
        translated(i % 2 ? icosphere(2) : torus(0.7f, 0.2f, 24, 12), place(random), place(random), place(random)));
  scene.commit();
  compare(scene, 2);
}

#ifdef TYN_TEST_IO
class EmbreeRaysOfAModel : public ::testing::TestWithParam<const char *> {};

TEST_P(EmbreeRaysOfAModel, HitTheSameTriangleOrTheSameDistance) {
  const char *folder = std::getenv("TYNDALL_TEST_DATA");
  if (!folder)
    GTEST_SKIP() << "TYNDALL_TEST_DATA names no folder with test models";
  const std::string path = std::string(folder) + "/" + GetParam() + ".glb";
  if (FILE *file = std::fopen(path.c_str(), "rb"))
    std::fclose(file);
  else
    GTEST_SKIP() << path << " is not there";
  Context context;
  Scene scene(context);
  ASSERT_EQ(tyn_gltf_load(scene, path.c_str(), nullptr), TYN_OK) << context.message();
  scene.commit();
  compare(scene, 4);
}

INSTANTIATE_TEST_SUITE_P(Models, EmbreeRaysOfAModel, ::testing::Values("head", "nefertiti"),
                         [](const auto &test) { return std::string(test.param); });
#endif

} // namespace
