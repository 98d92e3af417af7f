// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "walk/walk.hpp"

namespace tyn {

namespace {

// Entries a work-item walks one after the other. On a CPU enough that its lanes stay full (a lane that ends takes the next
// entry) and few enough that the cores end together; on a GPU one, since its hardware keeps itself full.
uint32_t slice_length(const TynContext &context, uint32_t count) {
  if (context.is_gpu())
    return 1;
  uint32_t items = std::max(1u, context.device_info.compute_units) * 32;
  uint32_t longest = std::max(1u, count / items);
  return std::clamp(longest, context.lanes() * 4, context.lanes() * 64);
}

} // namespace

TynWalkParameters walk_parameters(const TynScene &scene, const TynWalkOptions &options) {
  TynWalkParameters parameters{};
  parameters.seed[0] = static_cast<uint32_t>(options.seed);
  parameters.seed[1] = static_cast<uint32_t>(options.seed >> 32);
  parameters.first_path[0] = static_cast<uint32_t>(options.first_path);
  parameters.first_path[1] = static_cast<uint32_t>(options.first_path >> 32);
  parameters.max_scatterings = options.max_scatterings;
  parameters.roulette_threshold = options.roulette_off ? 0.0f : options.roulette_threshold;
  parameters.mesh_count = static_cast<uint32_t>(scene.mesh_records.size());
  parameters.medium_count = static_cast<uint32_t>(scene.medium_records.size());
  parameters.triangle_count = scene.triangle_count;
  return parameters;
}

void enqueue_walk(TynScene &scene, TynWalkParameters parameters, cl_mem entries, cl_mem exits, cl_mem tallies) {
  if (parameters.count == 0)
    return;
  TynContext &context = scene.context;
  const SceneBuffers &b = scene.buffers;
  parameters.slice = slice_length(context, parameters.count);
  size_t items = (parameters.count + size_t(parameters.slice) - 1) / parameters.slice;
  context.launch("walk", "walk_paths", items, context.is_gpu() ? 64 : 1, b.nodes, b.blocks, b.triangles, b.positions,
                 b.normals, b.uvs, b.meshes, b.media, b.phases, b.phase_tables, entries, exits, tallies, b.turned,
                 b.distances, parameters);
}

} // namespace tyn
