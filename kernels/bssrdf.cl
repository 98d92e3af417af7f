// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// BSSRDF models in bulk: profiles, radii, densities, values. A work-item has a row of TYN_BSSRDF_ROW x TYN_LANES radii or
// paths; results of several channels are stored channel by channel.
#include "bssrdf_directions.clh"
#include "bssrdf_mixture.clh"
#include "random.clh"

// Lanes of radii; those beyond the end of the array are 1.
static LaneFloat load_lanes(global const float *values, size_t first, ulong count) {
  LaneFloats x;
  x.all = (LaneFloat)(1.0f);
  for (int lane = 0; lane < TYN_LANES; ++lane)
    if (first + (size_t)lane < count)
      x.lane[lane] = values[first + (size_t)lane];
  return x.all;
}

static void store_lanes(global float *values, size_t first, ulong count, LaneFloat value) {
  LaneFloats x;
  x.all = value;
  for (int lane = 0; lane < TYN_LANES; ++lane)
    if (first + (size_t)lane < count)
      values[first + (size_t)lane] = x.lane[lane];
}

kernel void bssrdf_profile(global const TynProfileRecord *records, global const float *terms, uint channels,
                           global const float *radii, ulong count, global float *profile) {
  size_t first = get_global_id(0) * TYN_BSSRDF_ROW * TYN_LANES;
  for (uint i = 0u; i < TYN_BSSRDF_ROW && first < count; ++i, first += TYN_LANES) {
    LaneFloat radius = load_lanes(radii, first, count);
    for (uint c = 0u; c < channels; ++c) {
      TynProfileRecord record = records[c];
      store_lanes(profile + c * count, first, count, profile_value(record, terms, radius * record.per_length));
    }
  }
}

kernel void bssrdf_evaluate(global const TynProfileRecord *records, global const float *terms, uint channels,
                            global const TynBssrdfPath *paths, ulong count, global float *values) {
  size_t first = get_global_id(0) * TYN_BSSRDF_ROW * TYN_LANES;
  for (uint i = 0u; i < TYN_BSSRDF_ROW && first < count; ++i, first += TYN_LANES) {
    BssrdfPoints points;
    bssrdf_points_load(&points, paths, first, count);
    for (uint c = 0u; c < channels; ++c)
      store_lanes(values + c * count, first, count, bssrdf_value(records[c], terms, &points));
  }
}

kernel void bssrdf_density(global const TynProfileRecord *records, global const float *terms, uint channels,
                           global const float *radii, ulong count, global float *density) {
  size_t first = get_global_id(0) * TYN_BSSRDF_ROW * TYN_LANES;
  for (uint i = 0u; i < TYN_BSSRDF_ROW && first < count; ++i, first += TYN_LANES)
    store_lanes(density, first, count, mixed_density(records, terms, channels, load_lanes(radii, first, count)));
}

// Radii, their densities, and what each channel weighs there: R / density.
kernel void bssrdf_sample(global const TynProfileRecord *records, global const float *terms, uint channels,
                          uint seed_low, uint seed_high, ulong first_sample, ulong count, global float *radii,
                          global float *density, global float *weights, uint with_weights) {
  size_t first = get_global_id(0) * TYN_BSSRDF_ROW * TYN_LANES;
  for (uint i = 0u; i < TYN_BSSRDF_ROW && first < count; ++i, first += TYN_LANES) {
    LaneUint random[4];
    ulong sample = first_sample + first;
    LaneUint low = (LaneUint)((uint)sample) + TYN_LANE_NUMBERS;
    LaneUint carry =
        lane_as_uint(lane_lt(lane_as_int(low ^ 0x80000000u), lane_as_int((LaneUint)((uint)sample) ^ 0x80000000u)));
    random[0] = low;
    random[1] = (LaneUint)((uint)(sample >> 32)) - carry;
    random[2] = (LaneUint)(0u);
    random[3] = (LaneUint)(TYN_DOMAIN_BSSRDF);
    lane_philox(random, seed_low, seed_high);
    LaneFloat radius = draw_radius(records, terms, channels, random);
    LaneFloat drawn_with = mixed_density(records, terms, channels, radius);
    store_lanes(radii, first, count, radius);
    store_lanes(density, first, count, drawn_with);
    for (uint c = 0u; c < channels && with_weights; ++c) {
      TynProfileRecord record = records[c];
      LaneFloat weight = profile_value(record, terms, radius * record.per_length) / drawn_with;
      weight = lane_choose(lane_lt((LaneFloat)(0.0f), drawn_with), weight, (LaneFloat)(0.0f));
      store_lanes(weights + c * count, first, count, weight);
    }
  }
}
