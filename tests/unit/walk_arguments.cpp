// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// What tyn_walk does not accept: each field of an entry and of the options out of its range, named in the message.
#include <cmath>
#include <functional>
#include <string>

#include <gtest/gtest.h>

#include "common/walk_scene.hpp"
#include "tyndall/tyndall_cl.h"

namespace {

using namespace tyn_test;

struct BadEntry {
  const char *field; // must stand in the message
  std::function<void(TynWalkEntry &)> spoil;
};

struct WalkArguments : testing::Test {
  SceneHandle scene = make_scene(shared_context(), cube(), grey_medium(0.1f, 1));
  std::vector<TynWalkEntry> entries = surface_entries(cube(), 5, 51);
  std::vector<TynWalkExit> exits = std::vector<TynWalkExit>(5);

  TynStatus call(const TynWalkOptions *options = nullptr) {
    return tyn_walk(scene.get(), options, entries.data(), entries.size(), exits.data(), nullptr);
  }
  std::string message() const { return tyn_context_message(shared_context()); }
};

TEST_F(WalkArguments, EachBadFieldOfAnEntryIsNamed) {
  const float nan = NAN, inf = INFINITY;
  const BadEntry cases[] = {
      {"kind", [](TynWalkEntry &e) { e.kind = 3; }},
      {"position[0]", [=](TynWalkEntry &e) { e.position[0] = nan; }},
      {"position[2]", [=](TynWalkEntry &e) { e.position[2] = -inf; }},
      {"direction", [](TynWalkEntry &e) { e.kind = TYN_ENTRY_INSIDE, e.direction[2] = 0.5f; }},
      {"direction", [](TynWalkEntry &e) { e.kind = TYN_ENTRY_REFRACT, e.direction[2] = 0; }},
      {"direction[1]", [=](TynWalkEntry &e) { e.kind = TYN_ENTRY_INSIDE, e.direction[1] = nan; }},
      {"mesh", [](TynWalkEntry &e) { e.mesh = 1; }},
      {"mesh", [](TynWalkEntry &e) { e.mesh = TYN_NONE; }},
      {"weight[0]", [](TynWalkEntry &e) { e.weight[0] = -1; }},
      {"weight[1]", [=](TynWalkEntry &e) { e.weight[1] = inf; }},
      {"weight[2]", [=](TynWalkEntry &e) { e.weight[2] = nan; }},
      {"triangle", [](TynWalkEntry &e) { e.triangle = 12; }},
      {"triangle", [](TynWalkEntry &e) { e.triangle = TYN_NONE; }}, // kind COSINE needs one
      {"triangle", [](TynWalkEntry &e) { e.kind = TYN_ENTRY_INSIDE, e.triangle = 12; }},
      {"albedo[0]", [](TynWalkEntry &e) { e.albedo[0] = 1.5f; }},
      {"albedo[0]", [=](TynWalkEntry &e) { e.albedo[0] = nan; }},
      {"albedo[1]", [](TynWalkEntry &e) { e.albedo[0] = 0.5f, e.albedo[1] = -0.5f; }},
      {"medium", [](TynWalkEntry &e) { e.medium = 1; }},
      {"sigma_t[0]", [=](TynWalkEntry &e) { e.sigma_t[0] = inf; }},
      {"sigma_t[0]", [=](TynWalkEntry &e) { e.sigma_t[0] = nan; }},
      {"sigma_t[2]", [](TynWalkEntry &e) { e.sigma_t[0] = 1, e.sigma_t[2] = -1; }},
      {"reserved", [](TynWalkEntry &e) { e.reserved = 1; }},
      {"reserved", [](TynWalkEntry &e) { e.reserved2 = 7; }},
      {"roughness", [](TynWalkEntry &e) { e.roughness = -0.1f; }},
      {"roughness", [](TynWalkEntry &e) { e.roughness = 1.1f; }},
      {"roughness", [=](TynWalkEntry &e) { e.roughness = nan; }},
  };
  const std::vector<TynWalkEntry> good = entries;
  for (const BadEntry &bad : cases) {
    entries = good;
    bad.spoil(entries[3]);
    EXPECT_EQ(call(), TYN_ERROR_INVALID_ARGUMENT) << bad.field;
    EXPECT_NE(message().find("entry 3"), std::string::npos) << message();
    EXPECT_NE(message().find(bad.field), std::string::npos) << message();
  }
  entries = good;
  EXPECT_EQ(call(), TYN_OK) << message();
}

TEST_F(WalkArguments, IgnoredFieldsMayHoldAnything) {
  entries[0].direction[0] = NAN; // kind COSINE
  entries[1].albedo[1] = 9;      // albedo[0] < 0
  entries[2].sigma_t[2] = -9;    // sigma_t[0] < 0
  EXPECT_EQ(call(), TYN_OK) << message();
  for (const TynWalkExit &exit : exits)
    EXPECT_TRUE(exit.status == TYN_WALK_ESCAPED || exit.status == TYN_WALK_ABSORBED);
}

TEST_F(WalkArguments, RouletteThresholdIsChecked) {
  for (float bad : {0.0f, -1.0f, 1.5f, NAN, INFINITY}) {
    TynWalkOptions options = tyn_walk_options();
    options.roulette_threshold = bad;
    EXPECT_EQ(call(&options), TYN_ERROR_INVALID_ARGUMENT) << bad;
    EXPECT_NE(message().find("roulette_threshold"), std::string::npos) << message();
  }
}

TEST_F(WalkArguments, StructSizeIsChecked) {
  for (size_t bad : {size_t(0), size_t(8), sizeof(TynWalkOptions) + 8}) {
    TynWalkOptions options = tyn_walk_options();
    options.size = bad;
    EXPECT_EQ(call(&options), TYN_ERROR_INVALID_ARGUMENT) << bad;
    EXPECT_NE(message().find("TynWalkOptions"), std::string::npos) << message();
  }
}

TEST_F(WalkArguments, NullIsAnAnswerAndNotACrash) {
  EXPECT_EQ(tyn_walk(nullptr, nullptr, entries.data(), 1, exits.data(), nullptr), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_walk(scene.get(), nullptr, nullptr, 1, exits.data(), nullptr), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_NE(message().find("entries"), std::string::npos) << message();
  EXPECT_EQ(tyn_walk(scene.get(), nullptr, entries.data(), 1, nullptr, nullptr), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_NE(message().find("exits"), std::string::npos) << message();
  EXPECT_EQ(tyn_walk_cl(nullptr, nullptr, nullptr, 1, nullptr, nullptr), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_walk_cl(scene.get(), nullptr, nullptr, 1, nullptr, nullptr), TYN_ERROR_INVALID_ARGUMENT);
}

TEST_F(WalkArguments, ASceneMustBeCommitted) {
  TynScene *open = nullptr;
  ASSERT_EQ(tyn_scene_create(shared_context(), nullptr, &open), TYN_OK);
  EXPECT_EQ(tyn_walk(open, nullptr, entries.data(), 1, exits.data(), nullptr), TYN_ERROR_INVALID_OPERATION);
  tyn_scene_release(open);
}

TEST_F(WalkArguments, BuffersThatAreTooSmallAreRefused) {
  cl_context cl;
  ASSERT_EQ(tyn_context_cl(shared_context(), &cl, nullptr, nullptr), TYN_OK);
  cl_mem buffer = clCreateBuffer(cl, CL_MEM_READ_WRITE, 4 * sizeof(TynWalkEntry), nullptr, nullptr);
  EXPECT_EQ(tyn_walk_cl(scene.get(), nullptr, buffer, 5, buffer, nullptr), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_NE(message().find("entries"), std::string::npos) << message();
  clReleaseMemObject(buffer);
}

TEST_F(WalkArguments, BuffersOfAnotherContextAreRefused) {
  const ContextHandle other = make_context();
  cl_context own_cl, other_cl;
  ASSERT_EQ(tyn_context_cl(shared_context(), &own_cl, nullptr, nullptr), TYN_OK);
  ASSERT_EQ(tyn_context_cl(other.get(), &other_cl, nullptr, nullptr), TYN_OK);
  ASSERT_NE(own_cl, other_cl);
  cl_mem own = clCreateBuffer(own_cl, CL_MEM_READ_WRITE, 5 * sizeof(TynWalkEntry), nullptr, nullptr);
  cl_mem foreign = clCreateBuffer(other_cl, CL_MEM_READ_WRITE, 5 * sizeof(TynWalkEntry), nullptr, nullptr);
  EXPECT_EQ(tyn_walk_cl(scene.get(), nullptr, foreign, 5, own, nullptr), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_NE(message().find("entries belongs to another cl_context"), std::string::npos) << message();
  EXPECT_EQ(tyn_walk_cl(scene.get(), nullptr, own, 5, foreign, nullptr), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_NE(message().find("exits belongs to another cl_context"), std::string::npos) << message();
  clReleaseMemObject(foreign);
  clReleaseMemObject(own);
}

// Their contents are not checked on the host: the kernel ends such walks as lost, and the ledger says so.
TEST_F(WalkArguments, BadIndicesInBuffersEndAsLost) {
  cl_context cl;
  cl_command_queue queue;
  ASSERT_EQ(tyn_context_cl(shared_context(), &cl, &queue, nullptr), TYN_OK);
  entries[0].mesh = 7;
  entries[1].medium = 9;
  entries[2].triangle = 12;
  entries[3].triangle = TYN_NONE;
  cl_mem in =
      clCreateBuffer(cl, CL_MEM_READ_ONLY | CL_MEM_COPY_HOST_PTR, 5 * sizeof(TynWalkEntry), entries.data(), nullptr);
  cl_mem out = clCreateBuffer(cl, CL_MEM_READ_WRITE, 5 * sizeof(TynWalkExit), nullptr, nullptr);
  TynLedger ledger;
  ASSERT_EQ(tyn_walk_cl(scene.get(), nullptr, in, 5, out, &ledger), TYN_OK) << message();
  ASSERT_EQ(clEnqueueReadBuffer(queue, out, CL_TRUE, 0, 5 * sizeof(TynWalkExit), exits.data(), 0, nullptr, nullptr),
            CL_SUCCESS);
  for (int i = 0; i < 4; ++i)
    EXPECT_EQ(exits[size_t(i)].status, uint32_t(TYN_WALK_LOST)) << i;
  EXPECT_EQ(ledger.lost_walks, 4u);
  EXPECT_EQ(ledger.lost[0], 4);
  EXPECT_NEAR(accounted(ledger, 0), 5, 1e-5);
  clReleaseMemObject(out);
  clReleaseMemObject(in);
}

} // namespace
