// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// What kernels/distance_bound.clh says is clear, by the kernel's own code: Embree finds no surface there.
#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "common/embree_oracle.hpp"
#include "common/walk_scene.hpp"
#include "core/opencl_shim.hpp"
#include "scene/scene.hpp"

namespace tyn_kernel {
#define global
#include "kernels/distance_bound.clh"
#undef global
} // namespace tyn_kernel

namespace {

using namespace tyn_test;
using namespace tyn_kernel;

struct Looks {
  int all = 0, clear = 0, beside = 0; // beside: farther than the ball around the point reaches
  int met = 0;                        // surface where it should be clear
  double worst = -INFINITY;           // of the ball's radius less the distance
};

void random_direction(std::mt19937 &random, float (&d)[3]) {
  std::normal_distribution<float> normal;
  double squared = 0;
  for (float &x : d) {
    x = normal(random);
    squared += double(x) * double(x);
  }
  for (float &x : d)
    x = float(double(x) / std::sqrt(squared));
}

// Half of the points anywhere in the bounds, half within a cell of the surface.
void random_point(const tyn::Mesh &mesh, const TynMeshRecord &record, std::mt19937 &random, float (&p)[3]) {
  std::uniform_real_distribution<float> uniform;
  const size_t triangle = random() % (mesh.indices.size() / 3);
  const bool near = random() % 2;
  const float u = uniform(random), v = uniform(random) * (1 - u);
  for (int k = 0; k < 3; ++k) {
    auto corner = [&](size_t c) { return (&mesh.positions[mesh.indices[3 * triangle + c]].x)[k]; };
    const float at = corner(0) * (1 - u - v) + corner(1) * u + corner(2) * v;
    p[k] = near ? at + (uniform(random) - 0.5f) * record.grid_cell
                : record.lower[k] + uniform(random) * (record.upper[k] - record.lower[k]);
  }
}

Looks look(const MeshData &mesh, int count) {
  SceneHandle scene = make_scene(shared_context(), mesh, grey_medium(0, 40));
  const std::vector<uint32_t> cells = scene_cells(scene.get());
  const TynMeshRecord &record = scene->mesh_records[0];
  DistanceGrids distances;
  distance_grids_clear(&distances);
  distance_grids_set(&distances, 0, &record);
  EmbreeOracle oracle(scene->meshes);
  std::mt19937 random(17);
  Looks looks;
  for (int i = 0; i < count; ++i) {
    float p[3], d[3], radius = 0;
    random_point(scene->meshes[0], record, random, p);
    random_direction(random, d);
    const float clear = distance_clear(&distances, cells.data(), -1, p, d, &radius);
    ++looks.all;
    looks.beside += clear > radius;
    if (!(clear > 0))
      continue;
    ++looks.clear;
    looks.worst = std::max(looks.worst, double(radius) - double(oracle.distance(p)));
    TynRay ray{};
    std::copy_n(p, 3, ray.origin);
    std::copy_n(d, 3, ray.direction);
    ray.t_max = clear;
    looks.met += oracle.occluded(ray);
  }
  return looks;
}

TEST(DistanceClear, HasNoSurfaceInTheWay) {
  int clear = 0, beside = 0;
  for (const NamedMesh &named : walked_meshes()) {
    SCOPED_TRACE(named.name);
    const Looks looks = look(named.mesh, 20000);
    EXPECT_EQ(looks.met, 0) << "of " << looks.clear;
    if (looks.clear > 0) {
      EXPECT_LT(looks.worst, 0);
    }
    clear += looks.clear;
    beside += looks.beside;
  }
  EXPECT_GT(clear, 100000);
  EXPECT_GT(beside, 20000); // thanks to planes
}

} // namespace
