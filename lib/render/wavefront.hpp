// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// One pass of paths after the other: each stage of a path is a kernel over a queue of paths in device memory.
#pragma once

#include "kernels/shared_render.h"
#include "render/bssrdf_walks.hpp"
#include "render/film.hpp"
#include "render/ledger.hpp"
#include "render/tables.hpp"
#include "render/times.hpp"
#include "scene/scene.hpp"

namespace tyn {

class Wavefront {
public:
  // Takes device memory for up to `most` paths, fewer if the context's limit asks for it. `bssrdf`: in place of walks, or
  // nullptr. Throws OUT_OF_MEMORY.
  Wavefront(TynScene &scene, const SceneTables &tables, size_t most, BssrdfWalks *bssrdf = nullptr);

  size_t capacity() const { return path_capacity; }
  // Largest useful capacity on the context's device.
  static size_t preferred_capacity(const TynContext &context);

  // Traces the paths of a pass, at most capacity(), to their ends and adds them to the film, the ledger and the times. Returns
  // the number of paths whose light was not finite.
  uint32_t trace(const TynRenderParameters &parameters, const TynCameraRecord &camera, const Film &film,
                 RenderLedger &ledger, RenderTimes &times);

private:
  struct Counters {
    uint32_t next, walks, shadows, bad;
  };
  Counters read_counters();
  void bounce(const TynRenderParameters &parameters, uint32_t active);
  void walk(const TynRenderParameters &parameters, uint32_t count, RenderLedger &ledger);
  void trace_shadows(uint32_t count);

  TynScene &scene;
  TynContext &context;
  const SceneTables &tables;
  BssrdfWalks *const bssrdf;
  size_t path_capacity;
  Buffer paths, results, queue, next, shadows, counters;
  Buffer entries, exits, tallies, walk_paths, partial; // empty in a scene without media
};

} // namespace tyn
