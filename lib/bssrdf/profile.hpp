// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The shapes of kernels/shared_bssrdf.h in double: what models bring their profiles to.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "kernels/shared_bssrdf.h"

namespace tyn {

// The profile of one channel. Members that its kind does not use stay 0.
struct Profile {
  uint32_t kind = TYN_PROFILE_TABLE; // TYN_PROFILE_*
  double length = 1;                 // unit of length, > 0
  double falloff = 0, flux = 0, fluence = 0;
  std::vector<double> terms; // `count` groups
  uint32_t count = 0;
  double albedo = 0;                              // int 2 pi r R(r) dr; 0: nothing comes back
  std::vector<double> rings;                      // TABLE: the parts of that integral in each of the sampler's cells
  std::vector<double> errors;                     // TABLE: relative standard errors at the groups of terms; empty: none
  uint32_t directions = TYN_DIRECTIONS_SEPARABLE; // TYN_DIRECTIONS_*
  std::vector<double> more;                       // the terms that these add
};

// A point source at depth z_r and its mirror image, in units of the profile's length.
struct SourcePair {
  double z_r, z_v;
};

// What a pair gives at distance x, as kernels/shared_bssrdf.h has it: z_r g(d_r) - z_v g(d_v), and h(d_r) - h(d_v).
struct PairLight {
  double flux, fluence;
};

PairLight pair_light(const SourcePair &pair, double falloff, double x);

// R = flux (z_r g - z_v g) + fluence (h - h) over all pairs; the albedo is added.
Profile profile_of_pairs(double length, double falloff, double flux, double fluence,
                         const std::vector<SourcePair> &pairs);

// sum of weight exp(-r^2 / (2 variance)) / (2 pi variance); variances in units of the caller's length^2.
Profile profile_of_gaussians(const std::vector<double> &weights, const std::vector<double> &variances);

// albedo (exp(-x) + exp(-x / 3)) / (8 pi length^2 x), x = r / length.
Profile profile_of_exponentials(double length, double albedo);

// `value`: R length^2 at x = r / length. Below 2^-12 it stays what it is there, or falls like 1 / x; beyond 2^12 it falls like
// exp(-falloff x) / x^3.
Profile profile_of_table(double length, const std::function<double(double)> &value, bool diverges, double falloff);

// The relative standard error of that.
double profile_error(const Profile &profile, double x);

// Multiplies R.
void scale_profile(Profile &profile, double factor);

// Where nothing is scattered.
Profile black_profile();

// R length^2 at x = r / length > 0.
double profile_value(const Profile &profile, double x);

// Border k of the sampler's cells, k from 0 to TYN_SAMPLER_CELLS - 1.
double sampler_border(uint32_t k);

// The chance of a radius below each border, and 1: TYN_SAMPLER_CELLS + 1 values. Needs an albedo above 0.
std::vector<double> sampler_chances(const Profile &profile);

// A radius in units of the profile's length beyond which lies at most the fraction `tail` of the albedo; tables to the next
// border of the sampler's cells, whose chances are given. 0 without an albedo.
double profile_reach(const Profile &profile, const std::vector<double> &chances, double tail);

} // namespace tyn
