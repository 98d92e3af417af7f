// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Exit points drawn on a scene. A failure fails the test.
#pragma once

#include <cstdint>
#include <vector>

#include "common/bssrdf_model.hpp"
#include "common/walk_scene.hpp"

namespace tyn_test {

struct BssrdfExits {
  std::vector<TynBssrdfExit> exits;
  std::vector<float> weights; // channel by channel
};

TynBssrdfEntry bssrdf_entry(const float (&position)[3], const float (&normal)[3], uint32_t mesh = 0);

// `count` exits of one entry.
BssrdfExits exits_of(const BssrdfModel &model, TynScene *scene, const TynBssrdfEntry &entry, size_t count,
                     uint64_t seed);

// A committed scene of one mesh without a medium.
SceneHandle bare_scene(TynContext *context, const MeshData &mesh);

} // namespace tyn_test
