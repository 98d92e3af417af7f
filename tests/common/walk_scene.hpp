// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Scenes of one mesh with one medium, entries all over its surface, and walks through it.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "common/meshes.hpp"
#include "tyndall/tyndall.h"

namespace tyn_test {

struct ReleaseContext {
  void operator()(TynContext *context) const { tyn_context_release(context); }
};
struct ReleaseScene {
  void operator()(TynScene *scene) const { tyn_scene_release(scene); }
};
using ContextHandle = std::unique_ptr<TynContext, ReleaseContext>;
using SceneHandle = std::unique_ptr<TynScene, ReleaseScene>;

// A context; a failure fails the test and throws. `lanes` and `memory_limit`: 0 for the defaults; `cache`: "" for none.
ContextHandle make_context(uint32_t lanes = 0, uint64_t memory_limit = 0, const char *cache = nullptr);
// One for the whole program, with the defaults.
TynContext *shared_context();

TynMedium grey_medium(float sigma_a, float sigma_s, float g = 0, float ior = 1);
TynMedium rgb_medium(const float (&sigma_a)[3], const float (&sigma_s)[3], float g = 0, float ior = 1);

// A committed scene with mesh 0 filled with medium 0.
SceneHandle make_scene(TynContext *context, const MeshData &mesh, const TynMedium &medium);
// What the scene has on the device for distance_bound.clh and local_roots.clh.
std::vector<uint32_t> scene_cells(TynScene *scene);
TynMeshInfo mesh_info(const TynScene *scene);

// An entry of weight 1 that leaves everything to the mesh.
TynWalkEntry plain_entry(uint32_t kind);
// `count` entries of kind COSINE, uniform over the surface by area: stratified along the list of triangles.
std::vector<TynWalkEntry> surface_entries(const MeshData &mesh, size_t count, uint32_t seed);

struct Walked {
  std::vector<TynWalkExit> exits;
  TynLedger ledger;
};
// Walks, and fails the test if the call does.
Walked walk(TynScene *scene, const std::vector<TynWalkEntry> &entries,
            const TynWalkOptions &options = tyn_walk_options());

// What the ledger's columns add up to in a channel; it should be ledger.entered.
double accounted(const TynLedger &ledger, int channel);

} // namespace tyn_test
