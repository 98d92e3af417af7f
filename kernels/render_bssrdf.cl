// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// A BSSRDF model in place of walks: reads what the walk kernel would and writes what it would have, one entry a work-item. The
// interface is behind the light already, on the way in, and before it, as shade_exits' lobe, on the way out.
//
// Colour. The radius is drawn from one of the three channels' profiles, in proportion to what each sends back of its weight,
// and all are weighted by the density over the three.
#undef TYN_LANES
#define TYN_LANES 1
#include "bssrdf_family.clh"

typedef struct {
  Blend blend[3];
  float chance[3];        // with which a channel's radius is drawn
  float3 albedo, entered; // of weight
  float reach;
} Colours;

typedef struct {
  const Families *all;
  const Colours *colours;
} ProbeModel;

#include "bssrdf_probe.clh"

// Outside, of a direction inside (Snell).
static float cosine_outside(float3 direction, float3 normal, float ior) {
  float cosine = tyn_dot(direction, normal);
  return sqrt(clamp(1.0f - ior * ior * (1.0f - cosine * cosine), 0.0f, 1.0f));
}

static Colours colours_of(const Families *all, global const TynWalkEntry *entry, global const TynMediumRecord *medium,
                          uint index, float cosine) {
  Colours colours;
  colours.reach = 0.0f;
  colours.entered = tyn_load3_global(entry->weight);
  float sum = 0.0f;
  for (int c = 0; c < 3; ++c) {
    float albedo = entry->albedo[0] >= 0.0f ? entry->albedo[c] : medium->albedo[c];
    float sigma_t = entry->sigma_t[0] >= 0.0f ? entry->sigma_t[c] : medium->sigma_t[c];
    colours.blend[c] = family_blend(all, index, albedo, medium->g, sigma_t, cosine);
    colours.chance[c] = colours.blend[c].albedo * entry->weight[c];
    if (colours.chance[c] > 0.0f)
      colours.reach = fmax(colours.reach, colours.blend[c].reach);
    sum += colours.chance[c];
  }
  for (int c = 0; c < 3; ++c)
    colours.chance[c] = sum > 0.0f ? colours.chance[c] / sum : 0.0f;
  colours.albedo = tyn_vec3(colours.blend[0].albedo, colours.blend[1].albedo, colours.blend[2].albedo);
  return colours;
}

static float colours_draw(const Families *all, const Colours *colours, uint4 random) {
  float u = tyn_uniform(random.x);
  int c = u < colours->chance[0] ? 0 : u < colours->chance[0] + colours->chance[1] ? 1 : 2;
  if (colours->chance[c] == 0.0f) // rounding must not lead there
    c = colours->chance[0] > 0.0f ? 0 : 1;
  return blend_draw(all, colours->blend + c, tyn_uniform(random.w), lane_uniform_fine(random.y),
                    lane_uniform_fine(random.z));
}

static float probe_density(const ProbeModel *model, float r) {
  const Colours *colours = model->colours;
  float sum = 0.0f;
  for (int c = 0; c < 3; ++c)
    if (colours->chance[c] > 0.0f)
      sum += colours->chance[c] * blend_density(model->all, colours->blend + c, r);
  return sum;
}

// What leaves at distance r, of all that entered.
static float3 colours_value(const Families *all, const Colours *colours, float r) {
  return tyn_vec3(blend_value(all, colours->blend, r), blend_value(all, colours->blend + 1, r),
                  blend_value(all, colours->blend + 2, r)) *
         colours->entered;
}

static float probe_value(const ProbeModel *model, float r) {
  float3 value = colours_value(model->all, model->colours, r);
  return value.x + value.y + value.z;
}

// `kept`: the fraction of the weight that the model lets out over a plane; `weight`: that goes out here.
static void bssrdf_tally(global TynWalkTally *tally, float3 entered, float3 kept, float3 weight) {
  tyn_store3_global(tally->reflected, tyn_vec3(0.0f, 0.0f, 0.0f));
  tyn_store3_global(tally->absorbed, entered - entered * kept);
  tyn_store3_global(tally->balance, entered * kept - weight);
  tally->rays = 1u;
}

static void bssrdf_end(global TynWalkExit *exit, uint status, float3 position, float3 weight) {
  float3 zero = tyn_vec3(0.0f, 0.0f, 0.0f);
  tyn_store3_global(exit->position, position);
  tyn_store3_global(exit->direction, tyn_vec3(0.0f, 0.0f, 1.0f));
  tyn_store3_global(exit->weight, weight);
  tyn_store3_global(exit->geometric_normal, zero);
  tyn_store3_global(exit->shading_normal, zero);
  exit->status = status;
  exit->triangle = TYN_NONE;
  exit->scatterings = exit->reserved = 0u;
  exit->path_length = exit->u = exit->v = exit->uv[0] = exit->uv[1] = 0.0f;
}

static void bssrdf_leave(global TynWalkExit *exit, SceneGeometry geometry, uint mesh, const ProbePoint *point,
                         float3 weight) {
  TynTriangleRecord record = geometry.triangles[point->hit.triangle];
  float2 uv = surface_uv(geometry, record, point->hit.u, point->hit.v);
  tyn_store3_global(exit->position, point->position);
  tyn_store3_global(exit->direction, point->normal);
  tyn_store3_global(exit->weight, weight);
  tyn_store3_global(exit->geometric_normal, point->normal);
  tyn_store3_global(exit->shading_normal,
                    surface_shading_normal(geometry, record, point->hit.u, point->hit.v, point->normal));
  exit->status = TYN_WALK_ESCAPED;
  exit->triangle = point->hit.triangle - geometry.meshes[mesh].first_triangle;
  exit->scatterings = 1u; // or the light would keep its direction
  exit->reserved = 0u;
  exit->path_length = point->distance;
  exit->u = point->hit.u;
  exit->v = point->hit.v;
  exit->uv[0] = uv.x;
  exit->uv[1] = uv.y;
}

kernel void bssrdf_walks(global const TynProfileFamily *families, global const float *nodes,
                         global const TynProfileRecord *records, global const float *terms,
                         global const TynBvhNode *bvh, global const TynTriangleBlock *blocks,
                         global const TynTriangleRecord *triangles, global const float *positions,
                         global const float *normals, global const float *uvs, global const TynMeshRecord *meshes,
                         global const TynMediumRecord *media, global const TynWalkEntry *entries,
                         global TynWalkExit *exits, global TynWalkTally *tallies, uint seed_low, uint seed_high,
                         uint count) {
  size_t i = get_global_id(0);
  if (i >= count)
    return;
  const Families all = {families, nodes, records, terms};
  const SceneGeometry geometry = {triangles, positions, normals, uvs, meshes};
  global const TynWalkEntry *entry = entries + i;
  float3 entered = tyn_load3_global(entry->weight), position = tyn_load3_global(entry->position);
  float3 nothing = tyn_vec3(0.0f, 0.0f, 0.0f), one = tyn_vec3(1.0f, 1.0f, 1.0f);
  if (entry->triangle == TYN_NONE) { // it has not come through the surface
    bssrdf_tally(tallies + i, entered, one, entered);
    bssrdf_end(exits + i, TYN_WALK_LEAKED, position, entered);
    return;
  }

  TynTriangleRecord record = triangles[meshes[entry->mesh].first_triangle + entry->triangle];
  float3 normal = surface_geometric_normal(surface_corners(geometry, record));
  float cosine = cosine_outside(tyn_load3_global(entry->direction), normal, media[entry->medium].ior);
  Colours colours = colours_of(&all, entry, media + entry->medium, entry->medium, cosine);
  bssrdf_tally(tallies + i, entered, colours.albedo, nothing);
  bssrdf_end(exits + i, TYN_WALK_ABSORBED, position, nothing);
  if (!(colours.reach > 0.0f))
    return; // nothing comes back
  const ProbeModel model = {&all, &colours};
  Probe probe;
  probe.model = &model;
  probe.nodes = bvh;
  probe.blocks = blocks;
  probe.root = meshes[entry->mesh].root;
  probe.position = position;
  probe.frame = tyn_frame(normal);
  probe.reach = colours.reach;
  probe.path = tyn_uint2(entry->path[0], entry->path[1]);
  probe.key = tyn_uint2(seed_low, seed_high);

  float radius = colours_draw(&all, &colours, probe_random(&probe, PROBE_DRAW_RADIUS));
  ProbePoint point = probe_find(&probe, radius);
  if (!(point.pdf > 0.0f))
    return;
  float3 weight = colours_value(&all, &colours, point.distance) * (1.0f / point.pdf);
  if (!isfinite(weight.x + weight.y + weight.z)) {
    bssrdf_tally(tallies + i, entered, one, entered);
    bssrdf_end(exits + i, TYN_WALK_LOST, position, entered);
    return;
  }
  bssrdf_tally(tallies + i, entered, colours.albedo, weight);
  bssrdf_leave(exits + i, geometry, entry->mesh, &point, weight);
}
