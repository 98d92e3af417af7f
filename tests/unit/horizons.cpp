// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Flights that start on a triangle above its horizon: Embree finds nothing in their way.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "common/embree_oracle.hpp"
#include "common/walk_scene.hpp"
#include "scene/vector.hpp"

namespace {

using namespace tyn_test;
using tyn::Double3;

Double3 scaled(const Double3 &v, double s) { return {v.x * s, v.y * s, v.z * s}; }

struct Counts {
  int flights = 0, met = 0;
};

// Flights whose inward component is the horizon's times `times`, or more.
Counts fly(const MeshData &data, double times, bool steeper, int count) {
  SceneHandle scene = make_scene(shared_context(), data, grey_medium(0, 1));
  const tyn::Mesh &mesh = scene->meshes[0];
  const TynMeshRecord &record = scene->mesh_records[0];
  std::vector<TynTriangleRecord> triangles(scene->triangle_count);
  shared_context()->read(scene->buffers.triangles, triangles.data(), triangles.size() * sizeof triangles[0]);
  EmbreeOracle oracle(scene->meshes);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform;
  Counts counts;
  for (int i = 0; i < count; ++i) {
    const size_t triangle = random() % triangles.size();
    if (triangles[triangle].horizon >= 1)
      continue;
    Double3 corner[3];
    for (size_t k = 0; k < 3; ++k)
      corner[k] = tyn::to_double(mesh.positions[mesh.indices[3 * triangle + k]]);
    const Double3 normal = tyn::area_vector(mesh, triangle), edge = corner[1] - corner[0];
    const Double3 up = scaled(normal, -1 / tyn::length(normal)), x = scaled(edge, 1 / tyn::length(edge));
    const Double3 y = tyn::cross(up, x);
    // anywhere on it, often close to its edges
    double u = uniform(random), v = uniform(random) * (1 - u);
    u *= random() % 3 ? 1 : 1e-3;
    v *= random() % 3 ? 1 : 1e-3;
    const Double3 p = scaled(corner[0], 1 - u - v) + scaled(corner[1], u) + scaled(corner[2], v) +
                      scaled(up, 0.25 * double(record.slack)); // as walks start
    const double least = times * double(triangles[triangle].horizon);
    const double sine = steeper && random() % 2 ? least + (1 - least) * uniform(random) : least;
    const double cosine = std::sqrt(1 - sine * sine), angle = 6.283185307 * uniform(random);
    const Double3 d = scaled(up, sine) + scaled(x, cosine * std::cos(angle)) + scaled(y, cosine * std::sin(angle));
    TynRay ray{};
    ray.origin[0] = float(p.x), ray.origin[1] = float(p.y), ray.origin[2] = float(p.z);
    ray.direction[0] = float(d.x), ray.direction[1] = float(d.y), ray.direction[2] = float(d.z);
    ray.t_min = 2 * record.slack;
    ray.t_max = record.horizon_reach;
    counts.met += oracle.occluded(ray);
    ++counts.flights;
  }
  return counts;
}

TEST(Horizons, HideNothingAboveThem) {
  int flights = 0;
  for (const NamedMesh &named : walked_meshes()) {
    SCOPED_TRACE(named.name);
    const Counts counts = fly(named.mesh, 1, true, 20000);
    EXPECT_EQ(counts.met, 0) << "of " << counts.flights;
    flights += counts.flights;
  }
  EXPECT_GT(flights, 50000);
}

// They are not much higher than they need to be: half as high, they are wrong.
TEST(Horizons, AreNotFarAboveTheSurface) {
  const Counts counts = fly(bumpy_sphere(4, 0.3f), 0.5, false, 20000);
  EXPECT_GT(counts.flights, 5000);
  EXPECT_GT(counts.met, 20);
}

} // namespace
