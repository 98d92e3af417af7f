// SPDX-License-Identifier: Apache-2.0
// Random walks inside meshes. A work-item walks TYN_LANES entries at once; a lane whose walk ends takes the next entry of the
// work-item's slice, and after a slice the next one that no work-item has. Entering, flights, weights and scattering run over
// all lanes together; rays run several at a time, boundaries lane by lane. Most flights need no ray: see walk_flight.clh.
// None of this changes what a walk does: it is the same to the last bit as if every flight were traced, by itself.
//
// Colour. One flight serves all three channels: a channel is chosen in proportion to its throughput w, the flight is drawn
// with that channel's sigma_t, and every channel is weighted by the balance heuristic over the choice,
//   w_c <- w_c f_c sum(w) / sum_k(w_k f_k),  f = sigma_t exp(-sigma_t t) in the medium, exp(-sigma_t t) at the boundary.
// The sum of the weights is unchanged by this and shrinks by absorption, so no weight exceeds the number of channels.
//
// Boundaries. Only crossings from inside to outside count, from a little behind the ray's origin (the mesh's slack): so a
// walk that rounding has put a few ulps outside leaves at once, one that starts on the surface does not meet it again, and
// closed meshes lose nothing.
#include "walk_ends.clh"
#include "walk_flight.clh"
#include "walk_scatter.clh"
#include "walk_state.clh"

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

// Writes the walks that have ended, and starts others in their place.
static void walk_refill(WalkBuffers buffers, TynWalkParameters parameters, Walks *walks, WalkQueue *queue,
                        WalkEntrance *entrance) {
  for (;;) { // more than once if a walk ends as it begins
    LaneInt ended = walks->active.all & ~lane_eq(walks->status.all, (LaneInt)(WALK_RUNNING));
    uint bits = lane_bits(queue->open ? ended | ~walks->active.all : ended);
    if (bits == 0u)
      return;
    entrance->on_triangle.all = (LaneInt)(0);
    for (; bits; bits &= bits - 1u) {
      int lane = lane_lowest(bits);
      if (walks->active.lane[lane])
        walk_write(buffers, walks, lane, parameters.callers_winding);
      uint index;
      if (walk_take(queue, parameters, &index))
        walk_begin(buffers, parameters, walks, entrance, lane, index);
    }
    if (lane_any(entrance->on_triangle.all))
      walk_enter(walks, entrance, tyn_uint2(parameters.seed[0], parameters.seed[1]));
  }
}

// The flights of the lanes in `moving` have been made.
static void walk_finish_flight(Walks *walks, LaneInt moving, LaneFloat flight) {
  LaneFloat none = (LaneFloat)(0.0f), made = lane_choose(moving, flight, none);
  walks->draw.all -= lane_as_uint(moving);
  walks->length.all += made;
  walks->ball.all -= made;
  walks->looks.all = lane_choose(moving, (LaneInt)(0), walks->looks.all);
  walks->clear_start.all = lane_choose(moving, none, walks->clear_start.all);
  walks->clear_end.all = lane_choose(moving, none, walks->clear_end.all);
}

// Roulette, and the cap on scatterings, for the lanes in `scattered`.
static void walk_end_some(Walks *walks, TynWalkParameters parameters, LaneInt scattered, const LaneUint random[4]) {
  LaneInt dead = walk_roulette(walks, scattered, parameters.roulette_threshold, random);
  LaneInt capped = (LaneInt)(0);
  if (parameters.max_scatterings)
    capped = scattered & ~dead & lane_le((LaneUint)(parameters.max_scatterings), walks->scatterings.all);
  walks->triangle.all = lane_choose(dead | capped, (LaneUint)(TYN_NONE), walks->triangle.all);
  walks->status.all = lane_choose(dead, (LaneInt)(TYN_WALK_ABSORBED), walks->status.all);
  walks->status.all = lane_choose(capped, (LaneInt)(TYN_WALK_CAPPED), walks->status.all);
}

// One flight of every lane that need not wait, and what is at its end.
static void walk_step(WalkBuffers buffers, TynWalkParameters parameters, Walks *walks, uint2 key) {
  LaneUint random[4] = {walks->path[0].all, walks->path[1].all, walks->draw.all, (LaneUint)(TYN_DOMAIN_WALK)};
  lane_philox(random, key.x, key.y);

  LaneFloats flight;
  LaneInts at_surface;
  flight.all = walk_sample_flight(walks, random);
  LaneInt moving = walk_fly(buffers, walks, &flight, &at_surface);
  walk_finish_flight(walks, moving, flight.all);
  walk_weight_flight(walks, flight.all, at_surface.all, moving);

  LaneInt scatters = moving & ~at_surface.all & lane_lt(walks->status.all, (LaneInt)(0));
  if (lane_any(scatters)) {
    walk_scatter(buffers, walks, scatters, flight.all, random, key);
    walk_end_some(walks, parameters, scatters, random);
  }
  LaneUints boundary_random;
  boundary_random.all = random[2];
  LaneInt arrived = at_surface.all & lane_eq(walks->status.all, (LaneInt)(WALK_RUNNING));
  for (uint bits = lane_bits(arrived); bits; bits &= bits - 1u) {
    int lane = lane_lowest(bits);
    walk_boundary(buffers, walks, lane, key, boundary_random.lane[lane]);
  }
}

kernel void walk_paths(global const TynBvhNode *nodes, global const TynTriangleBlock *blocks,
                       global const TynTriangleRecord *triangles, global const float *positions,
                       global const float *normals, global const float *uvs, global const TynMeshRecord *meshes,
                       global const TynMediumRecord *media, global const TynPhaseRecord *phases,
                       global const float *phase_tables, global const TynWalkEntry *entries, global TynWalkExit *exits,
                       global TynWalkTally *tallies, global const uint *turned, global const uint *cells,
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
  buffers.cells = cells;
  uint2 key = tyn_uint2(parameters.seed[0], parameters.seed[1]);

  WalkQueue queue;
  queue.slices_taken = slices_taken;
  walk_take_slice(&queue, parameters, (uint)get_global_id(0));
  if (!queue.open)
    return;

  Walks walks;
  walks_clear(&walks);
  WalkEntrance entrance;
  walk_clear_entrance(&entrance);
  for (;;) {
    walk_refill(buffers, parameters, &walks, &queue, &entrance);
    if (!lane_any(walks.active.all))
      break;
    walk_step(buffers, parameters, &walks, key);
  }
}
