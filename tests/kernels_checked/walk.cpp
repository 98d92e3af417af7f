// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The walk kernel under oclgrind: its reports fail the test (see tests/CMakeLists.txt). A few walks through every branch:
// all kinds of entry, smooth and rough boundaries, caps, roulette, leaks, bad indices.
#include <gtest/gtest.h>

#include "common/walk_scene.hpp"
#include "tyndall/tyndall_cl.h"

namespace {

using namespace tyn_test;

class CheckedWalk : public testing::TestWithParam<uint32_t> {
protected:
  ContextHandle context = make_context(GetParam());

  Walked walk_in(const MeshData &mesh, const TynMedium &medium, std::vector<TynWalkEntry> entries,
                 const TynWalkOptions &options = tyn_walk_options()) {
    SceneHandle scene = make_scene(context.get(), mesh, medium);
    Walked walked = walk(scene.get(), entries, options);
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(accounted(walked.ledger, c), walked.ledger.entered[c], 1e-4);
    return walked;
  }
};

TEST_P(CheckedWalk, ThroughAMatchedColouredCube) {
  Walked walked = walk_in(cube(), rgb_medium({0.5f, 0.1f, 0}, {1, 2, 0.5f}, 0.5f), surface_entries(cube(), 19, 1));
  EXPECT_EQ(walked.ledger.leaked_walks + walked.ledger.lost_walks, 0u);
}

TEST_P(CheckedWalk, ThroughASmoothAndARoughDielectric) {
  std::vector<TynWalkEntry> entries = surface_entries(icosphere(1), 12, 2);
  for (size_t i = 0; i < entries.size(); ++i) {
    entries[i].roughness = i % 2 ? 0.5f : 0.0f;
    entries[i].kind = i % 3 ? TYN_ENTRY_COSINE : TYN_ENTRY_REFRACT;
  }
  walk_in(icosphere(1), grey_medium(0.2f, 1, -0.5f, 1.4f), entries);
}

TEST_P(CheckedWalk, FromTheInteriorWithItsOwnColourAndACap) {
  TynWalkEntry entry = plain_entry(TYN_ENTRY_INSIDE);
  entry.albedo[0] = entry.albedo[1] = entry.albedo[2] = 0.9f;
  entry.sigma_t[0] = 1;
  entry.sigma_t[1] = 2;
  entry.sigma_t[2] = 3;
  TynWalkOptions options = tyn_walk_options();
  options.max_scatterings = 3;
  options.roulette_threshold = 1;
  walk_in(cube(), grey_medium(0, 1), std::vector<TynWalkEntry>(9, entry), options);
}

TEST_P(CheckedWalk, OutOfAHole) {
  MeshData mesh = open_hemisphere(1);
  walk_in(mesh, grey_medium(0.1f, 0.5f), surface_entries(mesh, 9, 3));
}

TEST_P(CheckedWalk, WithIndicesOutOfRange) {
  SceneHandle scene = make_scene(context.get(), cube(), grey_medium(0, 1));
  std::vector<TynWalkEntry> entries = surface_entries(cube(), 5, 4);
  entries[0].mesh = 7;
  entries[1].medium = 7;
  entries[2].triangle = 12;
  entries[3].triangle = TYN_NONE;
  cl_context cl;
  ASSERT_EQ(tyn_context_cl(context.get(), &cl, nullptr, nullptr), TYN_OK);
  const size_t in_bytes = entries.size() * sizeof(TynWalkEntry), out_bytes = entries.size() * sizeof(TynWalkExit);
  cl_mem in = clCreateBuffer(cl, CL_MEM_READ_ONLY | CL_MEM_COPY_HOST_PTR, in_bytes, entries.data(), nullptr);
  cl_mem out = clCreateBuffer(cl, CL_MEM_READ_WRITE, out_bytes, nullptr, nullptr);
  TynLedger ledger;
  EXPECT_EQ(tyn_walk_cl(scene.get(), nullptr, in, entries.size(), out, &ledger), TYN_OK);
  EXPECT_EQ(ledger.lost_walks, 4u);
  clReleaseMemObject(out);
  clReleaseMemObject(in);
}

INSTANTIATE_TEST_SUITE_P(WithLanes, CheckedWalk, testing::Values(1u, 4u), testing::PrintToStringParamName());

} // namespace
