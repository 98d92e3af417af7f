// SPDX-License-Identifier: Apache-2.0
// Random walks inside meshes. A work-item walks TYN_LANES entries at once; a lane whose walk ends takes the next entry of the
// work-item's slice, and after a slice the next one that no work-item has. Flights, weights and scattering run over all lanes together; rays and boundaries run lane by lane.
//
// Colour. One flight serves all three channels: a channel is chosen in proportion to its throughput w, the flight is drawn
// with that channel's sigma_t, and every channel is weighted by the balance heuristic over the choice,
//   w_c <- w_c f_c sum(w) / sum_k(w_k f_k),  f = sigma_t exp(-sigma_t t) in the medium, exp(-sigma_t t) at the boundary.
// The sum of the weights is unchanged by this and shrinks by absorption, so no weight exceeds the number of channels.
//
// Boundaries. Only crossings from inside to outside count, from a little behind the ray's origin (the mesh's slack): so a
// walk that rounding has put a few ulps outside leaves at once, one that starts on the surface does not meet it again, and
// closed meshes lose nothing.
#include "lanes.clh"
#include "lane_math.clh"
#include "distance_bound.clh"
#include "interface.clh"
#include "phase.clh"
#include "random.clh"
#include "shared.h"
#include "surface_point.clh"
#include "traverse.clh"

// Reflections at the boundary without a scattering event after which a walk counts as trapped for good (status capped).
#define WALK_TRAPPED 65536u
#define WALK_TRAPPED_CLEAR 4096u // in a medium without extinction

// Balls along a flight, beside the one around its start, after which its ray is traced.
#define WALK_BALLS 1

#define WALK_RUNNING -1

typedef struct {
  global const TynBvhNode *nodes;
  global const TynTriangleBlock *blocks;
  SceneGeometry geometry;
  global const TynMediumRecord *media;
  global const TynPhaseRecord *phases;
  global const float *phase_tables;
  global const TynWalkEntry *entries;
  global TynWalkExit *exits;
  global TynWalkTally *tallies;
  global const uchar *distances; // see distance_bound.clh
  global const uint *turned; // a bit a triangle: its second and third vertex are in the other order than the caller's
} WalkBuffers;

// The state of TYN_LANES walks.
typedef struct {
  LaneInts active; // mask: the lane holds a walk
  LaneInts status; // WALK_RUNNING, or the TYN_WALK_* with which the walk has ended and waits to be written
  LaneUints index; // of the entry
  LaneUints path[2];
  LaneUints draw; // random number blocks used so far
  LaneFloats position[3];
  LaneFloats direction[3];
  LaneFloats weight[3];
  LaneFloats sigma_t[3];
  LaneFloats albedo[3];
  LaneFloats g;
  LaneInts coloured;    // mask: sigma_t differs between the channels
  LaneInts other_phase; // mask: the phase function is not Henyey-Greenstein's
  LaneFloats length;
  LaneFloats absorbed[3];
  LaneFloats balance[3];
  LaneUints scatterings;
  LaneUints rays;
  LaneUints reflections; // since the last scattering
  LaneUints triangle;    // last one crossed, scene-wide
  DistanceGrids grids;
  // used lane by lane
  float reflected[TYN_LANES]; // fraction of the entering weight
  uint mesh[TYN_LANES];
  uint phase[TYN_LANES]; // TynMediumRecord::phase
  float u[TYN_LANES], v[TYN_LANES];
  float ior[TYN_LANES];
  float alpha[TYN_LANES];
} Walks;

static float3 walk_vector(const LaneFloats *v, int lane) {
  return tyn_vec3(v[0].lane[lane], v[1].lane[lane], v[2].lane[lane]);
}

static void walk_set_vector(LaneFloats *v, int lane, float3 value) {
  v[0].lane[lane] = value.x;
  v[1].lane[lane] = value.y;
  v[2].lane[lane] = value.z;
}

// Geometric normal where a walk goes out along `direction`. A triangle without area, which closes the gap that rounding opens
// beside an edge, has none of its own.
static float3 walk_outward_normal(WalkBuffers buffers, TynTriangleRecord triangle, float3 direction) {
  float3 ng = surface_geometric_normal(buffers.geometry, triangle);
  return tyn_dot(ng, ng) > 0.5f ? ng : direction;
}

// Writes the exit and tally of a walk that has ended, and frees its lane.
static void walk_write(WalkBuffers buffers, Walks *walks, int lane, uint callers_winding) {
  uint status = (uint)walks->status.lane[lane];
  uint index = walks->index.lane[lane];
  global const TynWalkEntry *entry = buffers.entries + index;
  global TynWalkExit *exit = buffers.exits + index;
  global TynWalkTally *tally = buffers.tallies + index;
  float3 position = walk_vector(walks->position, lane);
  float3 direction = walk_vector(walks->direction, lane);
  float3 weight = walk_vector(walks->weight, lane);
  float sum = weight.x + weight.y + weight.z + position.x + position.y + position.z;
  if (!isfinite(sum)) {
    status = TYN_WALK_LOST;
    weight = tyn_vec3(1.0f, 1.0f, 1.0f) * (1.0f - walks->reflected[lane]) - walk_vector(walks->absorbed, lane) -
             walk_vector(walks->balance, lane);
    if (!isfinite(weight.x + weight.y + weight.z)) {
      weight = tyn_vec3(1.0f, 1.0f, 1.0f) * (1.0f - walks->reflected[lane]);
      walk_set_vector(walks->absorbed, lane, tyn_vec3(0.0f, 0.0f, 0.0f));
      walk_set_vector(walks->balance, lane, tyn_vec3(0.0f, 0.0f, 0.0f));
    }
  }
  float3 entered = tyn_load3_global(entry->weight);
  tyn_store3_global(exit->position, position);
  tyn_store3_global(exit->direction, direction);
  tyn_store3_global(exit->weight, weight * entered);
  tyn_store3_global(tally->reflected, entered * walks->reflected[lane]);
  tyn_store3_global(tally->absorbed, entered * walk_vector(walks->absorbed, lane));
  tyn_store3_global(tally->balance, entered * walk_vector(walks->balance, lane));
  tally->rays = walks->rays.lane[lane];
  exit->status = status;
  exit->scatterings = walks->scatterings.lane[lane];
  exit->path_length = walks->length.lane[lane];
  exit->u = walks->u[lane];
  exit->v = walks->v[lane];
  exit->reserved = 0u;
  uint triangle = walks->triangle.lane[lane];
  float3 ng = tyn_vec3(0.0f, 0.0f, 0.0f);
  float3 ns = ng;
  float2 uv = (float2)(0.0f, 0.0f);
  if (triangle != TYN_NONE) {
    TynTriangleRecord record = buffers.geometry.triangles[triangle];
    ng = walk_outward_normal(buffers, record, direction);
    ns = surface_shading_normal(buffers.geometry, record, walks->u[lane], walks->v[lane], ng);
    uv = surface_uv(buffers.geometry, record, walks->u[lane], walks->v[lane]);
    if (callers_winding && (buffers.turned[triangle / 32u] >> (triangle % 32u) & 1u)) {
      exit->u = walks->v[lane];
      exit->v = walks->u[lane];
    }
    triangle -= buffers.geometry.meshes[record.mesh].first_triangle;
  }
  tyn_store3_global(exit->geometric_normal, ng);
  tyn_store3_global(exit->shading_normal, ns);
  exit->uv[0] = uv.x;
  exit->uv[1] = uv.y;
  exit->triangle = triangle;
  walks->active.lane[lane] = 0;
}

// Sends light through the boundary into the mesh (kind REFRACT). Returns whether anything went in.
static int walk_refract_in(Walks *walks, int lane, float3 ng, uint2 key) {
  float3 direction = walk_vector(walks->direction, lane);
  float eta = walks->ior[lane];
  if (eta == 1.0f)
    return tyn_dot(direction, ng) < 0.0f;
  TynFrame frame = tyn_frame(ng);
  float3 d = tyn_to_local(frame, direction);
  if (d.z >= 0.0f)
    return 0;
  if (walks->alpha[lane] < TYN_SMOOTH_ALPHA) {
    float fresnel = tyn_fresnel(-d.z, eta);
    walks->reflected[lane] = fresnel;
    float through = 1.0f - fresnel;
    walk_set_vector(walks->weight, lane, tyn_vec3(through, through, through));
    walk_set_vector(walks->direction, lane, tyn_to_world(frame, tyn_refract(d, tyn_vec3(0.0f, 0.0f, 1.0f), eta)));
    return through > 0.0f;
  }
  uint4 counter = tyn_uint4(walks->path[0].lane[lane], walks->path[1].lane[lane], 0xffffffffu, 0u);
  InterfaceSample sample = tyn_interface_sample(d, eta, walks->alpha[lane], counter, key);
  walk_set_vector(walks->direction, lane, tyn_to_world(frame, sample.direction));
  return sample.transmitted;
}

// Moves a point on the boundary a little inside: rounding may have put it outside, where a grazing ray beside an edge would
// miss the mesh. The slack is 16 ulps of the largest coordinate; a quarter covers the rounding of an interpolated point.
static void walk_move_inside(WalkBuffers buffers, Walks *walks, int lane, float3 ng) {
  float step = 0.25f * buffers.geometry.meshes[walks->mesh[lane]].slack;
  walk_set_vector(walks->position, lane, walk_vector(walks->position, lane) - ng * step);
}

// Starts the walk of entry `index` in a lane. A walk that ends at once (bad index, all reflected) leaves the lane inactive.
static void walk_begin(WalkBuffers buffers, TynWalkParameters parameters, Walks *walks, int lane, uint index) {
  global const TynWalkEntry *entry = buffers.entries + index;
  uint2 key = tyn_uint2(parameters.seed[0], parameters.seed[1]);
  ulong path = ((ulong)parameters.first_path[1] << 32 | parameters.first_path[0]) +
               ((ulong)entry->path[1] << 32 | entry->path[0]) + (entry->reserved == 1u ? 0u : index);
  walks->active.lane[lane] = -1;
  walks->status.lane[lane] = WALK_RUNNING;
  walks->index.lane[lane] = index;
  walks->path[0].lane[lane] = (uint)path;
  walks->path[1].lane[lane] = (uint)(path >> 32);
  walks->draw.lane[lane] = 0u;
  walks->length.lane[lane] = 0.0f;
  walks->scatterings.lane[lane] = 0u;
  walks->rays.lane[lane] = 0u;
  walks->reflected[lane] = 0.0f;
  walks->triangle.lane[lane] = TYN_NONE;
  walks->u[lane] = walks->v[lane] = 0.0f;
  walks->reflections.lane[lane] = 0u;
  walks->alpha[lane] = entry->roughness;
  walk_set_vector(walks->position, lane, tyn_load3_global(entry->position));
  walk_set_vector(walks->direction, lane, tyn_load3_global(entry->direction));
  walk_set_vector(walks->weight, lane, tyn_vec3(1.0f, 1.0f, 1.0f));
  walk_set_vector(walks->absorbed, lane, tyn_vec3(0.0f, 0.0f, 0.0f));
  walk_set_vector(walks->balance, lane, tyn_vec3(0.0f, 0.0f, 0.0f));

  uint mesh = entry->mesh;
  uint medium_index =
      mesh < parameters.mesh_count && entry->medium == TYN_NONE ? buffers.geometry.meshes[mesh].medium : entry->medium;
  uint local_triangle = entry->triangle;
  if (mesh >= parameters.mesh_count || medium_index >= parameters.medium_count ||
      (local_triangle == TYN_NONE ? entry->kind != TYN_ENTRY_INSIDE
                                  : local_triangle >= buffers.geometry.meshes[mesh].triangle_count)) {
    walks->status.lane[lane] = TYN_WALK_LOST;
    return;
  }
  global const TynMediumRecord *medium = buffers.media + medium_index;
  walks->mesh[lane] = mesh;
  distance_grids_set(&walks->grids, lane, buffers.geometry.meshes + mesh);
  walks->ior[lane] = medium->ior;
  walks->g.lane[lane] = medium->g;
  walks->phase[lane] = medium->phase;
  walks->other_phase.lane[lane] = medium->phase == TYN_NONE ? 0 : -1;
  walk_set_vector(walks->sigma_t, lane,
                  entry->sigma_t[0] >= 0.0f ? tyn_load3_global(entry->sigma_t) : tyn_load3_global(medium->sigma_t));
  walk_set_vector(walks->albedo, lane,
                  entry->albedo[0] >= 0.0f ? tyn_load3_global(entry->albedo) : tyn_load3_global(medium->albedo));
  float3 sigma_t = walk_vector(walks->sigma_t, lane);
  walks->coloured.lane[lane] = sigma_t.x == sigma_t.y && sigma_t.y == sigma_t.z ? 0 : -1;
  if (local_triangle == TYN_NONE)
    return;

  uint triangle = buffers.geometry.meshes[mesh].first_triangle + local_triangle;
  float3 ng = surface_geometric_normal(buffers.geometry, buffers.geometry.triangles[triangle]);
  walk_move_inside(buffers, walks, lane, ng);
  if (entry->kind == TYN_ENTRY_COSINE) {
    uint4 random = tyn_philox(tyn_uint4((uint)path, (uint)(path >> 32), 0u, TYN_DOMAIN_ENTRY), key);
    float3 d = tyn_sample_cosine(tyn_uniform(random.x), tyn_uniform(random.y));
    walk_set_vector(walks->direction, lane, tyn_to_world(tyn_frame(-ng), d));
  } else if (entry->kind == TYN_ENTRY_REFRACT && !walk_refract_in(walks, lane, ng, key)) {
    walks->reflected[lane] = 1.0f;
    walk_set_vector(walks->weight, lane, tyn_vec3(0.0f, 0.0f, 0.0f));
    walks->status.lane[lane] = TYN_WALK_REFLECTED;
  }
}

// A walk arrives at the boundary from inside: it leaves, or is reflected back.
static void walk_boundary(WalkBuffers buffers, Walks *walks, int lane, uint2 key, uint random) {
  uint triangle = walks->triangle.lane[lane];
  TynTriangleRecord record = buffers.geometry.triangles[triangle];
  walk_set_vector(walks->position, lane, surface_position(buffers.geometry, record, walks->u[lane], walks->v[lane]));
  float ior = walks->ior[lane];
  if (ior == 1.0f) {
    walks->status.lane[lane] = TYN_WALK_ESCAPED;
    return;
  }
  float3 direction = walk_vector(walks->direction, lane);
  float3 ng = walk_outward_normal(buffers, record, direction);
  TynFrame frame = tyn_frame(-ng);
  float3 d = tyn_to_local(frame, direction);
  d.z = fmin(d.z, -1e-7f);
  InterfaceSample sample;
  if (walks->alpha[lane] < TYN_SMOOTH_ALPHA) {
    float eta = 1.0f / ior;
    sample.transmitted = tyn_uniform(random) >= tyn_fresnel(-d.z, eta);
    sample.direction = sample.transmitted ? tyn_refract(d, tyn_vec3(0.0f, 0.0f, 1.0f), eta) : tyn_vec3(d.x, d.y, -d.z);
  } else {
    uint4 counter = tyn_uint4(walks->path[0].lane[lane], walks->path[1].lane[lane], walks->draw.lane[lane], 0u);
    sample = tyn_interface_sample(d, 1.0f / ior, walks->alpha[lane], counter, key);
  }
  walk_set_vector(walks->direction, lane, tyn_normalize(tyn_to_world(frame, sample.direction)));
  if (sample.transmitted) {
    walks->status.lane[lane] = TYN_WALK_ESCAPED;
    return;
  }
  walk_move_inside(buffers, walks, lane, ng);
  float sigma = walks->sigma_t[0].lane[lane] + walks->sigma_t[1].lane[lane] + walks->sigma_t[2].lane[lane];
  uint limit = sigma > 0.0f ? WALK_TRAPPED : WALK_TRAPPED_CLEAR;
  if (++walks->reflections.lane[lane] > limit)
    walks->status.lane[lane] = TYN_WALK_CAPPED;
}

// Distance along a ray from inside the bounds of a mesh to where it leaves them.
static float walk_distance_to_bounds(global const TynMeshRecord *mesh, float3 origin, float3 direction) {
  float3 inverse = tyn_vec3(trace_inverse(direction.x), trace_inverse(direction.y), trace_inverse(direction.z));
  float x = ((inverse.x > 0.0f ? mesh->upper[0] : mesh->lower[0]) - origin.x) * inverse.x;
  float y = ((inverse.y > 0.0f ? mesh->upper[1] : mesh->lower[1]) - origin.y) * inverse.y;
  float z = ((inverse.z > 0.0f ? mesh->upper[2] : mesh->lower[2]) - origin.z) * inverse.z;
  return fmax(0.0f, fmin(x, fmin(y, z)));
}

// The parts of every lane's flight that cannot meet the surface, at its start and at its end.
typedef struct {
  LaneFloats start, end;
} WalkClear;

// Looks for the boundary along a lane's flight. Where it is met first, `at_surface` is set and `flight` shortened to it. A walk
// that goes out through a hole ends here.
static void walk_trace_lane(WalkBuffers buffers, Walks *walks, int lane, const WalkClear *clear, LaneFloats *flight,
                            LaneInts *at_surface) {
  global const TynMeshRecord *mesh = buffers.geometry.meshes + walks->mesh[lane];
  float3 origin = walk_vector(walks->position, lane);
  float3 direction = walk_vector(walks->direction, lane);
  float from = clear->start.lane[lane] > 0.0f ? clear->start.lane[lane] : -mesh->slack;
  TraceHit hit = tyn_trace(buffers.nodes, buffers.blocks, mesh->root, origin, direction, from,
                           flight->lane[lane] - clear->end.lane[lane], TYN_LEAVING);
  if (hit.triangle != TYN_NONE) {
    at_surface->lane[lane] = -1;
    flight->lane[lane] = fmax(hit.t, 0.0f);
    walks->triangle.lane[lane] = hit.triangle;
    walks->u[lane] = hit.u;
    walks->v[lane] = hit.v;
    return;
  }
  // never farther than where it leaves the bounds of the mesh, through which it can only get by a hole
  float leaves = walk_distance_to_bounds(mesh, origin, direction);
  if (flight->lane[lane] <= leaves)
    return;
  flight->lane[lane] = leaves;
  at_surface->lane[lane] = -1;
  walks->triangle.lane[lane] = TYN_NONE;
  walk_set_vector(walks->position, lane, origin + direction * leaves);
  walks->status.lane[lane] = TYN_WALK_LEAKED;
}

// What is clear by the distance bound: balls without surface, the first one around the flight's start, each of the next where
// the flight leaves the last one (Hart 1996, "Sphere Tracing"), and one around its end. Returns the mask of flights that may
// meet the surface.
static LaneInt walk_find_clear(WalkBuffers buffers, const Walks *walks, LaneFloat flight, WalkClear *clear) {
  LaneFloat at[3] = {walks->position[0].all, walks->position[1].all, walks->position[2].all};
  clear->start.all = distance_bound(&walks->grids, buffers.distances, at);
  clear->end.all = (LaneFloat)(0.0f);
  LaneInt near = walks->active.all & ~lane_lt(flight, clear->start.all);
  if (!lane_any(near))
    return near;
  for (int k = 0; k < 3; ++k)
    at[k] = walks->position[k].all + walks->direction[k].all * flight;
  clear->end.all = distance_bound(&walks->grids, buffers.distances, at);
  for (int ball = 0; ball < WALK_BALLS; ++ball) {
    near &= ~lane_lt(flight, clear->start.all + clear->end.all);
    if (!lane_any(near))
      break;
    for (int k = 0; k < 3; ++k)
      at[k] = walks->position[k].all + walks->direction[k].all * clear->start.all;
    clear->start.all += distance_bound(&walks->grids, buffers.distances, at);
  }
  return near & ~lane_lt(flight, clear->start.all + clear->end.all);
}

// Traces the flights that may meet the surface, each by itself, and only the parts where they may.
static void walk_trace(WalkBuffers buffers, Walks *walks, LaneFloats *flight, LaneInts *at_surface) {
  WalkClear clear;
  LaneInt near = walk_find_clear(buffers, walks, flight->all, &clear);
  at_surface->all = (LaneInt)(0);
  flight->all = lane_choose(walks->active.all, flight->all, (LaneFloat)(0.0f));
  walks->rays.all -= lane_as_uint(near);
  for (uint bits = lane_bits(near); bits; bits &= bits - 1u)
    walk_trace_lane(buffers, walks, lane_lowest(bits), &clear, flight, at_surface);
}

// Draws every lane's flight length with a channel chosen in proportion to its throughput.
static LaneFloat walk_sample_flight(const Walks *walks, const LaneUint random[4]) {
  LaneFloat sum = walks->weight[0].all + walks->weight[1].all + walks->weight[2].all;
  LaneFloat pick = lane_uniform(random[0]) * sum;
  LaneInt second =
      lane_lt(pick, walks->weight[0].all + walks->weight[1].all) | lane_le(walks->weight[2].all, (LaneFloat)(0.0f));
  LaneFloat sigma = lane_choose(second, walks->sigma_t[1].all, walks->sigma_t[2].all);
  sigma = lane_choose(lane_lt(pick, walks->weight[0].all), walks->sigma_t[0].all, sigma);
  LaneFloat flight = -lane_log(lane_uniform_fine(random[1])) / sigma;
  return lane_choose(lane_lt((LaneFloat)(0.0f), sigma), flight, (LaneFloat)(INFINITY));
}

// Weights the channels for a flight of length t that ended in the medium or at the surface.
static void walk_weight_flight(Walks *walks, LaneFloat t, LaneInt at_surface) {
  LaneInt coloured = walks->coloured.all & walks->active.all;
  if (!lane_any(coloured))
    return; // all factors are 1
  LaneFloat least = fmin(walks->sigma_t[0].all, fmin(walks->sigma_t[1].all, walks->sigma_t[2].all));
  LaneFloat f[3], sum = (LaneFloat)(0.0f), mean = (LaneFloat)(0.0f);
  for (int c = 0; c < 3; ++c) {
    // relative to the channel with the least extinction, which cancels
    f[c] = lane_exp((least - walks->sigma_t[c].all) * t);
    f[c] = lane_choose(at_surface, f[c], f[c] * walks->sigma_t[c].all);
    sum += walks->weight[c].all;
    mean += walks->weight[c].all * f[c];
  }
  LaneFloat scale = sum / mean;
  for (int c = 0; c < 3; ++c) {
    LaneFloat weight = lane_choose(coloured, walks->weight[c].all * f[c] * scale, walks->weight[c].all);
    // weights stay clear of the denormal numbers, which are slow and would see the scale of the scene
    weight = lane_choose(lane_lt(weight, (LaneFloat)(1e-30f)), (LaneFloat)(0.0f), weight);
    walks->balance[c].all += walks->weight[c].all - weight;
    walks->weight[c].all = weight;
  }
}

// Draws 1 - cos of the deflection of the lanes in `mask`: by Henyey and Greenstein's function for all lanes at once, then again
// with numbers of their own, lane by lane, for those that have another one.
static LaneFloat walk_sample_away(WalkBuffers buffers, const Walks *walks, LaneInt mask, const LaneUint random[4],
                                  uint2 key) {
  LaneFloats away;
  away.all = lane_hg_one_minus_cos(lane_uniform(random[2]), walks->g.all);
  LaneInts other;
  other.all = mask & walks->other_phase.all;
  if (!lane_any(other.all))
    return away.all;
  for (int lane = 0; lane < TYN_LANES; ++lane) {
    if (!other.lane[lane])
      continue;
    uint4 counter =
        tyn_uint4(walks->path[0].lane[lane], walks->path[1].lane[lane], walks->draw.lane[lane], TYN_DOMAIN_PHASE);
    away.lane[lane] =
        tyn_phase_sample_away(buffers.phases[walks->phase[lane]], buffers.phase_tables, tyn_philox(counter, key));
  }
  return away.all;
}

// Turns the direction of the lanes in `mask` by 1 - cos = `away` and a random azimuth.
static void walk_turn(Walks *walks, LaneInt mask, LaneFloat away, const LaneUint random[4]) {
  LaneFloat cos_theta = 1.0f - away;
  LaneFloat sin_theta = sqrt(lane_max(away * (2.0f - away), (LaneFloat)(0.0f)));
  LaneFloat sine, cosine;
  lane_sincos_turn(lane_uniform(random[3]), &sine, &cosine);
  LaneFloat x = walks->direction[0].all, y = walks->direction[1].all, z = walks->direction[2].all;
  LaneFloat new_x = x, new_y = y, new_z = z;
  lane_rotate(&new_x, &new_y, &new_z, cos_theta, sin_theta * cosine, sin_theta * sine);
  walks->direction[0].all = lane_choose(mask, new_x, x);
  walks->direction[1].all = lane_choose(mask, new_y, y);
  walks->direction[2].all = lane_choose(mask, new_z, z);
}

// Scatters the lanes in `mask`: absorbs, turns, counts.
static void walk_scatter(WalkBuffers buffers, Walks *walks, LaneInt mask, LaneFloat t, const LaneUint random[4],
                         uint2 key) {
  for (int c = 0; c < 3; ++c) {
    walks->position[c].all += lane_choose(mask, walks->direction[c].all * t, (LaneFloat)(0.0f));
    LaneFloat kept = walks->weight[c].all * walks->albedo[c].all;
    walks->absorbed[c].all += lane_choose(mask, walks->weight[c].all - kept, (LaneFloat)(0.0f));
    walks->weight[c].all = lane_choose(mask, kept, walks->weight[c].all);
  }
  walks->scatterings.all -= lane_as_uint(mask);
  walk_turn(walks, mask, walk_sample_away(buffers, walks, mask, random, key), random);
}

// Russian roulette on the largest channel: a walk below the threshold survives with probability largest / threshold.
// Returns the mask of those that died, whose weight is then in the balance.
static LaneInt walk_roulette(Walks *walks, LaneInt mask, float threshold, const LaneUint random[4]) {
  LaneFloat largest = fmax(walks->weight[0].all, fmax(walks->weight[1].all, walks->weight[2].all));
  LaneInt dead = mask & lane_le(largest, (LaneFloat)(0.0f));
  LaneInt plays = mask & lane_lt(largest, (LaneFloat)(threshold)) & ~dead;
  if (!lane_any(plays))
    return dead;
  // the low bytes, which the uniform numbers above leave unused; that of the flight moves its length only where u < 2^-16
  LaneUint bits = (random[0] & 255u) << 24 | (random[1] & 255u) << 16 | (random[2] & 255u) << 8 | (random[3] & 255u);
  LaneInt survives = lane_lt(lane_uniform(bits) * threshold, largest);
  LaneFloat boost = threshold / largest;
  for (int c = 0; c < 3; ++c) {
    LaneFloat weight = lane_choose(survives, walks->weight[c].all * boost, (LaneFloat)(0.0f));
    weight = lane_choose(plays, weight, walks->weight[c].all);
    walks->balance[c].all += walks->weight[c].all - weight;
    walks->weight[c].all = weight;
  }
  return dead | (plays & ~survives);
}

// The entries that are left to a work-item.
typedef struct {
  uint next, end;            // of its slice
  global uint *slices_taken; // beyond the first ones, by all work-items
  int open;
} WalkQueue;

static void walk_take_slice(WalkQueue *queue, TynWalkParameters parameters, uint slice) {
  ulong begin = min((ulong)slice * parameters.slice, (ulong)parameters.count);
  queue->next = (uint)begin;
  queue->end = (uint)min(begin + parameters.slice, (ulong)parameters.count);
  queue->open = queue->next < queue->end;
}

// Whether there was an entry to take.
static int walk_take(WalkQueue *queue, TynWalkParameters parameters, uint *index) {
  if (queue->open && queue->next == queue->end)
    walk_take_slice(queue, parameters, (uint)get_global_size(0) + atomic_inc(queue->slices_taken));
  if (!queue->open)
    return 0;
  *index = queue->next++;
  return 1;
}

kernel void walk_paths(global const TynBvhNode *nodes, global const TynTriangleBlock *blocks,
                       global const TynTriangleRecord *triangles, global const float *positions,
                       global const float *normals, global const float *uvs, global const TynMeshRecord *meshes,
                       global const TynMediumRecord *media, global const TynPhaseRecord *phases,
                       global const float *phase_tables, global const TynWalkEntry *entries, global TynWalkExit *exits,
                       global TynWalkTally *tallies, global const uint *turned, global const uchar *distances,
                       global uint *slices_taken, TynWalkParameters parameters) {
  WalkBuffers buffers;
  buffers.nodes = nodes;
  buffers.blocks = blocks;
  buffers.geometry.triangles = triangles;
  buffers.geometry.positions = positions;
  buffers.geometry.normals = normals;
  buffers.geometry.uvs = uvs;
  buffers.geometry.meshes = meshes;
  buffers.media = media;
  buffers.phases = phases;
  buffers.phase_tables = phase_tables;
  buffers.entries = entries;
  buffers.exits = exits;
  buffers.tallies = tallies;
  buffers.turned = turned;
  buffers.distances = distances;
  uint2 key = tyn_uint2(parameters.seed[0], parameters.seed[1]);

  WalkQueue queue;
  queue.slices_taken = slices_taken;
  walk_take_slice(&queue, parameters, (uint)get_global_id(0));
  if (!queue.open)
    return;

  Walks walks;
  walks.active.all = (LaneInt)(0);
  walks.status.all = (LaneInt)(WALK_RUNNING);
  walks.other_phase.all = walks.coloured.all = (LaneInt)(0);
  // idle lanes compute with harmless numbers
  walks.draw.all = walks.path[0].all = walks.path[1].all = walks.index.all = walks.scatterings.all = walks.rays.all =
      (LaneUint)(0u);
  distance_grids_clear(&walks.grids);
  walks.reflections.all = (LaneUint)(0u);
  walks.triangle.all = (LaneUint)(TYN_NONE);
  walks.g.all = walks.length.all = (LaneFloat)(0.0f);
  for (int c = 0; c < 3; ++c) {
    walks.position[c].all = walks.absorbed[c].all = walks.balance[c].all = (LaneFloat)(0.0f);
    walks.direction[c].all = (LaneFloat)(c == 2 ? 1.0f : 0.0f);
    walks.weight[c].all = walks.sigma_t[c].all = walks.albedo[c].all = (LaneFloat)(1.0f);
  }

  for (;;) {
    LaneInt ended = walks.active.all & ~lane_eq(walks.status.all, (LaneInt)(WALK_RUNNING));
    for (uint bits = lane_bits(queue.open ? ended | ~walks.active.all : ended); bits; bits &= bits - 1u) {
      int lane = lane_lowest(bits);
      for (;;) { // more than once if a walk ends as it begins
        if (walks.active.lane[lane] && walks.status.lane[lane] != WALK_RUNNING)
          walk_write(buffers, &walks, lane, parameters.callers_winding);
        uint index;
        if (walks.active.lane[lane] || !walk_take(&queue, parameters, &index))
          break;
        walk_begin(buffers, parameters, &walks, lane, index);
      }
    }
    if (!lane_any(walks.active.all))
      break;

    LaneUint random[4] = {walks.path[0].all, walks.path[1].all, walks.draw.all, (LaneUint)(TYN_DOMAIN_WALK)};
    lane_philox(random, key.x, key.y);
    walks.draw.all += 1u;

    LaneFloats flight;
    LaneInts at_surface;
    flight.all = walk_sample_flight(&walks, random);
    walk_trace(buffers, &walks, &flight, &at_surface);
    walks.length.all += flight.all;
    walk_weight_flight(&walks, flight.all, at_surface.all);

    LaneInt scatters = walks.active.all & ~at_surface.all & lane_lt(walks.status.all, (LaneInt)(0));
    if (lane_any(scatters)) {
      walk_scatter(buffers, &walks, scatters, flight.all, random, key);
      LaneInt dead = walk_roulette(&walks, scatters, parameters.roulette_threshold, random);
      LaneInt capped = (LaneInt)(0);
      if (parameters.max_scatterings)
        capped =
            scatters & ~dead &
            lane_as_int(-(lane_as_uint(lane_le((LaneUint)(parameters.max_scatterings), walks.scatterings.all)) & 1u));
      walks.reflections.all = lane_choose(scatters, (LaneUint)(0u), walks.reflections.all);
      walks.triangle.all = lane_choose(dead | capped, (LaneUint)(TYN_NONE), walks.triangle.all);
      walks.status.all = lane_choose(dead, (LaneInt)(TYN_WALK_ABSORBED), walks.status.all);
      walks.status.all = lane_choose(capped, (LaneInt)(TYN_WALK_CAPPED), walks.status.all);
    }
    LaneUints boundary_random;
    boundary_random.all = random[2];
    LaneInt arrived = at_surface.all & lane_eq(walks.status.all, (LaneInt)(WALK_RUNNING));
    for (uint bits = lane_bits(arrived); bits; bits &= bits - 1u) {
      int lane = lane_lowest(bits);
      walk_boundary(buffers, &walks, lane, key, boundary_random.lane[lane]);
    }
  }
}
