// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The same seed gives the same bits, however the walks are batched, over however many lanes they run, and at whatever scale.
#include <cstring>

#include <gtest/gtest.h>

#include "common/walk_scene.hpp"
#include "tyndall/tyndall_cl.h"

namespace {

using namespace tyn_test;

const size_t count = 1500;

TynMedium test_medium(float scale = 1) {
  return rgb_medium({0.3f / scale, 0.1f / scale, 0.02f / scale}, {1 / scale, 4 / scale, 9 / scale}, 0.6f, 1.4f);
}

MeshData test_mesh() { return torus(1.0f, 0.4f, 24, 12); }

// All kinds, smooth and rough.
std::vector<TynWalkEntry> test_entries(const MeshData &mesh) {
  std::vector<TynWalkEntry> entries = surface_entries(mesh, count, 31);
  for (size_t i = 0; i < count; ++i) {
    TynWalkEntry &entry = entries[i];
    entry.roughness = i % 2 ? 0.5f : 0.0f;
    if (i % 3 == 1) {
      entry.kind = TYN_ENTRY_REFRACT;
      entry.direction[0] = 0.6f;
      entry.direction[2] = -0.8f;
    } else if (i % 3 == 2) {
      entry.kind = TYN_ENTRY_INSIDE;
      entry.triangle = TYN_NONE;
      entry.position[0] = 1;
      entry.position[1] = entry.position[2] = 0;
    }
  }
  return entries;
}

void expect_same_bits(const std::vector<TynWalkExit> &a, const std::vector<TynWalkExit> &b) {
  ASSERT_EQ(a.size(), b.size());
  for (size_t i = 0; i < a.size(); ++i)
    ASSERT_EQ(std::memcmp(&a[i], &b[i], sizeof a[i]), 0) << "walk " << i;
}

std::vector<TynWalkExit> walk_with_lanes(uint32_t lanes) {
  ContextHandle context = make_context(lanes);
  MeshData mesh = test_mesh();
  SceneHandle scene = make_scene(context.get(), mesh, test_medium());
  return walk(scene.get(), test_entries(mesh)).exits;
}

struct Fixture {
  MeshData mesh = test_mesh();
  SceneHandle scene = make_scene(shared_context(), mesh, test_medium());
  std::vector<TynWalkEntry> entries = test_entries(mesh);
};

TEST(WalkDeterminism, SameSeedGivesTheSameBits) {
  Fixture f;
  Walked first = walk(f.scene.get(), f.entries), second = walk(f.scene.get(), f.entries);
  expect_same_bits(first.exits, second.exits);
  EXPECT_EQ(std::memcmp(&first.ledger, &second.ledger, sizeof first.ledger), 0);
}

TEST(WalkDeterminism, AnotherSeedGivesOtherWalks) {
  Fixture f;
  TynWalkOptions options = tyn_walk_options();
  options.seed = uint64_t(1) << 32; // the high word counts too
  Walked first = walk(f.scene.get(), f.entries), second = walk(f.scene.get(), f.entries, options);
  size_t different = 0;
  for (size_t i = 0; i < count; ++i)
    different += std::memcmp(&first.exits[i], &second.exits[i], sizeof first.exits[i]) != 0;
  EXPECT_GT(different, count / 2); // some arrive from below their triangle and are reflected whatever the seed
}

TEST(WalkDeterminism, SplittingABatchChangesNoBit) {
  Fixture f;
  std::vector<TynWalkExit> whole = walk(f.scene.get(), f.entries).exits, parts;
  for (size_t begin = 0; begin < count;) {
    size_t end = std::min(count, begin + 1 + begin / 2);
    TynWalkOptions options = tyn_walk_options();
    options.first_path = begin;
    Walked part = walk(f.scene.get(), {f.entries.begin() + long(begin), f.entries.begin() + long(end)}, options);
    parts.insert(parts.end(), part.exits.begin(), part.exits.end());
    begin = end;
  }
  expect_same_bits(whole, parts);
}

TEST(WalkDeterminism, PathNumbersCrossThe32BitBoundary) {
  Fixture f;
  TynWalkOptions options = tyn_walk_options();
  options.first_path = 0xffffffffull - 10;
  std::vector<TynWalkExit> whole = walk(f.scene.get(), f.entries, options).exits;
  options.first_path += 20;
  std::vector<TynWalkExit> tail = walk(f.scene.get(), {f.entries.begin() + 20, f.entries.end()}, options).exits;
  expect_same_bits({whole.begin() + 20, whole.end()}, tail);
}

TEST(WalkDeterminism, AnEntrysPathIsAddedToItsNumber) {
  Fixture f;
  TynWalkOptions options = tyn_walk_options();
  options.first_path = 5000000000ull;
  std::vector<TynWalkExit> expected = walk(f.scene.get(), f.entries, options).exits;
  for (TynWalkEntry &entry : f.entries) {
    entry.path[0] = uint32_t(5000000000ull);
    entry.path[1] = uint32_t(5000000000ull >> 32);
  }
  expect_same_bits(expected, walk(f.scene.get(), f.entries).exits);
}

TEST(WalkDeterminism, AllLaneWidthsGiveTheSameBits) {
  std::vector<TynWalkExit> reference = walk_with_lanes(1);
  for (uint32_t lanes : {4u, 8u, 16u}) {
    SCOPED_TRACE(lanes);
    expect_same_bits(reference, walk_with_lanes(lanes));
  }
}

// Mesh and mean free path twice as large: positions and path lengths double and nothing else changes.
TEST(WalkDeterminism, ScalingByTwoChangesOnlyExponents) {
  Fixture f;
  std::vector<TynWalkExit> expected = walk(f.scene.get(), f.entries).exits;
  SceneHandle large = make_scene(shared_context(), scaled(f.mesh, 2), test_medium(2));
  for (TynWalkEntry &entry : f.entries)
    for (float &x : entry.position)
      x *= 2;
  std::vector<TynWalkExit> exits = walk(large.get(), f.entries).exits;
  for (TynWalkExit &exit : exits) {
    exit.path_length /= 2;
    for (float &x : exit.position)
      x /= 2;
  }
  expect_same_bits(expected, exits);
}

TEST(WalkDeterminism, BuffersGiveTheSameBitsAsPointers) {
  Fixture f;
  Walked expected = walk(f.scene.get(), f.entries);
  cl_context cl;
  cl_command_queue queue;
  ASSERT_EQ(tyn_context_cl(shared_context(), &cl, &queue, nullptr), TYN_OK);
  cl_mem entries = clCreateBuffer(cl, CL_MEM_READ_ONLY | CL_MEM_COPY_HOST_PTR, count * sizeof(TynWalkEntry),
                                  f.entries.data(), nullptr);
  cl_mem exits = clCreateBuffer(cl, CL_MEM_READ_WRITE, count * sizeof(TynWalkExit), nullptr, nullptr);
  for (bool with_ledger : {true, false}) {
    TynLedger ledger{};
    ASSERT_EQ(tyn_walk_cl(f.scene.get(), nullptr, entries, count, exits, with_ledger ? &ledger : nullptr), TYN_OK)
        << tyn_context_message(shared_context());
    std::vector<TynWalkExit> result(count);
    ASSERT_EQ(
        clEnqueueReadBuffer(queue, exits, CL_TRUE, 0, count * sizeof(TynWalkExit), result.data(), 0, nullptr, nullptr),
        CL_SUCCESS);
    expect_same_bits(expected.exits, result);
    if (with_ledger) {
      EXPECT_EQ(std::memcmp(&expected.ledger, &ledger, sizeof ledger), 0);
    }
  }
  clReleaseMemObject(exits);
  clReleaseMemObject(entries);
}

} // namespace
