// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Half-spaces without surface: what kernels/distance_bound.clh makes of a cell, in double, against points of the surface.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "common/walk_scene.hpp"
#include "scene/scene.hpp"

namespace {

using namespace tyn_test;

// The plane of a cell: no surface within `radius` of the centre has n (q - c) < offset; lengths in cells.
struct Plane {
  bool there;
  double n[3], offset, radius;

  explicit Plane(uint32_t cell) : there((cell >> 8 & 255u) != 0) {
    auto component = [](uint32_t seven_bits) { return (double(seven_bits) - (seven_bits > 63 ? 128 : 0)) / 63; };
    const double u = component(cell >> 16 & 127u), v = component(cell >> 23 & 127u);
    n[2] = 1 - std::abs(u) - std::abs(v);
    n[0] = n[2] < 0 ? std::copysign(1 - std::abs(v), u) : u;
    n[1] = n[2] < 0 ? std::copysign(1 - std::abs(u), v) : v;
    offset = double(cell >> 8 & 255u) * double(TYN_CLEAR_PLANE_STEP) - 1;
    radius = double((cell >> 30) + 1u) * double(TYN_CLEAR_REACH_STEP);
  }
};

class SurfacePlanes {
public:
  explicit SurfacePlanes(const MeshData &mesh)
      : scene(make_scene(shared_context(), mesh, grey_medium(0, 1))), record(scene->mesh_records[0]),
        cells(scene_cells(scene.get())) {}

  // Points of the surface, many at corners and on edges.
  void check_surface(int count) {
    const tyn::Mesh &mesh = scene->meshes[0];
    for (int i = 0; i < count; ++i) {
      const size_t triangle = random() % (mesh.indices.size() / 3);
      double u = uniform(random), v = uniform(random) * (1 - u);
      u = random() % 4 ? u : 0;
      v = random() % 4 ? v : 0;
      double q[3];
      for (int k = 0; k < 3; ++k) {
        auto corner = [&](size_t c) { return double((&mesh.positions[mesh.indices[3 * triangle + c]].x)[k]); };
        q[k] = corner(0) * (1 - u - v) + corner(1) * u + corner(2) * v;
      }
      check(q);
    }
  }

  void check_bounds(int count) {
    for (int i = 0; i < count; ++i) {
      double q[3];
      for (int k = 0; k < 3; ++k)
        q[k] = double(record.lower[k]) + uniform(random) * (double(record.upper[k]) - double(record.lower[k]));
      const int k = int(random() % 3);
      q[k] = double(random() % 2 ? record.upper[k] : record.lower[k]);
      check(q);
    }
  }

  double least = INFINITY; // of n (q - c) - offset
  int checked = 0, close = 0;

private:
  // Against a cell near it.
  void check(const double (&q)[3]) {
    double from[3], squared = 0;
    uint64_t index = record.grid_first, stride = 1;
    for (int k = 0; k < 3; ++k) {
      const double x = (q[k] - double(record.lower[k])) / double(record.grid_cell);
      const double cell = std::floor(x) + double(random() % 7) - 3;
      if (cell < 0 || cell >= double(record.grid_size[k]))
        return;
      from[k] = x - (cell + 0.5);
      squared += from[k] * from[k];
      index += stride * uint64_t(cell);
      stride *= record.grid_size[k];
    }
    const Plane plane(cells[index]);
    if (!plane.there || squared > plane.radius * plane.radius)
      return;
    const double along = plane.n[0] * from[0] + plane.n[1] * from[1] + plane.n[2] * from[2];
    least = std::min(least, along - plane.offset);
    close += along - plane.offset < 0.1;
    ++checked;
  }

  SceneHandle scene;
  const TynMeshRecord record;
  const std::vector<uint32_t> cells;
  std::mt19937 random{3};
  std::uniform_real_distribution<double> uniform;
};

struct Found {
  int checked = 0, close = 0;
};

// Lets `check` look at the planes of every mesh; none may be wrong.
template <class F>
Found check_all(F &&check) {
  Found found;
  for (const NamedMesh &named : walked_meshes()) {
    SCOPED_TRACE(named.name);
    SurfacePlanes planes(named.mesh);
    check(planes);
    EXPECT_GE(planes.least, 0);
    found.checked += planes.checked;
    found.close += planes.close;
  }
  return found;
}

TEST(SurfacePlanes, HaveTheSurfaceOnTheirFarSide) {
  const Found found = check_all([](SurfacePlanes &planes) { planes.check_surface(200000); });
  EXPECT_GT(found.checked, 100000);
  EXPECT_GT(found.close, 1000); // an offset larger by a tenth of a cell would be too large
}

TEST(SurfacePlanes, HaveTheBoundsOnTheirFarSide) {
  const Found found = check_all([](SurfacePlanes &planes) { planes.check_bounds(50000); });
  EXPECT_GT(found.checked, 10000);
  EXPECT_GT(found.close, 100);
}

} // namespace
