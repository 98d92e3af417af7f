// SPDX-License-Identifier: Apache-2.0
// The renderer's rays. Kernels of their own, so that the traversal is compiled once for each kind of ray.
#include "shared_render.h"
#include "traverse.clh"

// Finds the nearest hit of each path in the queue.
kernel void trace_paths(global const TynBvhNode *nodes, global const TynTriangleBlock *blocks,
                        global TynPathState *paths, global const uint *queue, uint count) {
  uint i = (uint)get_global_id(0);
  if (i >= count)
    return;
  global TynPathState *path = paths + queue[i];
  TraceHit hit = tyn_trace(nodes, blocks, 0, tyn_load3_global(path->origin), tyn_load3_global(path->direction),
                           path->t_min, INFINITY, TYN_BOTH_SIDES);
  path->t = hit.t;
  path->u = hit.u;
  path->v = hit.v;
  path->triangle = hit.triangle;
}

static void trace_add(global float *sum, global const float *light) {
  for (int c = 0; c < 3; ++c)
    sum[c] += light[c];
}

// Adds the light of each shadow ray that arrives. A path has at most one shadow ray in a queue.
kernel void trace_shadows(global const TynBvhNode *nodes, global const TynTriangleBlock *blocks,
                          global const TynShadowRay *shadows, uint count, global TynPathResult *results) {
  uint i = (uint)get_global_id(0);
  if (i >= count)
    return;
  global const TynShadowRay *shadow = shadows + i;
  if (tyn_trace_any(nodes, blocks, 0, tyn_load3_global(shadow->origin), tyn_load3_global(shadow->direction), 0.0f,
                    shadow->t_max))
    return;
  global TynPathResult *result = results + shadow->path;
  trace_add(result->light[shadow->first_event], shadow->first);
  trace_add(result->light[shadow->second_event], shadow->second);
}
