// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// A batch over several objects and media, with colours of its own for some entries: each walk is, bit by bit, the one that it is
// in a scene of its object alone, in a batch of that object's entries, in a medium that has its colours, and by itself.
#include <cstring>

#include <gtest/gtest.h>

#include "common/walk_scene.hpp"

namespace {

using namespace tyn_test;

const size_t count = 1200;

const std::vector<MeshData> &objects() {
  static const std::vector<MeshData> list = {torus(1, 0.4f, 24, 12), translated(cube(), 3, 0, 0),
                                             translated(icosphere(3), 0, 2.5f, 0), needles(16, 5)};
  return list;
}

// Of each object, and one more that entries name.
std::vector<TynMedium> media(const TynPhase &phase) {
  std::vector<TynMedium> list = {rgb_medium({0.1f, 0.3f, 1}, {3, 2, 5}, 0.7f, 1.4f), grey_medium(0.5f, 4),
                                 rgb_medium({0, 0, 0}, {0.5f, 1, 8}, -0.3f, 1.2f), grey_medium(0.25f, 0.75f, 0, 1.5f),
                                 rgb_medium({1, 0.5f, 0.25f}, {1, 1.5f, 3.75f}, 0.7f, 1.4f)};
  list[1].phase = &phase;
  return list;
}

TynPhase rayleigh() {
  TynPhase phase = tyn_phase();
  phase.kind = TYN_PHASE_RAYLEIGH;
  return phase;
}

// Every medium, and the objects named; object i is filled with medium i.
SceneHandle scene_of(const std::vector<uint32_t> &chosen) {
  TynScene *created = nullptr;
  EXPECT_EQ(tyn_scene_create(shared_context(), nullptr, &created), TYN_OK);
  SceneHandle scene(created);
  const TynPhase phase = rayleigh();
  for (const TynMedium &medium : media(phase))
    EXPECT_EQ(tyn_scene_add_medium(scene.get(), &medium, nullptr), TYN_OK);
  for (uint32_t object : chosen) {
    TynMesh mesh = objects()[object].view();
    mesh.medium = object;
    EXPECT_EQ(tyn_scene_add_mesh(scene.get(), &mesh, nullptr), TYN_OK);
  }
  EXPECT_EQ(tyn_scene_commit(scene.get()), TYN_OK);
  return scene;
}

// Neighbours are in different objects, enter in different ways, and have different colours.
std::vector<TynWalkEntry> mixed_entries() {
  std::vector<std::vector<TynWalkEntry>> of_object;
  for (uint32_t object = 0; object < objects().size(); ++object)
    of_object.push_back(surface_entries(objects()[object], count, 70 + object));
  std::vector<TynWalkEntry> entries;
  for (size_t i = 0; i < count; ++i) {
    const uint32_t object = uint32_t(i * 7 / 3 % objects().size());
    TynWalkEntry entry = of_object[object][i];
    entry.mesh = object;
    entry.roughness = i % 5 == 2 ? 0.3f : 0.0f;
    if (i % 4 == 1) {
      entry.kind = TYN_ENTRY_REFRACT;
      entry.direction[0] = 0.6f;
      entry.direction[2] = -0.8f;
    }
    if (i % 3 == 1) {
      const float own[3] = {0.5f, 0.75f, 0.9375f}, radius[3] = {2, 2, 4};
      std::copy(own, own + 3, entry.albedo);
      std::copy(radius, radius + 3, entry.sigma_t);
    }
    if (i % 6 == 3)
      entry.medium = 4;
    entries.push_back(entry);
  }
  return entries;
}

class WalkObjects : public testing::Test {
protected:
  WalkObjects() {
    for (uint32_t object = 0; object < objects().size(); ++object)
      all.push_back(object);
    scene = scene_of(all);
    options.seed = 7;
    options.first_path = 1000;
    together = walk(scene.get(), entries, options).exits;
  }

  static bool same(const TynWalkExit &a, const TynWalkExit &b) { return std::memcmp(&a, &b, sizeof a) == 0; }

  std::vector<uint32_t> all;
  SceneHandle scene;
  std::vector<TynWalkEntry> entries = mixed_entries();
  TynWalkOptions options = tyn_walk_options();
  std::vector<TynWalkExit> together;
};

TEST_F(WalkObjects, EachAloneGivesTheSameBits) {
  for (uint32_t object : all) {
    SceneHandle alone = scene_of({object});
    std::vector<TynWalkEntry> own;
    std::vector<size_t> numbers;
    for (size_t i = 0; i < count; ++i) {
      if (entries[i].mesh != object)
        continue;
      own.push_back(entries[i]);
      own.back().mesh = 0;
      own.back().path[0] = uint32_t(i - numbers.size()); // to walk number i
      numbers.push_back(i);
    }
    EXPECT_GT(own.size(), count / 8);
    const std::vector<TynWalkExit> exits = walk(alone.get(), own, options).exits;
    for (size_t i = 0; i < numbers.size(); ++i)
      ASSERT_TRUE(same(exits[i], together[numbers[i]])) << "object " << object << " walk " << numbers[i];
  }
}

// An entry's own colours are those of a medium that has them, where that medium is like the object's in all else.
TEST_F(WalkObjects, ColoursOfAnEntryAreThoseOfAMedium) {
  size_t checked = 0;
  std::vector<TynWalkEntry> named = entries;
  for (TynWalkEntry &entry : named) {
    if (entry.mesh != 0 || entry.albedo[0] < 0)
      continue;
    entry.albedo[0] = entry.sigma_t[0] = -1;
    entry.medium = 4;
    ++checked;
  }
  EXPECT_GT(checked, count / 20);
  const std::vector<TynWalkExit> exits = walk(scene.get(), named, options).exits;
  for (size_t i = 0; i < count; ++i)
    ASSERT_TRUE(same(exits[i], together[i])) << "walk " << i;
  for (TynWalkEntry &entry : named)
    entry.medium = TYN_NONE; // and in the object's own they are others
  const std::vector<TynWalkExit> others = walk(scene.get(), named, options).exits;
  size_t different = 0;
  for (size_t i = 0; i < count; ++i)
    different += !same(others[i], together[i]);
  EXPECT_GT(different, checked / 2);
}

TEST_F(WalkObjects, OneEntryAtATimeGivesTheSameBits) {
  for (size_t i = 0; i < count; i += 13) {
    TynWalkOptions one = options;
    one.first_path += i;
    ASSERT_TRUE(same(walk(scene.get(), {entries[i]}, one).exits[0], together[i])) << "walk " << i;
  }
}

} // namespace
