// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Where the light of entries leaves a mesh by a BSSRDF model: one entry a work-item. The time goes into the probe's ray, so the
// profiles are evaluated one lane wide.
#undef TYN_LANES
#define TYN_LANES 1
#include "bssrdf_mixture.clh"

typedef struct {
  global const TynProfileRecord *records;
  global const float *terms;
  uint channels;
} ProbeModel;

#include "bssrdf_probe.clh"

static float probe_density(const ProbeModel *model, float r) {
  return mixed_density(model->records, model->terms, model->channels, r);
}

static float probe_value(const ProbeModel *model, float r) {
  float sum = 0.0f;
  for (uint c = 0u; c < model->channels; ++c) {
    TynProfileRecord record = model->records[c];
    sum += profile_value(record, model->terms, r * record.per_length);
  }
  return sum;
}

static void exits_clear(global TynBssrdfExit *exit, uint status, float distance) {
  float3 zero = tyn_vec3(0.0f, 0.0f, 0.0f);
  tyn_store3_global(exit->position, zero);
  tyn_store3_global(exit->geometric_normal, zero);
  tyn_store3_global(exit->shading_normal, zero);
  exit->status = status;
  exit->triangle = TYN_NONE;
  exit->hits = 0u;
  exit->u = exit->v = exit->uv[0] = exit->uv[1] = 0.0f;
  exit->distance = distance;
  exit->pdf = 0.0f;
  exit->reserved[0] = exit->reserved[1] = 0u;
}

static void exits_write(global TynBssrdfExit *exit, SceneGeometry geometry, global const uint *turned, uint mesh,
                        const ProbePoint *point) {
  uint triangle = point->hit.triangle;
  TynTriangleRecord record = geometry.triangles[triangle];
  int exchanged = (int)(turned[triangle / 32u] >> (triangle % 32u) & 1u);
  float2 uv = surface_uv(geometry, record, point->hit.u, point->hit.v);
  tyn_store3_global(exit->position, point->position);
  tyn_store3_global(exit->geometric_normal, point->normal);
  tyn_store3_global(exit->shading_normal,
                    surface_shading_normal(geometry, record, point->hit.u, point->hit.v, point->normal));
  exit->status = TYN_BSSRDF_EXIT_FOUND;
  exit->triangle = triangle - geometry.meshes[mesh].first_triangle;
  exit->hits = point->hits;
  exit->u = exchanged ? point->hit.v : point->hit.u;
  exit->v = exchanged ? point->hit.u : point->hit.v;
  exit->uv[0] = uv.x;
  exit->uv[1] = uv.y;
  exit->distance = point->distance;
  exit->pdf = point->pdf;
  exit->reserved[0] = exit->reserved[1] = 0u;
}

static int exits_valid(global const TynBssrdfEntry *entry, uint mesh_count) {
  float3 normal = tyn_load3_global(entry->normal), position = tyn_load3_global(entry->position);
  return entry->mesh < mesh_count && isfinite(tyn_dot(normal, normal)) && isfinite(position.x) &&
         isfinite(position.y) && isfinite(position.z);
}

kernel void bssrdf_exits(global const TynProfileRecord *records, global const float *terms, uint channels, float reach,
                         global const TynBvhNode *nodes, global const TynTriangleBlock *blocks,
                         global const TynTriangleRecord *triangles, global const float *positions,
                         global const float *normals, global const float *uvs, global const TynMeshRecord *meshes,
                         uint mesh_count, global const uint *turned, uint seed_low, uint seed_high, ulong first,
                         global const TynBssrdfEntry *entries, uint count, global TynBssrdfExit *exits,
                         global float *weights, uint with_weights) {
  size_t i = get_global_id(0);
  if (i >= count)
    return;
  const SceneGeometry geometry = {triangles, positions, normals, uvs, meshes};
  global const TynBssrdfEntry *entry = entries + i;
  global TynBssrdfExit *exit = exits + i;
  for (uint c = 0u; c < channels && with_weights; ++c)
    weights[c * (size_t)count + i] = 0.0f;
  if (!exits_valid(entry, mesh_count)) {
    exits_clear(exit, TYN_BSSRDF_EXIT_LOST, 0.0f);
    return;
  }
  ulong path = first + i + ((ulong)entry->path[1] << 32 | entry->path[0]);
  const ProbeModel model = {records, terms, channels};
  Probe probe;
  probe.model = &model;
  probe.nodes = nodes;
  probe.blocks = blocks;
  probe.root = meshes[entry->mesh].root;
  probe.position = tyn_load3_global(entry->position);
  probe.frame = tyn_frame(tyn_normalize(tyn_load3_global(entry->normal)));
  probe.reach = reach;
  probe.path = tyn_uint2((uint)path, (uint)(path >> 32));
  probe.key = tyn_uint2(seed_low, seed_high);

  uint4 random = probe_random(&probe, PROBE_DRAW_RADIUS);
  const LaneUint words[4] = {random.x, random.y, random.z, random.w};
  float radius = draw_radius(records, terms, channels, words);
  ProbePoint point = probe_find(&probe, radius);
  if (!(point.pdf > 0.0f)) {
    exits_clear(exit, TYN_BSSRDF_EXIT_NONE, radius);
    return;
  }
  exits_write(exit, geometry, turned, entry->mesh, &point);
  for (uint c = 0u; c < channels && with_weights; ++c) {
    TynProfileRecord record = records[c];
    weights[c * (size_t)count + i] = profile_value(record, terms, point.distance * record.per_length) / point.pdf;
  }
}
