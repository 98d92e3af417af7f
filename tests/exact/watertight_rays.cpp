// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// From inside a closed mesh every ray hits: 1e7 rays in all, none may pass between two triangles. Which points are
// inside is decided in double, without any ray: by the solid angle that the mesh fills, and the distance to the
// nearest triangle.
#include <algorithm>
#include <cmath>
#include <random>

#include "common/handles.hpp"
#include "scene/scene.hpp"
#include "scene/vector.hpp"

using namespace tyn_test;
using tyn::Double3;

namespace {

constexpr size_t RAYS = 1000000; // per mesh
constexpr size_t POINTS = 1000;  // that they start from
constexpr double PI = 3.14159265358979323846;

struct Corners {
  Double3 a, b, c;
};

// Relative to `point`.
Corners corners_from(const tyn::Mesh &mesh, size_t triangle, const Double3 &point) {
  const uint32_t *index = &mesh.indices[3 * triangle];
  return {tyn::to_double(mesh.positions[index[0]]) - point, tyn::to_double(mesh.positions[index[1]]) - point,
          tyn::to_double(mesh.positions[index[2]]) - point};
}

// Solid angle of a triangle seen from the origin (Van Oosterom & Strackee 1983, eq. 8).
double solid_angle(const Corners &t) {
  const double a = tyn::length(t.a), b = tyn::length(t.b), c = tyn::length(t.c);
  const double numerator = tyn::dot(t.a, tyn::cross(t.b, t.c));
  const double denominator = a * b * c + tyn::dot(t.a, t.b) * c + tyn::dot(t.b, t.c) * a + tyn::dot(t.c, t.a) * b;
  return 2 * std::atan2(numerator, denominator);
}

double distance_to_segment(const Double3 &p, const Double3 &q) {
  const Double3 d = q - p;
  const double length2 = tyn::dot(d, d);
  const double s = length2 > 0 ? std::min(1.0, std::max(0.0, -tyn::dot(p, d) / length2)) : 0;
  return tyn::length(p + Double3{s * d.x, s * d.y, s * d.z});
}

// From the origin to a triangle.
double distance_to_triangle(const Corners &t) {
  const Double3 n = tyn::cross(t.b - t.a, t.c - t.a);
  auto left_of = [&](const Double3 &p, const Double3 &q) { return tyn::dot(tyn::cross(p, q), n) >= 0; };
  if (tyn::length(n) > 0 && left_of(t.a, t.b) && left_of(t.b, t.c) && left_of(t.c, t.a))
    return std::abs(tyn::dot(n, t.a)) / tyn::length(n);
  return std::min({distance_to_segment(t.a, t.b), distance_to_segment(t.b, t.c), distance_to_segment(t.c, t.a)});
}

// Inside, and not so near the surface that the point's own rounding could put it outside.
bool is_inside(const TynScene &scene, const float (&position)[3]) {
  const Double3 point{position[0], position[1], position[2]};
  const tyn::Mesh &mesh = scene.meshes[0];
  double angle = 0, nearest = INFINITY, largest = 0;
  for (size_t i = 0; i < mesh.indices.size() / 3; i++) {
    const Corners corners = corners_from(mesh, i, point);
    angle += solid_angle(corners);
    nearest = std::min(nearest, distance_to_triangle(corners));
  }
  for (int k = 0; k < 3; k++)
    largest = std::max({largest, std::abs(double(scene.lower[k])), std::abs(double(scene.upper[k]))});
  return std::abs(angle) > 2 * PI && nearest > largest * 0x1p-20;
}

void set_direction(TynRay &ray, double x, double y, double z) {
  const double size = std::hypot(x, y, z);
  ray.direction[0] = float(x / size);
  ray.direction[1] = float(y / size);
  ray.direction[2] = float(z / size);
}

float between(const TynScene &scene, size_t axis, std::mt19937 &random) {
  std::uniform_real_distribution<double> uniform(0, 1);
  return float(scene.lower[axis] + uniform(random) * (double(scene.upper[axis]) - scene.lower[axis]));
}

// The ray's end is a vertex, or the middle of an edge.
Double3 target(const tyn::Mesh &mesh, size_t corner, bool vertex) {
  const Double3 p = tyn::to_double(mesh.positions[mesh.indices[corner]]);
  const Double3 q = tyn::to_double(mesh.positions[mesh.indices[corner / 3 * 3 + (corner + 1) % 3]]);
  return vertex ? p : Double3{0.5 * (p.x + q.x), 0.5 * (p.y + q.y), 0.5 * (p.z + q.z)};
}

std::vector<TynRay> inner_points(const TynScene &scene, std::mt19937 &random) {
  std::vector<TynRay> points;
  for (size_t tries = 0; points.size() < POINTS && tries < 20 * POINTS; tries++) {
    TynRay ray{};
    ray.t_max = INFINITY;
    for (size_t k = 0; k < 3; k++)
      ray.origin[k] = between(scene, k, random);
    if (is_inside(scene, ray.origin))
      points.push_back(ray);
  }
  return points;
}

// From random points inside; every second one goes to a vertex or the middle of an edge, the others anywhere.
std::vector<TynRay> inner_rays(const TynScene &scene, std::mt19937 &random) {
  std::normal_distribution<double> normal;
  const std::vector<TynRay> points = inner_points(scene, random);
  EXPECT_EQ(points.size(), POINTS);
  const tyn::Mesh &mesh = scene.meshes[0];
  std::vector<TynRay> rays(RAYS);
  for (size_t i = 0; i < RAYS; i++) {
    rays[i] = points[i % points.size()];
    if (i / points.size() % 2) {
      const Double3 end = target(mesh, random() % mesh.indices.size(), random() % 2);
      set_direction(rays[i], end.x - rays[i].origin[0], end.y - rays[i].origin[1], end.z - rays[i].origin[2]);
    } else {
      set_direction(rays[i], normal(random), normal(random), normal(random));
    }
  }
  return rays;
}

// Along an axis, exactly through a vertex or the middle of an edge: nothing is rounded on the way there.
std::vector<TynRay> axis_rays(const TynScene &scene, std::mt19937 &random) {
  const tyn::Mesh &mesh = scene.meshes[0];
  std::vector<TynRay> rays;
  for (size_t tries = 0; tries < 4 * POINTS; tries++) {
    const Double3 end = target(mesh, random() % mesh.indices.size(), tries % 2);
    const size_t axis = random() % 3;
    TynRay ray{};
    ray.origin[0] = float(end.x), ray.origin[1] = float(end.y), ray.origin[2] = float(end.z);
    ray.origin[axis] = between(scene, axis, random);
    ray.t_max = INFINITY;
    if (!is_inside(scene, ray.origin))
      continue;
    ray.direction[axis] = 1;
    rays.push_back(ray);
    ray.direction[axis] = -1;
    rays.push_back(ray);
  }
  return rays;
}

size_t count_misses(TynScene *scene, const std::vector<TynRay> &rays) {
  std::vector<TynHit> hits(rays.size());
  std::vector<uint32_t> occluded(rays.size());
  EXPECT_EQ(tyn_intersect(scene, 0, rays.data(), rays.size(), hits.data()), TYN_OK)
      << tyn_context_message(&scene->context);
  EXPECT_EQ(tyn_occluded(scene, 0, rays.data(), rays.size(), occluded.data()), TYN_OK);
  size_t misses = 0;
  for (size_t i = 0; i < rays.size(); i++)
    misses += hits[i].mesh == TYN_NONE || !occluded[i];
  return misses;
}

class Watertight : public ::testing::TestWithParam<NamedMesh> {};

TEST_P(Watertight, NoRayFromInsideMisses) {
  Context context;
  Scene scene(context);
  scene.add(GetParam().mesh);
  scene.commit();
  std::mt19937 random(11);
  EXPECT_EQ(count_misses(scene, inner_rays(*scene.operator->(), random)), 0u);
  EXPECT_EQ(count_misses(scene, axis_rays(*scene.operator->(), random)), 0u);
}

INSTANTIATE_TEST_SUITE_P(Meshes, Watertight, ::testing::ValuesIn(watertight_meshes()),
                         [](const auto &test) { return test_name(test.param); });

} // namespace
