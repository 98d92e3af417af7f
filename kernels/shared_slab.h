// SPDX-License-Identifier: Apache-2.0
// The records that the slab engine and its kernels share. tests/unit compares the sizes and offsets that the host sees with
// those that a kernel reports.
#ifndef TYN_SHARED_SLAB_H
#define TYN_SHARED_SLAB_H

#include "shared.h"

// One layer in one spectral channel.
typedef struct TynSlabLayerRecord {
  float mean_free_path; // 1 / sigma_t; 1e30 in a clear layer
  float albedo;
  float g;         // of the fast path; the others are sampled by `phase`
  float top;       // depth at which it begins
  float thickness; // INFINITY: a half-space
  float ior;
  uint32_t general; // 1: the phase function is not Henyey-Greenstein's
  float
      absorption; // the chance that an event ends a walk, where 1 - albedo is too small for a float's 1 - ...: then albedo is 1
} TynSlabLayerRecord; // 32 bytes

#define TYN_SLAB_MAX_LAYERS 64

// What a run needs, as bits of TynSlabParameters::flags.
#define TYN_SLAB_LATERAL 1u   // x and y are followed
#define TYN_SLAB_LENGTH 2u    // path lengths are followed
#define TYN_SLAB_ISOTROPIC 4u // all layers scatter isotropically
#define TYN_SLAB_GENERAL 8u   // some layer's phase function is not Henyey-Greenstein's
#define TYN_SLAB_DIFFUSE 16u  // diffuse incidence
#define TYN_SLAB_MATCHED 32u  // one index of refraction throughout
#define TYN_SLAB_BINS 64u     // what leaves is sorted into bins
#define TYN_SLAB_CLEAR 128u   // some layer has no extinction
#define TYN_SLAB_ANALOG 256u  // some layer absorbs walks as a whole
#define TYN_SLAB_ESCAPES 512u // walks that leave upwards are counted as escapes, in place of bins

// Tallies are 64-bit integers, so that their sum does not depend on the order. A weight, which is at most 1, is rounded to a
// multiple of 2^-23; those of a sweep, which may be very small, to 2^-36. A batch has at most 2^16 photons: no tally overflows.
#define TYN_SLAB_WEIGHT_SCALE 8388608.0f
#define TYN_SLAB_SWEEP_SCALE 68719476736.0f
#define TYN_SLAB_BATCH 65536u // photons, at most

// Escapes: walks that leave upwards, counted by scattering order, radius and angle. Orders and radii are numbered by the bits of
// floats with three mantissa bits, eight to a factor of two, so that orders up to 16 have a number each; angles in equal steps
// of the squared cosine outside, which are equal projected solid angles.
#define TYN_ESCAPE_SHIFT 20              // as_uint(x) >> this is the number of x ...
#define TYN_ESCAPE_FIRST_ORDER (127 * 8) // ... this one that of 1
#define TYN_ESCAPE_ANGLES 8

// Where each tally stands. The first ones are always there; after them come those that were asked for.
#define TYN_SLAB_TALLY_EXIT 0u // specular and diffuse reflectance, direct and diffuse transmittance
#define TYN_SLAB_TALLY_CUT 4u
#define TYN_SLAB_TALLY_EVENTS 5u  // a plain count
#define TYN_SLAB_TALLY_NOTHING 6u // receives what falls into no bin
#define TYN_SLAB_TALLY_SURFACE 7u // of diffuse incidence: reflected by the first interface
#define TYN_SLAB_TALLY_LAYERS 8u  // one a layer: what came in less what went out, which was absorbed

typedef struct TynSlabParameters {
  uint32_t seed[2];         // low, high word
  uint32_t first_photon[2]; // low, high word
  uint32_t count;           // photons of this launch
  uint32_t batch;           // photons a batch; the last one may have fewer
  uint32_t slice;           // photons a work-item, at most `batch`
  uint32_t batch_items;     // work-items a batch
  uint32_t flags;           // TYN_SLAB_*
  uint32_t layer_count;
  uint32_t max_order; // 0: no limit
  float roulette_threshold;
  float ior_above, ior_below;
  float start[4]; // collimated: direction inside the first layer, and the weight that gets there
  uint32_t beam;  // TYN_BEAM_*
  float beam_radius;
  uint32_t tally_count; // of one batch
  uint32_t radial_bins, angular_bins, depth_bins, order_bins, path_bins, sweep_count;
  float radial_scale, depth_scale, path_scale; // bins per length
  // offset of the reflectance's tallies; the transmittance's follow at once
  uint32_t radial, angular, radial_angular, depth, order, path, sweep; // radial_angular: 0 if not asked for
  // the tallies of escapes, order by order, radius by radius; the first radius holds all nearer ones, the last all farther ones
  uint32_t escapes, escape_first_radius, escape_radii;
} TynSlabParameters; // 156 bytes

#endif
