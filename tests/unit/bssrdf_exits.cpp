// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// What an exit says fits the mesh, and depends on nothing but seed, path and entry.
#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include "common/bssrdf_exits.hpp"
#include "tyndall/tyndall_cl.h"

namespace {

using namespace tyn_test;

constexpr size_t COUNT = 3000;

std::vector<TynBssrdfEntry> entries_on_torus() {
  std::vector<TynBssrdfEntry> entries;
  for (size_t i = 0; i < COUNT; ++i) {
    const double a = double(i) * 0.01, b = double(i) * 0.37;
    const float n[3] = {float(std::cos(a) * std::cos(b)), float(std::sin(b)), float(std::sin(a) * std::cos(b))};
    entries.push_back(bssrdf_entry({float(std::cos(a)) + 0.4f * n[0], 0.4f * n[1], float(std::sin(a)) + 0.4f * n[2]},
                                   {n[0], n[1], n[2]}));
  }
  return entries;
}

BssrdfExits draw(const BssrdfModel &model, TynScene *scene, const std::vector<TynBssrdfEntry> &entries,
                 uint64_t seed = 3, uint64_t first = 0) {
  BssrdfExits result{std::vector<TynBssrdfExit>(entries.size()), std::vector<float>(entries.size() * model.channels())};
  EXPECT_EQ(tyn_bssrdf_sample_exits(model.get(), scene, seed, first, entries.data(), entries.size(),
                                    result.exits.data(), result.weights.data()),
            TYN_OK);
  return result;
}

bool same(const TynBssrdfExit &a, const TynBssrdfExit &b) { return std::memcmp(&a, &b, sizeof a) == 0; }

// With triangles that the scene turns, and texture coordinates.
TEST(BssrdfExits, AreOnTheirTriangles) {
  MeshData mesh = with_flipped(torus(1, 0.4f, 24, 12), 3);
  for (uint32_t v = 0; v < mesh.vertex_count(); ++v)
    mesh.uvs.insert(mesh.uvs.end(), {mesh.positions[3 * v], mesh.positions[3 * v + 1]});
  const SceneHandle scene = make_scene(shared_context(), mesh, grey_medium(0.1f, 1));
  const BssrdfModel model = gaussian_model();
  const std::vector<TynBssrdfEntry> entries = entries_on_torus();
  const BssrdfExits found = draw(model, scene.get(), entries);
  size_t hits = 0, count = 0;
  for (size_t i = 0; i < COUNT; ++i) {
    const TynBssrdfExit &exit = found.exits[i];
    if (exit.status == TYN_BSSRDF_EXIT_NONE) {
      EXPECT_EQ(found.weights[i], 0);
      EXPECT_EQ(exit.triangle, TYN_NONE);
      continue;
    }
    ASSERT_EQ(exit.status, uint32_t(TYN_BSSRDF_EXIT_FOUND));
    const uint32_t *index = &mesh.indices[3 * size_t(exit.triangle)];
    const float part[3] = {1 - exit.u - exit.v, exit.u, exit.v};
    float squared = 0, along = 0;
    for (uint32_t k = 0; k < 3; ++k) {
      float at = 0;
      for (uint32_t v = 0; v < 3; ++v)
        at += part[v] * mesh.positions[3 * index[v] + k];
      EXPECT_NEAR(exit.position[k], at, 1e-6f);
      if (k < 2) {
        EXPECT_NEAR(exit.uv[k], at, 1e-5f);
      }
      const float from = exit.position[k] - entries[i].position[k];
      squared += from * from;
      along += exit.geometric_normal[k] * exit.shading_normal[k];
    }
    EXPECT_GT(along, 0.9f);
    EXPECT_NEAR(exit.distance, std::sqrt(squared), 1e-6f);
    EXPECT_GT(exit.pdf, 0);
    EXPECT_GE(exit.hits, 1u);
    EXPECT_NEAR(found.weights[i] * exit.pdf, model.profile({exit.distance})[0], 1e-5f * found.weights[i] * exit.pdf);
    hits += exit.hits;
    if (++count == 200)
      break;
  }
  EXPECT_GT(hits, count); // some probes meet several points
}

TEST(BssrdfExits, DependOnSeedAndPathAlone) {
  const SceneHandle scene = bare_scene(shared_context(), torus(1, 0.4f, 24, 12));
  const BssrdfModel model = gaussian_model(2);
  std::vector<TynBssrdfEntry> entries = entries_on_torus();
  const BssrdfExits all = draw(model, scene.get(), entries, 7, 1000);
  const BssrdfExits tail = draw(model, scene.get(), {entries.begin() + 2000, entries.end()}, 7, 3000);
  entries[5].path[0] = 9; // as entry 14 of the same place would
  entries[14] = entries[5];
  entries[14].path[0] = 0;
  const BssrdfExits moved = draw(model, scene.get(), entries, 7, 1000), other = draw(model, scene.get(), entries, 8);
  for (size_t i = 2000; i < COUNT; ++i) {
    EXPECT_TRUE(same(all.exits[i], tail.exits[i - 2000]));
    EXPECT_EQ(all.weights[COUNT + i], tail.weights[1000 + i - 2000]);
  }
  EXPECT_TRUE(same(moved.exits[5], moved.exits[14]));
  size_t differ = 0;
  for (size_t i = 0; i < COUNT; ++i)
    differ += !same(moved.exits[i], other.exits[i]);
  EXPECT_GT(differ, COUNT - 10);
}

TEST(BssrdfExits, AreTheSameWhateverTheLanes) {
  std::vector<BssrdfExits> found;
  for (const uint32_t lanes : {1u, 16u}) {
    const ContextHandle context = make_context(lanes);
    const SceneHandle scene = bare_scene(context.get(), torus(1, 0.4f, 24, 12));
    TynSlabLayer layer = tyn_slab_layer();
    const double sigma_a = 0.1, sigma_s = 2;
    layer.sigma_a = &sigma_a;
    layer.sigma_s = &sigma_s;
    TynSlab slab = tyn_slab();
    slab.layer_count = 1;
    slab.layers = &layer;
    const BssrdfModel model(slab, tyn_bssrdf_options(), context.get());
    found.push_back(draw(model, scene.get(), entries_on_torus()));
  }
  for (size_t i = 0; i < COUNT; ++i) {
    EXPECT_TRUE(same(found[0].exits[i], found[1].exits[i]));
    EXPECT_EQ(found[0].weights[i], found[1].weights[i]);
  }
}

// No channel has an albedo.
TEST(BssrdfExits, OfABlackModelAreNone) {
  const SceneHandle scene = bare_scene(shared_context(), quad(10));
  const BssrdfModel model = half_space_model(TYN_BSSRDF_STANDARD_DIPOLE, 0);
  for (const TynBssrdfExit &exit : exits_of(model, scene.get(), bssrdf_entry({0, 0, 0}, {0, 1, 0}), 10, 1).exits)
    EXPECT_EQ(exit.status, uint32_t(TYN_BSSRDF_EXIT_NONE));
}

TEST(BssrdfExits, OnBuffersAreThoseOnPointers) {
  TynContext *context = shared_context();
  const SceneHandle scene = bare_scene(context, torus(1, 0.4f, 24, 12));
  const BssrdfModel model = gaussian_model(2);
  std::vector<TynBssrdfEntry> entries = entries_on_torus();
  const BssrdfExits expected = draw(model, scene.get(), entries, 5, 1ull << 40);
  entries[1].mesh = 1; // a bad index ends that one alone
  cl_context cl = nullptr;
  cl_command_queue queue = nullptr;
  ASSERT_EQ(tyn_context_cl(context, &cl, &queue, nullptr), TYN_OK);
  cl_mem in = clCreateBuffer(cl, CL_MEM_COPY_HOST_PTR, COUNT * sizeof(TynBssrdfEntry), entries.data(), nullptr);
  cl_mem out = clCreateBuffer(cl, CL_MEM_READ_WRITE, COUNT * sizeof(TynBssrdfExit), nullptr, nullptr);
  cl_mem weights = clCreateBuffer(cl, CL_MEM_READ_WRITE, 2 * COUNT * sizeof(float), nullptr, nullptr);
  ASSERT_EQ(tyn_bssrdf_sample_exits_cl(model.get(), scene.get(), 5, 1ull << 40, in, COUNT, out, weights), TYN_OK);
  BssrdfExits found{std::vector<TynBssrdfExit>(COUNT), std::vector<float>(2 * COUNT)};
  clEnqueueReadBuffer(queue, out, CL_TRUE, 0, COUNT * sizeof(TynBssrdfExit), found.exits.data(), 0, nullptr, nullptr);
  clEnqueueReadBuffer(queue, weights, CL_TRUE, 0, 2 * COUNT * sizeof(float), found.weights.data(), 0, nullptr, nullptr);
  EXPECT_EQ(found.exits[1].status, uint32_t(TYN_BSSRDF_EXIT_LOST));
  EXPECT_EQ(found.weights[1], 0);
  for (size_t i = 2; i < COUNT; ++i) {
    EXPECT_TRUE(same(found.exits[i], expected.exits[i]));
    EXPECT_EQ(found.weights[COUNT + i], expected.weights[COUNT + i]);
  }
  EXPECT_EQ(tyn_bssrdf_sample_exits_cl(model.get(), scene.get(), 5, 0, in, COUNT + 1, out, weights),
            TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_bssrdf_sample_exits_cl(model.get(), scene.get(), 5, 0, in, COUNT, nullptr, weights),
            TYN_ERROR_INVALID_ARGUMENT);
  for (cl_mem buffer : {in, out, weights})
    clReleaseMemObject(buffer);
}

} // namespace
