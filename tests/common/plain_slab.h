/* SPDX-FileCopyrightText: 2026 The Tyndall authors */
/* SPDX-License-Identifier: Apache-2.0 */
/* The walk that a careful C programmer writes, one photon at a time and in double precision as MCML does (Wang, Jacques, Zheng
 * 1995), with a fast generator (xoshiro128+, Blackman & Vigna 2018): the baseline of bench-slab, and a second opinion on what
 * the slab engine resolves. It shares no code with the library. */
#ifndef PLAIN_SLAB_H
#define PLAIN_SLAB_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A half-space lit along its normal. */
typedef struct PlainSlab {
  double sigma_a, sigma_s; /* 1/mm */
  double g;
  double ior;
} PlainSlab;

#define PLAIN_RINGS 200
#define PLAIN_ANGLES 30
#define PLAIN_DEPTHS 200
#define PLAIN_PATHS 200
#define PLAIN_ORDERS 200

typedef struct PlainTallies {
  double reflectance, absorbed;
  uint64_t events;
  double radial[PLAIN_RINGS], angular[PLAIN_ANGLES], both[PLAIN_RINGS][PLAIN_ANGLES], depth[PLAIN_DEPTHS],
      path[PLAIN_PATHS], order[PLAIN_ORDERS];
} PlainTallies;

/* Walks `photons` photons; resolved tallies (rings, depths and path lengths to 2 mm) only if `resolved`. */
void plain_slab(const PlainSlab *slab, uint64_t photons, uint64_t seed, int resolved, PlainTallies *tallies);

#ifdef __cplusplus
}
#endif

#endif
