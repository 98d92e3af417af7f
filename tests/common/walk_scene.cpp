// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "common/walk_scene.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include "scene/scene.hpp"

namespace tyn_test {

namespace {

void require(TynStatus status, const char *what, const char *message) {
  if (status == TYN_OK)
    return;
  ADD_FAILURE() << what << ": " << tyn_status_string(status) << ": " << message;
  throw std::runtime_error(what);
}

void require(TynStatus status, const char *what, const TynContext *context) {
  require(status, what, status == TYN_OK ? "" : tyn_context_message(context));
}

double triangle_area(const MeshData &mesh, uint32_t triangle) {
  double e[2][3];
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < 2; ++i)
      e[i][k] = double(mesh.positions[3 * mesh.indices[3 * triangle + i + 1] + k]) -
                mesh.positions[3 * mesh.indices[3 * triangle] + k];
  double x = e[0][1] * e[1][2] - e[0][2] * e[1][1];
  double y = e[0][2] * e[1][0] - e[0][0] * e[1][2];
  double z = e[0][0] * e[1][1] - e[0][1] * e[1][0];
  return 0.5 * std::sqrt(x * x + y * y + z * z);
}

} // namespace

ContextHandle make_context(uint32_t lanes, uint64_t memory_limit, const char *cache) {
  char message[4096] = "";
  TynContextOptions options = tyn_context_options();
  options.lane_width = lanes;
  options.memory_limit = memory_limit;
  options.cache_directory = cache;
  options.message = message;
  options.message_capacity = sizeof message;
  TynContext *context = nullptr;
  require(tyn_context_create(&options, &context), "tyn_context_create", message);
  return ContextHandle(context);
}

namespace {

// Released when the tests are over and not by a static destructor, when the compiler inside an OpenCL driver may be gone.
class SharedContext : public testing::Environment {
public:
  void TearDown() override { context.reset(); }
  ContextHandle context;
};

} // namespace

TynContext *shared_context() {
  static SharedContext *shared = nullptr;
  if (!shared) {
    shared = new SharedContext; // GoogleTest owns it
    testing::AddGlobalTestEnvironment(shared);
  }
  if (!shared->context)
    shared->context = make_context();
  return shared->context.get();
}

TynMedium grey_medium(float sigma_a, float sigma_s, float g, float ior) {
  return rgb_medium({sigma_a, sigma_a, sigma_a}, {sigma_s, sigma_s, sigma_s}, g, ior);
}

TynMedium rgb_medium(const float (&sigma_a)[3], const float (&sigma_s)[3], float g, float ior) {
  TynMedium medium = tyn_medium();
  std::copy(sigma_a, sigma_a + 3, medium.sigma_a);
  std::copy(sigma_s, sigma_s + 3, medium.sigma_s);
  medium.g = g;
  medium.ior = ior;
  return medium;
}

SceneHandle make_scene(TynContext *context, const MeshData &mesh, const TynMedium &medium) {
  TynScene *created = nullptr;
  require(tyn_scene_create(context, nullptr, &created), "tyn_scene_create", context);
  SceneHandle scene(created);
  TynMesh view = mesh.view();
  require(tyn_scene_add_medium(scene.get(), &medium, &view.medium), "tyn_scene_add_medium", context);
  require(tyn_scene_add_mesh(scene.get(), &view, nullptr), "tyn_scene_add_mesh", context);
  require(tyn_scene_commit(scene.get()), "tyn_scene_commit", context);
  return scene;
}

std::vector<uint32_t> scene_cells(TynScene *scene) {
  std::vector<uint32_t> cells(scene->buffers.cells.size() / sizeof(uint32_t));
  scene->context.read(scene->buffers.cells, cells.data(), scene->buffers.cells.size());
  return cells;
}

TynMeshInfo mesh_info(const TynScene *scene) {
  TynMeshInfo info{};
  info.size = sizeof info;
  require(tyn_scene_mesh_info(scene, 0, &info), "tyn_scene_mesh_info", tyn_scene_context(scene));
  return info;
}

TynWalkEntry plain_entry(uint32_t kind) {
  TynWalkEntry entry{};
  entry.kind = kind;
  entry.direction[2] = 1;
  std::fill(entry.weight, entry.weight + 3, 1.0f);
  entry.triangle = TYN_NONE;
  entry.albedo[0] = -1;
  entry.medium = TYN_NONE;
  entry.sigma_t[0] = -1;
  return entry;
}

std::vector<TynWalkEntry> surface_entries(const MeshData &mesh, size_t count, uint32_t seed) {
  std::vector<double> area_before(mesh.triangle_count() + 1, 0.0);
  for (uint32_t t = 0; t < mesh.triangle_count(); ++t)
    area_before[t + 1] = area_before[t] + triangle_area(mesh, t);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform;
  std::vector<TynWalkEntry> entries(count, plain_entry(TYN_ENTRY_COSINE));
  uint32_t triangle = 0;
  for (size_t i = 0; i < count; ++i) {
    double at = (double(i) + uniform(random)) / double(count) * area_before.back();
    while (triangle + 1 < mesh.triangle_count() && area_before[triangle + 1] <= at)
      ++triangle;
    double r = std::sqrt(uniform(random)), s = uniform(random);
    const double weights[3] = {1 - r, r * (1 - s), r * s};
    for (int k = 0; k < 3; ++k) {
      double p = 0;
      for (int v = 0; v < 3; ++v)
        p += weights[v] * mesh.positions[3 * mesh.indices[3 * triangle + v] + k];
      entries[i].position[k] = static_cast<float>(p);
    }
    entries[i].triangle = triangle;
  }
  return entries;
}

Walked walk(TynScene *scene, const std::vector<TynWalkEntry> &entries, const TynWalkOptions &options) {
  Walked walked{std::vector<TynWalkExit>(entries.size()), {}};
  require(tyn_walk(scene, &options, entries.data(), entries.size(), walked.exits.data(), &walked.ledger), "tyn_walk",
          tyn_scene_context(scene));
  return walked;
}

double accounted(const TynLedger &l, int c) {
  return l.reflected[c] + l.escaped[c] + l.absorbed[c] + l.balance[c] + l.capped[c] + l.leaked[c] + l.lost[c];
}

} // namespace tyn_test
