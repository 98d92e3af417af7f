// SPDX-License-Identifier: Apache-2.0
// Random walks in a stack of plane layers. A work-item walks TYN_LANES photons at once; a lane whose walk ends takes the next
// photon of the work-item's slice, and every photon that is started is finished.
//
// A flight is drawn with the layer's sigma_t; if it ends beyond the layer it stops at the interface, where light is reflected or
// transmitted with the Fresnel probabilities, and a new flight is drawn (free flights have no memory). At an event the fraction
// 1 - albedo of the weight is absorbed, and the rest is turned by the phase function.
//
// What is absorbed in a layer is what has come into it less what has gone out. Random numbers are drawn one step ahead, so that
// their long chain of multiplications runs beside the step before: a photon waits one step after its start for its first ones.
//
// Where nothing is resolved sideways only the cosine with the normal is followed: phase functions have no preferred azimuth.
#include "lane_math.clh"
#include "lanes.clh"
#include "phase.clh"
#include "random.clh"
#include "shared_slab.h"
#include "slab_escape.clh"
#include "slab_state.clh"
#include "slab_tally.clh"

// Reflections after which a walk is cut: rounding can make total ones of them.
#define SLAB_TRAPPED 1048576u

// Hands over what a lane has gathered in its layer for the sweep.
static void slab_leave_layer(SlabWalks *walks, int lane) {
  int slot = walks->layer.lane[lane] * TYN_LANES + lane;
  walks->sweep_orders[slot] += (float)(walks->order.lane[lane] - walks->layer_order[lane]);
  walks->sweep_lengths[slot] += walks->length.lane[lane] - walks->layer_length[lane];
  walks->layer_order[lane] = walks->order.lane[lane];
  walks->layer_length[lane] = walks->length.lane[lane];
}

// What the weight of a walk that leaves is in the media of the sweep.
TYN_RARE static void slab_tally_sweep(const SlabRun *run, SlabWalks *walks, int lane, uint below) {
  slab_leave_layer(walks, lane);
  global ulong *tally = run->tally + run->p.sweep + below * run->p.sweep_count;
  for (uint row = 0u; row < run->p.sweep_count; ++row) {
    global const float *medium = run->sweep + 2u * row * run->p.layer_count;
    float exponent = 0.0f;
    for (uint layer = 0u; layer < run->p.layer_count; ++layer) {
      uint slot = layer * TYN_LANES + (uint)lane;
      exponent += walks->sweep_orders[slot] * medium[2u * layer] - walks->sweep_lengths[slot] * medium[2u * layer + 1u];
    }
    slab_add(tally + row, (ulong)(walks->weight.lane[lane] * exp(exponent) * TYN_SLAB_SWEEP_SCALE + 0.5f));
  }
}

// Sorts the walks in the lanes of `mask`, which have left the slab, into the bins asked for. `weight`: in units of the tallies.
static void slab_tally_bins(const SlabRun *run, SlabWalks *walks, LaneInt mask, LaneUint below, LaneUint weight) {
  LaneFloat x = walks->position[0].all, y = walks->position[1].all;
  LaneInt scattered = ~lane_eq(walks->order.all, (LaneUint)(0u));
  LaneFloat angle =
      lane_acos(lane_min(walks->outside, (LaneFloat)(1.0f))) * (2.0f / TYN_PI) * (float)run->p.angular_bins;
  angle = lane_min(angle, (LaneFloat)((float)run->p.angular_bins - 0.5f));
  LaneFloat ring = sqrt(x * x + y * y) * run->p.radial_scale;
  LaneUints amount, tally[5];
  LaneInt any = (LaneInt)(-1);
  amount.all = weight;
  tally[0].all = slab_tally_of(run->p.order, lane_float_from_uint(walks->order.all), run->p.order_bins, below, any);
  tally[1].all = slab_tally_of(run->p.angular, angle, run->p.angular_bins, below, scattered);
  tally[2].all = slab_tally_of(run->p.radial, ring, run->p.radial_bins, below, scattered);
  tally[3].all = slab_tally_of(run->p.path, walks->length.all * run->p.path_scale, run->p.path_bins, below, scattered);
  LaneUint both = tally[2].all - run->p.radial;
  LaneInt inside = ~lane_eq(tally[2].all, (LaneUint)(TYN_SLAB_TALLY_NOTHING));
  if (!run->p.radial_angular)
    inside = (LaneInt)(0);
  both = run->p.radial_angular + both * run->p.angular_bins + lane_uint_from_float(angle);
  tally[4].all = lane_choose(inside, both, (LaneUint)(TYN_SLAB_TALLY_NOTHING));
  uint downwards = lane_bits(lane_as_int(below));
  for (uint bits = lane_bits(mask); bits; bits &= bits - 1u) {
    int lane = lane_lowest(bits);
    for (int i = 0; i < 5; ++i)
      slab_add(run->tally + tally[i].lane[lane], (ulong)amount.lane[lane]);
    if (run->p.sweep_count)
      slab_tally_sweep(run, walks, lane, downwards >> lane & 1u);
  }
}

// Writes down the walks that have left.
static void slab_exit(const SlabRun *run, SlabWalks *walks, SlabSums *sums) {
  LaneUint weight = slab_weights(walks->weight.all);
  LaneUint unscattered = lane_as_uint(lane_eq(walks->order.all, (LaneUint)(0u)));
  LaneUint up = lane_as_uint(walks->left[0]), below = lane_as_uint(walks->left[1]);
  sums->exit[0].all += weight & up & unscattered;
  sums->exit[1].all += weight & up & ~unscattered;
  sums->exit[2].all += weight & below & unscattered;
  sums->exit[3].all += weight & below & ~unscattered;
  LaneInt left = walks->left[0] | walks->left[1];
  if (run->p.flags & TYN_SLAB_BINS && lane_any(left))
    slab_tally_bins(run, walks, left, below, weight);
  if (run->p.flags & TYN_SLAB_ESCAPES && lane_any(walks->left[0]))
    slab_tally_escapes(run, walks);
  walks->left[0] = walks->left[1] = (LaneInt)(0);
}

// Light goes through an interface into the next layer, where its cosine is `cosine`.
TYN_RARE static void slab_pass(const SlabRun *run, SlabWalks *walks, int lane, uint below, float cosine) {
  float ratio = below ? walks->ratio_down.lane[lane] : walks->ratio_up.lane[lane];
  int layer = walks->layer.lane[lane], next = layer + (below ? 1 : -1);
  ulong weight = slab_weight(walks->weight.lane[lane]);
  slab_add(run->tally + TYN_SLAB_TALLY_LAYERS + layer, 0ul - weight);
  slab_add(run->tally + TYN_SLAB_TALLY_LAYERS + next, weight);
  if (run->p.sweep_count)
    slab_leave_layer(walks, lane);
  slab_enter(run, walks, lane, next);
  walks->z.lane[lane] = below ? 0.0f : walks->thickness.lane[lane];
  walks->direction[0].lane[lane] *= ratio;
  walks->direction[1].lane[lane] *= ratio;
  walks->direction[2].lane[lane] = below ? cosine : -cosine;
}

// The walks in the lanes of `mask` have met an interface: `down` says which. Those that go through move into the next layer or
// leave the slab. Returns the mask of the latter.
static LaneInt slab_cross(const SlabRun *run, SlabWalks *walks, LaneInt mask, LaneInt down, LaneUint random) {
  LaneFloat uz = walks->direction[2].all;
  LaneFloats cos_t;
  LaneInt through = mask;
  cos_t.all = fabs(uz);
  if (!(run->p.flags & TYN_SLAB_MATCHED)) {
    LaneFloat ratio = lane_choose(down, walks->ratio_down.all, walks->ratio_up.all);
    LaneFloat fresnel = slab_fresnel(fabs(uz), ratio, &cos_t.all);
    LaneInt reflected = mask & lane_lt(lane_uniform(random), fresnel);
    through &= ~reflected;
    walks->direction[2].all = lane_choose(reflected, -uz, uz);
    walks->reflections.all -= lane_as_uint(reflected);
  }
  LaneInt exits = through;
  if (run->p.layer_count > 1u) {
    LaneInt last = lane_eq(walks->layer.all, (LaneInt)((int)run->p.layer_count - 1));
    exits &= (down & last) | (~down & lane_eq(walks->layer.all, (LaneInt)(0)));
    uint downwards = lane_bits(down);
    for (uint bits = lane_bits(through & ~exits); bits; bits &= bits - 1u) {
      int lane = lane_lowest(bits);
      slab_pass(run, walks, lane, downwards >> lane & 1u, cos_t.lane[lane]);
    }
  }
  walks->left[0] |= exits & ~down;
  walks->left[1] |= exits & down;
  walks->outside = lane_choose(exits, cos_t.all, walks->outside);
  return exits;
}

// 1 - cos of every lane's deflection.
static LaneFloat slab_deflection(const SlabRun *run, const SlabWalks *walks, LaneInt mask, const LaneUint random[4]) {
  LaneFloats away;
  away.all = lane_hg_one_minus_cos(lane_uniform(random[1]), walks->g.all);
  if (!(run->p.flags & TYN_SLAB_GENERAL))
    return away.all;
  LaneUints words[3];
  for (int i = 0; i < 3; ++i)
    words[i].all = random[i];
  for (uint bits = lane_bits(mask); bits; bits &= bits - 1u) {
    int lane = lane_lowest(bits), layer = walks->layer.lane[lane];
    if (!run->layers[layer].general)
      continue;
    // fresh numbers, since azimuth and roulette use those of this event too
    uint4 counter = tyn_uint4(words[0].lane[lane], words[1].lane[lane], words[2].lane[lane], TYN_DOMAIN_PHASE);
    away.lane[lane] = tyn_phase_sample_away(run->phases[layer], run->tables,
                                            tyn_philox(counter, tyn_uint2(run->p.seed[0], run->p.seed[1])));
  }
  return away.all;
}

// Turns the direction of the lanes in `mask` by the phase function.
static void slab_turn(const SlabRun *run, SlabWalks *walks, LaneInt mask, const LaneUint random[4]) {
  LaneFloat x = walks->direction[0].all, y = walks->direction[1].all, z = walks->direction[2].all;
  int lateral = (run->p.flags & TYN_SLAB_LATERAL) != 0u;
  if (run->p.flags & TYN_SLAB_ISOTROPIC) {
    LaneFloat cosine = 1.0f - 2.0f * lane_uniform(random[1]);
    walks->direction[2].all = lane_choose(mask, cosine, z);
    if (lateral) {
      LaneFloat sin_phi, cos_phi;
      lane_sincos_turn(lane_uniform(random[2]), &sin_phi, &cos_phi);
      LaneFloat sine = sqrt((1.0f - cosine) * (1.0f + cosine));
      walks->direction[0].all = lane_choose(mask, sine * cos_phi, x);
      walks->direction[1].all = lane_choose(mask, sine * sin_phi, y);
    }
    return;
  }
  LaneFloat away = slab_deflection(run, walks, mask, random);
  LaneFloat cos_theta = 1.0f - away;
  LaneFloat sin_theta = sqrt(lane_max((LaneFloat)(0.0f), away * (2.0f - away)));
  LaneFloat sin_phi, cos_phi;
  lane_sincos_turn(lane_uniform(random[2]), &sin_phi, &cos_phi);
  if (!lateral) {
    LaneFloat sine = sqrt(lane_max((LaneFloat)(0.0f), (1.0f - z) * (1.0f + z)));
    LaneFloat new_z = cos_theta * z + sin_theta * sine * cos_phi;
    walks->direction[2].all = lane_choose(mask, lane_min(lane_max(new_z, (LaneFloat)(-1.0f)), (LaneFloat)(1.0f)), z);
    return;
  }
  LaneFloat new_x = x, new_y = y, new_z = z;
  lane_rotate(&new_x, &new_y, &new_z, cos_theta, sin_theta * cos_phi, sin_theta * sin_phi);
  walks->direction[0].all = lane_choose(mask, new_x, x);
  walks->direction[1].all = lane_choose(mask, new_y, y);
  walks->direction[2].all = lane_choose(mask, new_z, z);
}

// Adds the weight of every lane in `mask`, which is about to scatter, to its depth bin.
static void slab_tally_depth(const SlabRun *run, const SlabWalks *walks, LaneInt mask) {
  LaneFloat position = (walks->top.all + walks->z.all) * run->p.depth_scale;
  LaneUint layer = lane_as_uint(walks->layer.all) * run->p.depth_bins;
  LaneUints tally, weight;
  tally.all = slab_tally_of(run->p.depth, position, run->p.depth_bins, (LaneUint)(0u), mask);
  tally.all += lane_choose(lane_eq(tally.all, (LaneUint)(TYN_SLAB_TALLY_NOTHING)), (LaneUint)(0u), layer);
  weight.all = slab_weights(walks->weight.all);
  TYN_UNROLL_4
  for (int lane = 0; lane < TYN_LANES; ++lane)
    slab_add(run->tally + tally.lane[lane], (ulong)weight.lane[lane]);
}

// Lanes in layers without extinction.
static LaneInt slab_clear_lanes(const SlabWalks *walks) {
  return lane_lt((LaneFloat)(1e29f), walks->mean_free_path.all);
}

// A flight through a clear layer: adds its length to the depth bins it passes, in units of a bin's width.
TYN_RARE static void slab_fly_clear(const SlabRun *run, const SlabWalks *walks, int lane, float from) {
  float to = walks->z.lane[lane], top = walks->top.lane[lane];
  float first = (top + fmin(from, to)) * run->p.depth_scale, last = (top + fmax(from, to)) * run->p.depth_scale;
  float slant = fmin(1.0f / fabs(walks->direction[2].lane[lane]), 1e4f);
  global ulong *tally = run->tally + run->p.depth + (uint)walks->layer.lane[lane] * run->p.depth_bins;
  for (uint bin = slab_bin(first, run->p.depth_bins); bin < run->p.depth_bins && (float)bin < last; ++bin) {
    float part = fmin(last, (float)(bin + 1u)) - fmax(first, (float)bin);
    slab_add(tally + bin, (ulong)(walks->weight.lane[lane] * part * slant * TYN_SLAB_WEIGHT_SCALE + 0.5f));
  }
}

// Moves the lanes in `mask` along their flights, to their ends or to the interface before. Returns the mask of those that met
// one; *down: the lower one.
static LaneInt slab_fly(const SlabRun *run, SlabWalks *walks, LaneInt mask, LaneFloat flight, LaneInt *down) {
  LaneFloat uz = walks->direction[2].all;
  LaneFloats before;
  before.all = walks->z.all;
  LaneFloat z = lane_fma(uz, flight, before.all);
  *down = lane_lt(walks->thickness.all, z);
  LaneInt crosses = (*down | lane_lt(z, (LaneFloat)(0.0f))) & mask;
  LaneFloat end = lane_choose(*down, walks->thickness.all, (LaneFloat)(0.0f));
  z = lane_choose(crosses, end, z);
  walks->z.all = lane_choose(mask, z, before.all);
  if (run->p.flags & (TYN_SLAB_LATERAL | TYN_SLAB_LENGTH)) {
    LaneFloat length = lane_choose(crosses, (end - before.all) / uz, flight);
    length = lane_choose(mask, length, (LaneFloat)(0.0f));
    walks->length.all += length;
    walks->position[0].all = lane_fma(walks->direction[0].all, length, walks->position[0].all);
    walks->position[1].all = lane_fma(walks->direction[1].all, length, walks->position[1].all);
  }
  if (run->p.flags & TYN_SLAB_CLEAR && run->p.depth_bins)
    for (uint bits = lane_bits(mask & slab_clear_lanes(walks)); bits; bits &= bits - 1u) {
      int lane = lane_lowest(bits);
      slab_fly_clear(run, walks, lane, before.lane[lane]);
    }
  return crosses;
}

// Scatters the lanes in `mask`. Returns the mask of those that roulette ends.
static LaneInt slab_scatter(const SlabRun *run, SlabWalks *walks, LaneInt mask, const LaneUint random[4]) {
  LaneFloat kept = walks->weight.all * walks->albedo.all;
  walks->order.all -= lane_as_uint(mask);
  slab_turn(run, walks, mask, random);
  LaneFloat threshold = (LaneFloat)(run->p.roulette_threshold);
  LaneInt plays = lane_lt(kept, threshold);
  LaneFloat u = lane_uniform(random[3]);
  LaneInt dies = (LaneInt)(0);
  if (run->p.flags & TYN_SLAB_ANALOG) {
    LaneFloat a = walks->absorption.all;
    u = lane_uniform_fine(random[3]);
    dies = lane_le(u, a);
    u = (u - a) / (1.0f - a); // uniform again for those that go on
  }
  dies |= plays & lane_le(kept, u * threshold);
  kept = lane_choose(plays, threshold, kept);
  walks->weight.all = lane_choose(mask, kept, walks->weight.all);
  return mask & dies;
}

// Takes the lanes in `mask`, whose walks are not allowed to go on, off the books.
TYN_RARE static void slab_cut(const SlabRun *run, SlabWalks *walks, LaneInt mask) {
  LaneUints weight;
  weight.all = slab_weights(walks->weight.all);
  for (uint bits = lane_bits(mask); bits; bits &= bits - 1u) {
    int lane = lane_lowest(bits);
    slab_add(run->tally + TYN_SLAB_TALLY_CUT, (ulong)weight.lane[lane]);
    slab_add(run->tally + TYN_SLAB_TALLY_LAYERS + walks->layer.lane[lane], 0ul - (ulong)weight.lane[lane]);
  }
}

kernel void slab_walk(global const TynSlabLayerRecord *layers, global const TynPhaseRecord *phases,
                      global const float *tables, global const float *sweep, global ulong *tallies,
                      TynSlabParameters parameters) {
  uint item = (uint)get_global_id(0);
  uint batch = item / parameters.batch_items;
  uint next = batch * parameters.batch + item % parameters.batch_items * parameters.slice;
  uint end = min(min(next + parameters.slice, (batch + 1u) * parameters.batch), parameters.count);
  if (next >= end)
    return;
  SlabRun run;
  run.layers = layers;
  run.phases = phases;
  run.tables = tables;
  run.sweep = sweep;
  run.p = parameters;
  run.tally = tallies + (ulong)batch * parameters.tally_count;

  SlabWalks walks;
  SlabSums sums;
  slab_clear(&run, &walks, &sums);
  LaneUint ahead[4]; // the random numbers of the next step
  LaneInt ready = (LaneInt)(0);
  for (int i = 0; i < 4; ++i)
    ahead[i] = (LaneUint)(0u);
  for (uint step = 0u;; ++step) {
    slab_exit(&run, &walks, &sums);
    if (next < end)
      next += slab_begin(&run, &walks, &sums, ~walks.active.all, next, end);
    else if (!lane_any(walks.active.all))
      break;
    LaneUint random[4] = {ahead[0], ahead[1], ahead[2], ahead[3]};
    ahead[0] = walks.path[0];
    ahead[1] = walks.path[1];
    ahead[2] = walks.draw;
    ahead[3] = (LaneUint)(TYN_DOMAIN_WALK);
    lane_philox_rounds(ahead, run.p.seed[0], run.p.seed[1], 7);
    walks.draw += 1u;

    LaneInt down;
    LaneFloat flight = -lane_log(lane_uniform_fine(random[0])) * walks.mean_free_path.all;
    LaneInt crosses = slab_fly(&run, &walks, ready, flight, &down);
    LaneInt scatters = ready & ~crosses;
    if (run.p.flags & TYN_SLAB_CLEAR)
      scatters &= ~slab_clear_lanes(&walks);
    if (run.p.depth_bins)
      slab_tally_depth(&run, &walks, scatters);
    LaneInt cut = (LaneInt)(0);
    if (run.p.max_order)
      cut = scatters & lane_le((LaneUint)(run.p.max_order), walks.order.all);
    if (step % SLAB_SUM_STEPS == 0u) {
      slab_empty_sums(&run, &sums);
      cut |= ready & lane_lt((LaneUint)(SLAB_TRAPPED), walks.reflections.all);
    }
    if (lane_any(cut)) {
      slab_cut(&run, &walks, cut);
      scatters &= ~cut;
      crosses &= ~cut;
    }
    // the interface first: it needs the old directions, and so waits for nothing that the scattering computes
    LaneInt exits = slab_cross(&run, &walks, crosses, down, random[3]);
    LaneInt dies = slab_scatter(&run, &walks, scatters, random);
    sums.events.all -= lane_as_uint(scatters);
    // those that have just been begun have no random numbers yet: they are active, but not ready
    LaneInt over = exits | dies | cut;
    ready = walks.active.all & ~over;
    walks.active.all = ready;
  }
  slab_empty_sums(&run, &sums);
}

// Empties the first `count` tallies. (oclgrind does not see that clEnqueueFillBuffer writes.)
kernel void slab_clear_tallies(global ulong *tallies, uint count) {
  uint tally = (uint)get_global_id(0);
  if (tally < count)
    tallies[tally] = 0ul;
}
