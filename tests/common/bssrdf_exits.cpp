// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "common/bssrdf_exits.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace tyn_test {

TynBssrdfEntry bssrdf_entry(const float (&position)[3], const float (&normal)[3], uint32_t mesh) {
  TynBssrdfEntry entry{};
  std::copy(position, position + 3, entry.position);
  std::copy(normal, normal + 3, entry.normal);
  entry.mesh = mesh;
  return entry;
}

BssrdfExits exits_of(const BssrdfModel &model, TynScene *scene, const TynBssrdfEntry &entry, size_t count,
                     uint64_t seed) {
  const std::vector<TynBssrdfEntry> entries(count, entry);
  BssrdfExits result{std::vector<TynBssrdfExit>(count), std::vector<float>(count * model.channels())};
  EXPECT_EQ(tyn_bssrdf_sample_exits(model.get(), scene, seed, 0, entries.data(), count, result.exits.data(),
                                    result.weights.data()),
            TYN_OK)
      << tyn_context_message(tyn_scene_context(scene));
  return result;
}

SceneHandle bare_scene(TynContext *context, const MeshData &mesh) {
  TynScene *created = nullptr;
  EXPECT_EQ(tyn_scene_create(context, nullptr, &created), TYN_OK);
  SceneHandle scene(created);
  const TynMesh view = mesh.view();
  EXPECT_EQ(tyn_scene_add_mesh(created, &view, nullptr), TYN_OK) << tyn_context_message(context);
  EXPECT_EQ(tyn_scene_commit(created), TYN_OK) << tyn_context_message(context);
  return scene;
}

} // namespace tyn_test
