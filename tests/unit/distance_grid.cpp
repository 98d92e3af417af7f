// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The grids of lower bounds: below the exact distance everywhere, not far below it, and without a trace in what walks give.
#include <cmath>
#include <cstring>
#include <random>

#include <gtest/gtest.h>

#include "common/embree_oracle.hpp"
#include "common/walk_scene.hpp"
#include "scene/scene.hpp"
#include "walk/walk.hpp"

namespace {

using namespace tyn_test;

// What distance_bound.clh computes, in double.
double bound_at(const TynMeshRecord &record, const std::vector<uint32_t> &cells, const float *p) {
  uint64_t index = record.grid_first, stride = 1;
  double squared = 0;
  for (int k = 0; k < 3; ++k) {
    double x = (double(p[k]) - double(record.lower[k])) * double(record.grid_per_cell);
    double cell = std::floor(std::clamp(x, 0.0, double(record.grid_size[k] - 1)));
    squared += (x - cell - 0.5) * (x - cell - 0.5);
    index += stride * uint64_t(cell);
    stride *= record.grid_size[k];
  }
  double code = cells[index] & 255u;
  return code * code * double(record.grid_step) - std::sqrt(squared) * double(record.grid_cell);
}

struct Grids {
  SceneHandle scene;
  std::vector<TynMeshRecord> records;
  std::vector<uint32_t> cells;

  explicit Grids(const MeshData &mesh)
      : scene(make_scene(shared_context(), mesh, grey_medium(0, 300))), records(scene->mesh_records),
        cells(scene_cells(scene.get())) {}
};

// Three in four points anywhere in bounds a little too wide, the others near the surface.
class Points {
public:
  Points(const tyn::Mesh &mesh_, uint32_t seed) : mesh(mesh_), random(seed) {
    for (int k = 0; k < 3; ++k)
      longest = std::max(longest, mesh.info.upper[k] - mesh.info.lower[k]);
  }

  void next(float (&p)[3]) {
    float offset = random() % 4 ? 1 : std::ldexp(1.0f, -int(random() % 24));
    if (offset == 1) {
      for (int k = 0; k < 3; ++k)
        p[k] = mesh.info.lower[k] + (1.1f * uniform(random) - 0.05f) * (mesh.info.upper[k] - mesh.info.lower[k]);
      return;
    }
    size_t triangle = random() % (mesh.indices.size() / 3);
    float u = uniform(random), v = uniform(random) * (1 - u);
    for (int k = 0; k < 3; ++k) {
      const float *corner[3];
      for (size_t i = 0; i < 3; ++i)
        corner[i] = &mesh.positions[mesh.indices[3 * triangle + i]].x + k;
      p[k] = *corner[0] * (1 - u - v) + *corner[1] * u + *corner[2] * v + (uniform(random) - 0.5f) * offset * longest;
    }
  }

private:
  const tyn::Mesh &mesh;
  std::mt19937 random;
  std::uniform_real_distribution<float> uniform;
  float longest = 0;
};

class DistanceGrid : public testing::TestWithParam<NamedMesh> {};

void expect_below_the_distance(const MeshData &mesh, int count) {
  Grids grids(mesh);
  const TynMeshRecord &record = grids.records[0];
  ASSERT_GT(record.grid_cell, 0.0f);
  EmbreeOracle oracle(grids.scene->meshes);
  Points points(grids.scene->meshes[0], 5);
  double worst = -INFINITY, lost = 0;
  int within = 0;
  for (int i = 0; i < count; ++i) {
    float p[3];
    points.next(p);
    double bound = bound_at(record, grids.cells, p), distance = double(oracle.distance(p));
    double out = INFINITY; // to where the point would leave the bounds; below 0 outside
    for (int k = 0; k < 3; ++k)
      out = std::min({out, double(p[k]) - double(record.lower[k]), double(record.upper[k]) - double(p[k])});
    // the walk counts hits from a little behind its start on
    worst = std::max({worst, bound - std::max(0.0, distance - double(record.slack)), bound - std::max(0.0, out)});
    if (distance > 4 * double(record.grid_cell) && out > distance) {
      lost += distance - bound;
      ++within;
    }
  }
  EXPECT_LE(worst, 0);
  if (within > 1000) {
    EXPECT_LT(lost / within, 2.5 * double(record.grid_cell) + 5 * double(record.slack)); // worth having
  }
}

TEST_P(DistanceGrid, IsBelowTheDistanceEverywhere) { expect_below_the_distance(GetParam().mesh, 100000); }
// 1e7 points over the ten meshes.
TEST_P(DistanceGrid, ThoroughlyIsBelowTheDistanceEverywhere) { expect_below_the_distance(GetParam().mesh, 1000000); }

INSTANTIATE_TEST_SUITE_P(OfEvery, DistanceGrid, testing::ValuesIn(closed_meshes()),
                         [](const auto &one) { return std::to_string(one.index); });

TEST(DistanceGrids, AreCoarserWithoutAMediumAndAbsentInOpenMeshes) {
  MeshData meshes[3] = {cube(), cube(), open_hemisphere(3)};
  TynScene *created = nullptr;
  ASSERT_EQ(tyn_scene_create(shared_context(), nullptr, &created), TYN_OK);
  SceneHandle scene(created);
  TynMedium medium = grey_medium(0, 300);
  for (int i = 0; i < 3; ++i) {
    TynMesh view = meshes[i].view();
    if (i == 0) {
      ASSERT_EQ(tyn_scene_add_medium(scene.get(), &medium, &view.medium), TYN_OK);
    }
    ASSERT_EQ(tyn_scene_add_mesh(scene.get(), &view, nullptr), TYN_OK);
  }
  ASSERT_EQ(tyn_scene_commit(scene.get()), TYN_OK);
  const std::vector<TynMeshRecord> &records = scene->mesh_records;
  EXPECT_GT(records[0].grid_cell, 0.0f);
  EXPECT_GT(records[1].grid_cell, 3 * records[0].grid_cell);
  EXPECT_EQ(records[2].grid_cell, 0.0f);
  EXPECT_EQ(records[2].grid_step, 0.0f);
}

TEST(DistanceGrids, HaveCellsOfTheShortestMeanFreePath) {
  auto cells = [](float sigma) {
    SceneHandle scene = make_scene(shared_context(), cube(), rgb_medium({0, 0, 0}, {sigma, 0.5f * sigma, 1}));
    return scene->mesh_records[0].grid_size[1];
  };
  const float side = 2;
  EXPECT_NEAR(cells(10 / side), 56u, 1);
  EXPECT_NEAR(cells(100 / side), 100u, 1);
  EXPECT_NEAR(cells(1000 / side), 160u, 1);
}

// From now on walks trace every flight, from the mesh's own root: no grid, no horizons, no local roots.
void trace_every_flight(TynScene *scene) {
  TynMeshRecord mesh = scene->mesh_records[0];
  mesh.grid_first = mesh.local_first = 0;
  for (int k = 0; k < 3; ++k)
    mesh.grid_size[k] = mesh.local_size[k] = 1;
  mesh.grid_cell = mesh.grid_per_cell = mesh.grid_step = 0;
  mesh.local_cell = mesh.local_per_cell = mesh.horizon_reach =
      0; // a local root reaches nowhere, then the mesh's is next
  TynContext &context = *shared_context();
  context.write(scene->buffers.meshes, &mesh, sizeof mesh);
  context.write(scene->buffers.cells, &mesh.root, sizeof mesh.root);
  std::vector<TynTriangleRecord> triangles(scene->triangle_count);
  context.read(scene->buffers.triangles, triangles.data(), triangles.size() * sizeof triangles[0]);
  for (TynTriangleRecord &triangle : triangles)
    triangle.horizon = 2;
  context.write(scene->buffers.triangles, triangles.data(), triangles.size() * sizeof triangles[0]);
}

// Rays that walks trace.
uint64_t count_rays(TynScene *scene, const std::vector<TynWalkEntry> &entries, const TynWalkOptions &options) {
  TynContext &context = *shared_context();
  tyn::Buffer entry_buffer(context, entries.size() * sizeof(TynWalkEntry));
  tyn::Buffer exits(context, entries.size() * sizeof(TynWalkExit));
  tyn::Buffer tallies(context, entries.size() * sizeof(TynWalkTally));
  context.write(entry_buffer, entries.data(), entry_buffer.size());
  TynWalkParameters parameters = tyn::walk_parameters(*scene, options);
  parameters.count = uint32_t(entries.size());
  tyn::enqueue_walk(*scene, parameters, entry_buffer.get(), exits.get(), tallies.get());
  std::vector<TynWalkTally> tallied(entries.size());
  context.read(tallies, tallied.data(), tallies.size());
  uint64_t rays = 0;
  for (const TynWalkTally &tally : tallied)
    rays += tally.rays;
  return rays;
}

// Walks with all that saves rays, and without.
void expect_no_trace(const MeshData &mesh, const TynMedium &medium, size_t count, uint64_t &saved) {
  SceneHandle scene = make_scene(shared_context(), mesh, medium);
  std::vector<TynWalkEntry> entries = surface_entries(mesh, count, 77);
  for (size_t i = 0; i < entries.size(); ++i)
    entries[i].roughness = i % 2 ? 0.4f : 0.0f;
  TynWalkOptions options = tyn_walk_options();
  options.max_scatterings = 3000; // the longest mean free paths need no limit, and the shortest would take very long
  Walked with = walk(scene.get(), entries, options);
  const uint64_t rays = count_rays(scene.get(), entries, options);
  trace_every_flight(scene.get());
  Walked without = walk(scene.get(), entries, options);
  const uint64_t all_rays = count_rays(scene.get(), entries, options);
  EXPECT_GE(all_rays, without.ledger.scatterings); // each is the end of a flight
  EXPECT_LE(rays, all_rays);
  saved += all_rays - rays;
  EXPECT_EQ(std::memcmp(&with.ledger, &without.ledger, sizeof with.ledger), 0);
  for (size_t i = 0; i < entries.size(); ++i)
    ASSERT_EQ(std::memcmp(&with.exits[i], &without.exits[i], sizeof with.exits[i]), 0) << "walk " << i;
}

class DistanceGridWalk : public testing::TestWithParam<NamedMesh> {};

// Returns how many rays were saved.
uint64_t expect_no_trace_in(const MeshData &mesh, std::initializer_list<float> mean_free_paths, size_t count) {
  uint64_t saved = 0;
  for (float mean_free_path : mean_free_paths)
    for (float ior : {1.0f, 1.4f}) {
      SCOPED_TRACE(mean_free_path);
      SCOPED_TRACE(ior);
      const float s = 0.5f / mean_free_path; // most meshes are about 2 wide
      expect_no_trace(mesh, rgb_medium({0.002f * s, 0.01f * s, 0.1f * s}, {s, 2 * s, s}, 0.7f, ior), count, saved);
    }
  return saved;
}

TEST(DistanceGridWalks, GiveTheSameBitsAsTracingEveryFlight) {
  for (const MeshData &mesh : {cube(), torus(1, 0.4f, 48, 24), bumpy_sphere(4, 0.3f), open_hemisphere(3)})
    EXPECT_GT(expect_no_trace_in(mesh, {0.03f}, 200), 0u);
}

TEST_P(DistanceGridWalk, ThoroughlyGivesTheSameBitsAsTracingEveryFlight) {
  const uint64_t saved = expect_no_trace_in(GetParam().mesh, {1e-4f, 1e-3f, 1e-2f, 0.1f, 1.0f, 10.0f}, 400);
  EXPECT_TRUE(saved > 0 || GetParam().name == "a needle"); // which has no inside to speak of
}

INSTANTIATE_TEST_SUITE_P(InEvery, DistanceGridWalk, testing::ValuesIn(walked_meshes()),
                         [](const auto &one) { return std::to_string(one.index); });

} // namespace
