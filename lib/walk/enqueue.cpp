// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "walk/walk.hpp"

namespace tyn {

namespace {

// Entries a work-item takes at a time. On a CPU a few times its lanes, so that neighbours stay together and the cores end
// together; on a GPU one, since its hardware keeps itself full.
uint32_t slice_length(const TynContext &context, uint32_t count) {
  if (context.is_gpu())
    return 1;
  uint32_t items = std::max(1u, context.device_info.compute_units) * 8;
  return std::clamp(count / items, context.lanes(), context.lanes() * 4);
}

// On a CPU one for each core: a lane is idle only when all entries are taken. On a GPU one for each entry.
size_t item_count(const TynContext &context, const TynWalkParameters &parameters) {
  size_t slices = (parameters.count + size_t(parameters.slice) - 1) / parameters.slice;
  return context.is_gpu() ? slices : std::min<size_t>(slices, std::max(1u, context.device_info.compute_units));
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
  return parameters;
}

void enqueue_walk(TynScene &scene, TynWalkParameters parameters, cl_mem entries, cl_mem exits, cl_mem tallies) {
  if (parameters.count == 0)
    return;
  TynContext &context = scene.context;
  const SceneBuffers &b = scene.buffers;
  parameters.slice = slice_length(context, parameters.count);
  context.fill_zero(b.walk_queue);
  context.launch("walk", "walk_paths", item_count(context, parameters), context.is_gpu() ? 64 : 1, b.nodes, b.blocks,
                 b.triangles, b.positions, b.normals, b.uvs, b.meshes, b.media, b.phases, b.phase_tables, entries,
                 exits, tallies, b.turned, b.cells, b.walk_queue, parameters);
}

} // namespace tyn
