// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Walks in media with a phase function: their bits, and what a scene keeps of it.
#include <algorithm>
#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include "common/phases.hpp"
#include "common/walk_scene.hpp"
#include "media/media.hpp"
#include "scene/scene.hpp"

namespace {

using namespace tyn_test;

TynMedium test_medium(const TynPhase *phase) {
  TynMedium medium = rgb_medium({0.3f, 0.1f, 0.02f}, {1, 4, 9}, 0, 1.4f);
  medium.phase = phase;
  return medium;
}

MeshData test_mesh() { return torus(1.0f, 0.4f, 24, 12); }

void expect_same_bits(const std::vector<TynWalkExit> &a, const std::vector<TynWalkExit> &b) {
  ASSERT_EQ(a.size(), b.size());
  for (size_t i = 0; i < a.size(); ++i)
    ASSERT_EQ(std::memcmp(&a[i], &b[i], sizeof a[i]), 0) << "walk " << i;
}

// One mesh in two media, of which only one has a phase function of its own: entries 2 i are in the first, 2 i + 1 in the other.
std::vector<TynWalkExit> walk_in_two_media(uint32_t lanes, size_t begin = 0, size_t end = 600) {
  ContextHandle context = make_context(lanes);
  const TynPhase phase = draine_phase(0.5, 10);
  TynScene *handle = nullptr;
  EXPECT_EQ(tyn_scene_create(context.get(), nullptr, &handle), TYN_OK);
  SceneHandle scene(handle);
  TynMedium plain = test_medium(nullptr), other = test_medium(&phase);
  EXPECT_EQ(tyn_scene_add_medium(handle, &plain, nullptr), TYN_OK);
  EXPECT_EQ(tyn_scene_add_medium(handle, &other, nullptr), TYN_OK);
  MeshData data = test_mesh();
  TynMesh mesh = data.view();
  mesh.medium = 0;
  EXPECT_EQ(tyn_scene_add_mesh(handle, &mesh, nullptr), TYN_OK);
  EXPECT_EQ(tyn_scene_commit(handle), TYN_OK) << tyn_context_message(context.get());
  std::vector<TynWalkEntry> entries = surface_entries(data, 600, 31);
  for (size_t i = 0; i < entries.size(); ++i)
    entries[i].medium = uint32_t(i % 2);
  TynWalkOptions options = tyn_walk_options();
  options.first_path = begin;
  return walk(handle, {entries.begin() + long(begin), entries.begin() + long(end)}, options).exits;
}

TEST(WalkPhase, AllLaneWidthsGiveTheSameBits) {
  std::vector<TynWalkExit> reference = walk_in_two_media(1);
  for (uint32_t lanes : {4u, 8u, 16u}) {
    SCOPED_TRACE(lanes);
    expect_same_bits(reference, walk_in_two_media(lanes));
  }
}

TEST(WalkPhase, SplittingABatchChangesNoBit) {
  std::vector<TynWalkExit> whole = walk_in_two_media(0), parts = walk_in_two_media(0, 0, 101);
  std::vector<TynWalkExit> rest = walk_in_two_media(0, 101, 600);
  parts.insert(parts.end(), rest.begin(), rest.end());
  expect_same_bits(whole, parts);
}

// Named by a TynPhase or by TynMedium::g, Henyey-Greenstein's walks are the same.
TEST(WalkPhase, HenyeyGreensteinIsTheSameByEitherName) {
  MeshData mesh = test_mesh();
  std::vector<TynWalkEntry> entries = surface_entries(mesh, 400, 5);
  const TynPhase half = henyey_greenstein_phase(0.5), isotropic = tyn_phase();
  for (const TynPhase *phase : {&half, &isotropic}) {
    TynMedium medium = test_medium(nullptr);
    medium.g = phase == &half ? 0.5f : 0.0f;
    SceneHandle by_g = make_scene(shared_context(), mesh, medium);
    SceneHandle by_phase = make_scene(shared_context(), mesh, test_medium(phase));
    expect_same_bits(walk(by_g.get(), entries).exits, walk(by_phase.get(), entries).exits);
  }
}

TEST(WalkPhase, ASceneKeepsACopy) {
  TynScene *handle = nullptr;
  ASSERT_EQ(tyn_scene_create(shared_context(), nullptr, &handle), TYN_OK);
  SceneHandle scene(handle);
  {
    double cosines[] = {-1, 0, 1}, values[] = {1, 2, 3};
    TynPhase phase = tyn_phase();
    phase.kind = TYN_PHASE_TABULATED;
    phase.cosines = cosines;
    phase.values = values;
    phase.count = 3;
    TynMedium medium = test_medium(&phase);
    medium.g = NAN; // ignored
    ASSERT_EQ(tyn_scene_add_medium(handle, &medium, nullptr), TYN_OK) << tyn_context_message(shared_context());
    std::fill_n(values, 3, -1.0);
    phase.kind = 99;
  }
  TynMedium back = tyn_medium();
  ASSERT_EQ(tyn_scene_medium(handle, 0, &back), TYN_OK);
  for (int i = 0; i < 20; i++) { // the list grows; what was handed out stays
    TynMedium more = tyn_medium();
    ASSERT_EQ(tyn_scene_add_medium(handle, &more, nullptr), TYN_OK);
  }
  ASSERT_NE(back.phase, nullptr);
  EXPECT_EQ(back.phase->kind, uint32_t(TYN_PHASE_TABULATED));
  EXPECT_EQ(back.phase->count, 3u);
  EXPECT_EQ(back.phase->values[2], 3.0);
  EXPECT_EQ(back.phase->cosines[0], -1.0);
  ASSERT_EQ(tyn_scene_medium(handle, 1, &back), TYN_OK);
  EXPECT_EQ(back.phase, nullptr);
}

TEST(WalkPhase, CommitGivesTheMeanCosineAndARecord) {
  const TynPhase lobes = two_lobe_phase(0.8, -0.4, 0.75);
  SceneHandle scene = make_scene(shared_context(), test_mesh(), test_medium(&lobes));
  ASSERT_EQ(scene->medium_records.size(), 1u);
  EXPECT_FLOAT_EQ(scene->medium_records[0].g, 0.5f);
  EXPECT_EQ(scene->medium_records[0].phase, 0u);
  SceneHandle plain = make_scene(shared_context(), test_mesh(), test_medium(nullptr));
  EXPECT_EQ(plain->medium_records[0].phase, TYN_NONE);
}

// A program compiled before media had phase functions.
TEST(WalkPhase, MediaOfTheFirstVersionAreStillRead) {
  TynScene *handle = nullptr;
  ASSERT_EQ(tyn_scene_create(shared_context(), nullptr, &handle), TYN_OK);
  SceneHandle scene(handle);
  const TynPhase unseen = draine_phase(0.5, 1);
  TynMedium medium = test_medium(&unseen);
  medium.size = tyn::first_medium_size;
  ASSERT_EQ(tyn_scene_add_medium(handle, &medium, nullptr), TYN_OK) << tyn_context_message(shared_context());
  EXPECT_EQ(scene->media[0].value.phase, nullptr);
  ASSERT_EQ(tyn_scene_medium(handle, 0, &medium), TYN_OK);
  EXPECT_EQ(medium.phase, &unseen) << "beyond the caller's struct nothing is written";
  ASSERT_EQ(tyn_medium_preset("marble", 1e-3, &medium), TYN_OK);
  EXPECT_EQ(medium.phase, &unseen);
  EXPECT_EQ(medium.size, tyn::first_medium_size);
  TynMediumDescription description;
  EXPECT_EQ(tyn_medium_describe(&medium, 1e-3, 1, &description), TYN_OK);
}

// The transport mean free path is 1 / (sigma_a + sigma_s (1 - <cos>)), whatever the phase function.
TEST(WalkPhase, ADescriptionUsesTheMeanCosine) {
  const TynPhase lobes = two_lobe_phase(0.8, -0.4, 0.75);
  TynMedium medium = grey_medium(1, 8);
  medium.phase = &lobes;
  TynMediumDescription description;
  ASSERT_EQ(tyn_medium_describe(&medium, 1e-3, 1, &description), TYN_OK);
  EXPECT_NEAR(description.transport_mean_free_path_mm[0], 1 / (1 + 8 * 0.5), 1e-12);
}

} // namespace
