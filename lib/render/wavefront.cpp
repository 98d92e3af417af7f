// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "render/wavefront.hpp"

#include <algorithm>

#include "core/kernel_times.hpp"
#include "walk/walk.hpp"

namespace tyn {
namespace {

// One local size for all launches, because PoCL compiles a kernel anew for each.
constexpr size_t local_size = 64;

constexpr size_t path_bytes =
    sizeof(TynPathState) + sizeof(TynPathResult) + 2 * sizeof(uint32_t) + sizeof(TynShadowRay);
constexpr size_t walk_bytes = sizeof(TynWalkEntry) + sizeof(TynWalkExit) + sizeof(TynWalkTally) + sizeof(uint32_t);

size_t fitting_capacity(const TynScene &scene, size_t most) {
  const TynContext &context = scene.context;
  const size_t ledger = RenderLedger::partial_bytes(1) / TYN_LEDGER_SLICE + 1;
  const size_t each = path_bytes + (scene.medium_records.empty() ? 0 : walk_bytes + ledger);
  const uint64_t fixed = RenderLedger::partial_bytes(1) + TYN_COUNTERS * sizeof(uint32_t);
  const uint64_t available = context.memory_available();
  const uint64_t fits = std::min<uint64_t>(available > fixed ? (available - fixed) / each : 0,
                                           context.largest_buffer() / sizeof(TynWalkExit));
  if (fits == 0)
    fail(TYN_ERROR_OUT_OF_MEMORY, "%llu bytes of device memory are left; a path of the renderer needs %zu",
         static_cast<unsigned long long>(available), each + size_t(fixed));
  return size_t(std::min<uint64_t>(fits, most));
}

} // namespace

size_t Wavefront::preferred_capacity(const TynContext &context) {
  // PoCL compiles a kernel once more for grids above 65535 work-items; and that many paths stay close to a CPU's caches.
  return context.is_gpu() || context.device_info.compute_units > 32 ? 1 << 20 : 65535 / local_size * local_size;
}

Wavefront::Wavefront(TynScene &owner, const SceneTables &records, size_t most, BssrdfWalks *instead)
    : scene(owner), context(owner.context), tables(records), bssrdf(instead),
      path_capacity(fitting_capacity(owner, most)), paths(context, path_capacity * sizeof(TynPathState)),
      results(context, path_capacity * sizeof(TynPathResult)), queue(context, path_capacity * sizeof(uint32_t)),
      next(context, path_capacity * sizeof(uint32_t)), shadows(context, path_capacity * sizeof(TynShadowRay)),
      counters(context, TYN_COUNTERS * sizeof(uint32_t)) {
  const size_t walks = scene.medium_records.empty() ? 0 : path_capacity;
  entries = Buffer(context, walks * sizeof(TynWalkEntry));
  exits = Buffer(context, walks * sizeof(TynWalkExit));
  tallies = Buffer(context, walks * sizeof(TynWalkTally));
  walk_paths = Buffer(context, walks * sizeof(uint32_t));
  partial = Buffer(context, RenderLedger::partial_bytes(walks));
}

Wavefront::Counters Wavefront::read_counters() {
  uint32_t values[TYN_COUNTERS];
  context.read(counters, values, sizeof values);
  return {values[TYN_COUNT_NEXT], values[TYN_COUNT_WALKS], values[TYN_COUNT_SHADOWS], values[TYN_COUNT_BAD]};
}

void Wavefront::bounce(const TynRenderParameters &parameters, uint32_t active) {
  const SceneBuffers &b = scene.buffers;
  const SceneTables &t = tables;
  context.launch("render_trace", "trace_paths", active, local_size, b.nodes, b.blocks, paths, queue, active);
  context.launch("render_shade", "shade", active, local_size, paths, results, queue, active, next, shadows, counters,
                 entries, walk_paths, b.triangles, b.positions, b.normals, b.uvs, b.meshes, b.media, t.media,
                 t.materials, t.textures, t.images.records, t.images.bytes, t.images.floats, t.images.decode,
                 t.emitters, t.lights, t.texels, parameters);
}

void Wavefront::walk(const TynRenderParameters &parameters, uint32_t count, RenderLedger &ledger) {
  if (bssrdf) {
    bssrdf->enqueue(parameters, count, entries.get(), exits.get(), tallies.get());
  } else {
    TynWalkParameters walk = walk_parameters(scene, tyn_walk_options());
    walk.seed[0] = parameters.seed[0];
    walk.seed[1] = parameters.seed[1];
    walk.count = count;
    enqueue_walk(scene, walk, entries.get(), exits.get(), tallies.get());
  }
  ledger.add(context, entries, exits, tallies, count, partial);
  const SceneBuffers &b = scene.buffers;
  const SceneTables &t = tables;
  context.launch("render_exit", "shade_exits", count, local_size, b.nodes, b.blocks, paths, results, exits, entries,
                 walk_paths, count, next, counters, b.triangles, b.positions, b.normals, b.uvs, b.meshes, b.media,
                 t.media, t.materials, t.textures, t.images.records, t.images.bytes, t.images.floats, t.images.decode,
                 t.emitters, t.lights, t.texels, parameters);
}

void Wavefront::trace_shadows(uint32_t count) {
  context.launch("render_trace", "trace_shadows", count, local_size, scene.buffers.nodes, scene.buffers.blocks, shadows,
                 count, results);
}

uint32_t Wavefront::trace(const TynRenderParameters &parameters, const TynCameraRecord &camera, const Film &film,
                          RenderLedger &ledger, RenderTimes &times) {
  const KernelTimes launches(context);
  uint32_t active = parameters.pixel_count * parameters.sample_count;
  context.launch("render_camera", "camera_rays", active, local_size, paths, results, queue, parameters, camera);
  while (active > 0) {
    context.fill_zero(counters);
    bounce(parameters, active);
    Counters counts = read_counters();
    trace_shadows(counts.shadows);
    if (counts.walks > 0) {
      walk(parameters, counts.walks, ledger);
      counts = read_counters();
    }
    std::swap(queue, next);
    active = counts.next;
  }
  context.fill_zero(counters);
  context.launch("render_film", "film_add", parameters.pixel_count, local_size, film.buffer(), results, counters,
                 parameters);
  const uint32_t bad = read_counters().bad;
  times.add(launches);
  return bad;
}

} // namespace tyn
