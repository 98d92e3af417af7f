// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The batch ray calls: one ray a work-item.
#include "precise.clh"

#include "math.clh"
#include "shared.h"
#include "traverse.clh"

static float3 vertex_position(global const float *positions, uint vertex) {
  return vload3(0, positions + 3 * (size_t)vertex);
}

// The side that the winding makes the outer one. The edges are scaled by a power of two, so that their products
// neither overflow nor underflow. A triangle without area is only hit through rounding, edge-on; whoever asks gets a
// normal towards the ray.
static float3 outward_normal(float3 p0, float3 p1, float3 p2, float3 direction) {
  float3 e1 = p1 - p0, e2 = p2 - p0;
  float3 largest = fmax(fabs(e1), fabs(e2));
  float scale = ldexp(1.0f, -ilogb(fmax(largest.x, fmax(largest.y, largest.z))));
  float3 normal = tyn_cross(e1 * scale, e2 * scale);
  return tyn_dot(normal, normal) > 0.0f ? tyn_normalize(normal) : -direction;
}

static TynHit miss(void) {
  TynHit hit;
  hit.t = INFINITY;
  hit.u = hit.v = 0.0f;
  hit.mesh = hit.triangle = TYN_NONE;
  hit.normal[0] = hit.normal[1] = hit.normal[2] = 0.0f;
  return hit;
}

// `turned`: a bit for each triangle whose second and third vertex the scene exchanged; the caller still means its own.
kernel void intersect(global const TynBvhNode *nodes, global const TynTriangleBlock *blocks,
                      global const TynTriangleRecord *triangles, global const float *positions,
                      global const TynMeshRecord *meshes, global const uint *turned, uint root,
                      global const TynRay *rays, ulong count, global TynHit *hits) {
  size_t i = get_global_id(0);
  if (i >= count)
    return;
  float3 origin = vload3(0, rays[i].origin), direction = vload3(0, rays[i].direction);
  TraceHit found = tyn_trace(nodes, blocks, root, origin, direction, rays[i].t_min, rays[i].t_max, TYN_BOTH_SIDES);
  TynHit hit = miss();
  if (found.triangle != TYN_NONE) {
    TynTriangleRecord triangle = triangles[found.triangle];
    bool exchanged = (turned[found.triangle / 32] >> (found.triangle % 32)) & 1u;
    hit.t = found.t;
    hit.u = exchanged ? found.v : found.u;
    hit.v = exchanged ? found.u : found.v;
    hit.mesh = triangle.mesh;
    hit.triangle = found.triangle - meshes[triangle.mesh].first_triangle;
    float3 normal =
        outward_normal(vertex_position(positions, triangle.vertex[0]), vertex_position(positions, triangle.vertex[1]),
                       vertex_position(positions, triangle.vertex[2]), direction);
    vstore3(normal, 0, hit.normal);
  }
  hits[i] = hit;
}

kernel void occluded(global const TynBvhNode *nodes, global const TynTriangleBlock *blocks, uint root,
                     global const TynRay *rays, ulong count, global uint *result) {
  size_t i = get_global_id(0);
  if (i >= count)
    return;
  float3 origin = vload3(0, rays[i].origin), direction = vload3(0, rays[i].direction);
  result[i] = tyn_trace_any(nodes, blocks, root, origin, direction, rays[i].t_min, rays[i].t_max) ? 1 : 0;
}
