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

// How S depends on the directions: it is F_t(w_i) F_t(w_o) lobe times
//   SEPARABLE     R of the distance; no more terms
//   DIPOLE        the directional dipole's value, whose terms are numbered by TYN_DIPOLE_* below
//   TABLE         R of the distance, times q(w_i) q(w_o) / q(normal): see TYN_ANGLES_* below
//   THROUGH       R of the distance across the entry's normal: light leaves on a slab's other side; no more terms
#define TYN_DIRECTIONS_SEPARABLE 0u
#define TYN_DIRECTIONS_DIPOLE 1u
#define TYN_DIRECTIONS_TABLE 2u
#define TYN_DIRECTIONS_THROUGH 3u

// In units of the record's length.
#define TYN_DIPOLE_DIFFUSION 0u  // D
#define TYN_DIPOLE_FALLOFF 1u    // sigma_tr
#define TYN_DIPOLE_C_PHI 2u      // of the exitance, C_phi(eta)
#define TYN_DIPOLE_C_E 3u        // C_E(eta)
#define TYN_DIPOLE_EXTENSION 4u  // d_e
#define TYN_DIPOLE_SEPARATION 5u // 2 A d_e: from the source to its image
#define TYN_DIPOLE_BACKLIT 6u    // (1 / (3 sigma_t))^2
#define TYN_DIPOLE_TERMS 7u

// A table q of where light that got in perpendicularly leaves to, over the lobe of diffuse light: rows for radii x in steps of
// half an octave, each with a value in the middle of every eighth of the squared cosine outside; bilinear between.
#define TYN_ANGLES_FIRST 0u // log2 x of the first row
#define TYN_ANGLES_ROWS 1u
#define TYN_ANGLES_ENTRY                                                                                               \
  2u // what comes back of light from cosines in equal steps, over what does of perpendicular light
#define TYN_ANGLES_VALUES 19u // 8 a row
#define TYN_ANGLES_ENTRIES 17
#define TYN_ANGLES_ROWS_PER_OCTAVE 2
#define TYN_ANGLES_COLUMNS 8

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
  float albedo;        // int 2 pi r R(r) dr
  float chance;        // with which this channel's radius is drawn: in proportion to the albedo
  float ior;           // index of refraction inside over outside, where light gets in
  float exit_ior;      // the same where it leaves
  float lobe;          // 1 / (pi c), c = 2 int_0^1 F_t(mu) mu dmu of light from outside, where it leaves
  uint32_t directions; // TYN_DIRECTIONS_*
  uint32_t more;       // of the terms that the directions add, in floats
  float reach;         // beyond it lies at most TYN_BSSRDF_TAIL of the albedo; in the caller's unit of length
} TynProfileRecord;    // 72 bytes

// What of an albedo may lie beyond the radius that probe rays look for all of the surface in.
#define TYN_BSSRDF_TAIL 1e-3

// A medium's profiles over a range of albedos, in units of its mean free path: `count` records from `first` on, by rising
// s = sqrt((1 - albedo) / (1 - g albedo)), each with its s in an array of its own.
typedef struct TynProfileFamily {
  uint32_t first;
  uint32_t count;   // 0: nobody uses the medium
} TynProfileFamily; // 8 bytes

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
