// SPDX-License-Identifier: Apache-2.0
// The records that BSSRDF models and their kernels share. tests/unit compares the sizes and offsets that the host sees with
// those that a kernel reports.
#ifndef TYN_SHARED_BSSRDF_H
#define TYN_SHARED_BSSRDF_H

#include "shared.h"

// The shape of a profile. x = r / length is the radius in the channel's own unit of length, so that no scale of the scene can
// overflow a float; what a shape gives is R(r) length^2. `terms` are `count` groups of floats in the array of all terms.
//   PAIRS         point sources and their mirror images, groups (z_r, z_v, z_v^2 - z_r^2), d^2 = x^2 + z^2:
//                 flux (z_r g(d_r) - z_v g(d_v)) + fluence (h(d_r) - h(d_v)),
//                 g(d) = (1 + falloff d) exp(-falloff d) / d^3, h(d) = exp(-falloff d) / d
//   GAUSSIANS     groups (a, b): a exp(-b x^2)
//   EXPONENTIALS  no terms: flux (exp(-x) + exp(-x / 3)) / x
//   TABLE         groups (ln(R / flux), its slope by x) at the borders of the sampler's cells below, joined by cubics in x;
// below                 the first border R is as there or, if fluence is 1, falls like 1 / x; beyond the last like x^-3
// exp(-falloff x)
#define TYN_PROFILE_PAIRS 0u
#define TYN_PROFILE_GAUSSIANS 1u
#define TYN_PROFILE_EXPONENTIALS 2u
#define TYN_PROFILE_TABLE 3u

typedef struct TynProfileRecord {
  uint32_t kind;    // TYN_PROFILE_*
  uint32_t first;   // of the terms, in floats
  uint32_t count;   // groups of terms
  uint32_t chances; // cumulative, of the sampler's cells or of the Gaussians, in the array of terms
  float length;     // unit of length, in the caller's
  float per_length; // 1 / length
  float per_area;   // 1 / length^2
  float falloff;    // see above
  float flux;       // see above
  float fluence;
  float albedo;     // int 2 pi r R(r) dr
  float chance;     // with which this channel's radius is drawn: in proportion to the albedo
} TynProfileRecord; // 48 bytes

// Radii that one lane of a work-item goes through.
#define TYN_BSSRDF_ROW 16u

// Radii are drawn from cells whose borders are floats x with five mantissa bits, uniformly over the ring between two borders:
// so a radius' bits say in which cell it is. Cell 0 begins at x = 0, and where R diverges there it is drawn from
// with a density like 1 / x; the last one has no end, and a density like x^-3.
// Tables have their groups at the borders from 2^-12 to 2^12: the upper ends of all cells but the last one.
#define TYN_SAMPLER_SHIFT 18                                          // as_uint(x) >> this numbers the cells
#define TYN_SAMPLER_FIRST (115u << 5)                                 // number of x = 2^-12 ...
#define TYN_SAMPLER_LAST (139u << 5)                                  // ... and of 2^12
#define TYN_SAMPLER_CELLS (TYN_SAMPLER_LAST - TYN_SAMPLER_FIRST + 2u) // 770

#endif
