// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Exit points on a scene: the batch call on host pointers and on the caller's buffers.
#include <algorithm>

#include "bssrdf/bssrdf.hpp"
#include "core/batch.hpp"
#include "core/buffer_argument.hpp"
#include "scene/scene.hpp"

namespace tyn {
namespace {

constexpr size_t MOST = 1 << 17; // entries in flight
// One local size for all launches, because PoCL compiles a kernel anew for each.
constexpr size_t LOCAL_SIZE = 64;

struct Draw {
  TynBssrdf &bssrdf;
  TynScene &scene;
  uint64_t seed;
};

void validate_entry(const TynScene &scene, const TynBssrdfEntry &entry) {
  require_each(require_finite, "position", entry.position);
  require_unit("normal", entry.normal);
  require_index("mesh", entry.mesh, scene.mesh_records.size(), "meshes");
  if (entry.reserved || entry.reserved2[0] || entry.reserved2[1])
    fail(TYN_ERROR_INVALID_ARGUMENT, "reserved fields are %u, %u and %u; they must be 0", entry.reserved,
         entry.reserved2[0], entry.reserved2[1]);
}

void validate_entries(const TynScene &scene, const TynBssrdfEntry *entries, size_t count) {
  for (size_t i = 0; i < count; i++) {
    try {
      validate_entry(scene, entries[i]);
    } catch (const Failure &failure) {
      fail(failure.status, "entry %zu: %s", i, failure.what());
    }
  }
}

void launch(const Draw &draw, uint64_t first, cl_mem entries, size_t count, cl_mem exits, cl_mem weights) {
  TynBssrdf &bssrdf = draw.bssrdf;
  const SceneBuffers &b = draw.scene.buffers;
  // a kernel has to be given a buffer, also where it is not used
  bssrdf.context.launch("bssrdf_exits", "bssrdf_exits", count, LOCAL_SIZE, bssrdf.records, bssrdf.terms,
                        bssrdf.channels(), bssrdf.reach, b.nodes, b.blocks, b.triangles, b.positions, b.normals, b.uvs,
                        b.meshes, uint32_t(draw.scene.mesh_records.size()), b.turned, uint32_t(draw.seed),
                        uint32_t(draw.seed >> 32), cl_ulong(first), entries, uint32_t(count), exits,
                        weights ? weights : exits, uint32_t(weights != nullptr));
}

void draw_on_host(const Draw &draw, uint64_t first, const TynBssrdfEntry *entries, size_t count, TynBssrdfExit *exits,
                  float *weights) {
  TynContext &context = draw.bssrdf.context;
  const uint32_t rows = weights ? draw.bssrdf.channels() : 0;
  const size_t batch =
      batch_size(context, count, MOST, sizeof(TynBssrdfEntry) + sizeof(TynBssrdfExit) + rows * sizeof(float),
                 std::max(sizeof(TynBssrdfExit), rows * sizeof(float)), "entry");
  Buffer entry_buffer(context, batch * sizeof(TynBssrdfEntry), CL_MEM_READ_ONLY);
  Buffer exit_buffer(context, batch * sizeof(TynBssrdfExit));
  Buffer weight_buffer(context, batch * rows * sizeof(float));
  for (size_t begin = 0; begin < count; begin += batch) {
    const size_t size = std::min(batch, count - begin);
    context.write(entry_buffer, entries + begin, size * sizeof(TynBssrdfEntry));
    launch(draw, first + begin, entry_buffer.get(), size, exit_buffer.get(), rows ? weight_buffer.get() : nullptr);
    context.read(exit_buffer, exits + begin, size * sizeof(TynBssrdfExit));
    for (uint32_t row = 0; row < rows; row++)
      context.read(weight_buffer, weights + row * count + begin, size * sizeof(float), row * size * sizeof(float));
  }
}

void draw_on_device(const Draw &draw, uint64_t first, cl_mem entries, size_t count, cl_mem exits, cl_mem weights) {
  TynContext &context = draw.bssrdf.context;
  if (count > UINT32_MAX)
    fail(TYN_ERROR_INVALID_ARGUMENT, "count is %zu; it must be at most %u", count, UINT32_MAX);
  require_buffer(context, "entries", entries, count, sizeof(TynBssrdfEntry));
  require_buffer(context, "exits", exits, count, sizeof(TynBssrdfExit));
  if (weights)
    require_buffer(context, "weights", weights, count, draw.bssrdf.channels() * sizeof(float));
  launch(draw, first, entries, count, exits, weights);
  context.flush();
}

// At the C boundary: the objects must be there and belong together; nothing more is checked or done for no entries.
template <class Body>
TynStatus for_entries(TynBssrdf *bssrdf, TynScene *scene, size_t count, Body &&body) {
  if (!bssrdf)
    return TYN_ERROR_INVALID_ARGUMENT;
  return guarded(&bssrdf->context, [&] {
    require_pointer("scene", scene);
    if (&scene->context != &bssrdf->context)
      fail(TYN_ERROR_INVALID_ARGUMENT, "scene belongs to another context than bssrdf");
    if (bssrdf->transmitted)
      fail(TYN_ERROR_INVALID_ARGUMENT, "bssrdf is of light that a slab transmits, which leaves on another side");
    scene->require_committed();
    if (count > 0)
      body();
  });
}

} // namespace
} // namespace tyn

using namespace tyn;

TynStatus tyn_bssrdf_sample_exits(TynBssrdf *bssrdf, TynScene *scene, uint64_t seed, uint64_t first,
                                  const TynBssrdfEntry *entries, size_t count, TynBssrdfExit *exits, float *weights) {
  return for_entries(bssrdf, scene, count, [&] {
    require_pointer("entries", entries);
    require_pointer("exits", exits);
    validate_entries(*scene, entries, count);
    draw_on_host({*bssrdf, *scene, seed}, first, entries, count, exits, weights);
  });
}

TynStatus tyn_bssrdf_sample_exits_cl(TynBssrdf *bssrdf, TynScene *scene, uint64_t seed, uint64_t first, cl_mem entries,
                                     size_t count, cl_mem exits, cl_mem weights) {
  return for_entries(bssrdf, scene, count, [&] {
    draw_on_device({*bssrdf, *scene, seed}, first, entries, count, exits, weights);
  });
}
