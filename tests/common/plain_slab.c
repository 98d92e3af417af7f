/* SPDX-FileCopyrightText: 2026 The Tyndall authors */
/* SPDX-License-Identifier: Apache-2.0 */
#include "plain_slab.h"

#include <math.h>
#include <string.h>

#define EXTENT 2.0 /* mm, of everything that is resolved */

static uint32_t rotate(uint32_t x, int k) { return x << k | x >> (32 - k); }

static double uniform(uint32_t s[4]) {
  const uint32_t result = s[0] + s[3], t = s[1] << 9;
  s[2] ^= s[0];
  s[3] ^= s[1];
  s[1] ^= s[2];
  s[0] ^= s[3];
  s[2] ^= t;
  s[3] = rotate(s[3], 11);
  return ((double)(result >> 8) + 0.5) * 0x1p-24;
}

static double fresnel(double cos_i, double eta, double *cos_t) {
  const double square = 1.0 - (1.0 - cos_i * cos_i) / (eta * eta);
  if (square <= 0.0)
    return 1.0;
  *cos_t = sqrt(square);
  const double a = (cos_i - eta * *cos_t) / (cos_i + eta * *cos_t), b = (eta * cos_i - *cos_t) / (eta * cos_i + *cos_t);
  return 0.5 * (a * a + b * b);
}

/* Henyey & Greenstein 1941. */
static double deflection(double g, double u) {
  if (g == 0.0)
    return 2.0 * u - 1.0;
  const double k = (1.0 - g * g) / (1.0 - g + 2.0 * g * u);
  return (1.0 + g * g - k * k) / (2.0 * g);
}

static void turn(double d[3], double cosine, double phi) {
  const double sine = sqrt(1.0 - cosine * cosine), a = sine * cos(phi), b = sine * sin(phi);
  if (fabs(d[2]) > 0.99999) {
    d[0] = a;
    d[1] = b;
    d[2] = d[2] > 0.0 ? cosine : -cosine;
    return;
  }
  const double across = sqrt(1.0 - d[2] * d[2]);
  const double x = a * (d[0] * d[2]) / across - b * d[1] / across + d[0] * cosine;
  const double y = a * (d[1] * d[2]) / across + b * d[0] / across + d[1] * cosine;
  d[2] = -a * across + d[2] * cosine;
  d[0] = x;
  d[1] = y;
}

static int bin(double position, double extent, int bins) {
  const int i = (int)(position / extent * (double)bins);
  return i < bins ? i : -1;
}

static void tally_exit(PlainTallies *t, const double position[3], double cosine, double length, int order,
                       double weight) {
  int angle = bin(acos(fmin(cosine, 1.0)), 1.57079633, PLAIN_ANGLES);
  angle = angle < 0 ? PLAIN_ANGLES - 1 : angle;
  const int ring = bin(sqrt(position[0] * position[0] + position[1] * position[1]), EXTENT, PLAIN_RINGS);
  const int path = bin(length, EXTENT, PLAIN_PATHS);
  t->angular[angle] += weight;
  if (ring >= 0) {
    t->radial[ring] += weight;
    t->both[ring][angle] += weight;
  }
  if (path >= 0)
    t->path[path] += weight;
  if (order < PLAIN_ORDERS)
    t->order[order] += weight;
}

static void walk(const PlainSlab *slab, uint32_t random[4], int resolved, PlainTallies *t) {
  const double sigma_t = slab->sigma_a + slab->sigma_s, albedo = slab->sigma_s / sigma_t;
  double p[3] = {0, 0, 0}, d[3] = {0, 0, 1}, length = 0, cos_t = 1;
  double weight = 1.0 - (slab->ior == 1.0 ? 0.0 : fresnel(1.0, slab->ior, &cos_t));
  int order = 0;
  for (;;) {
    double s = -log(uniform(random)) / sigma_t;
    const int leaves = p[2] + d[2] * s < 0.0;
    if (leaves)
      s = -p[2] / d[2];
    for (int i = 0; i < 3; ++i)
      p[i] += d[i] * s;
    length += s;
    if (leaves) {
      p[2] = 0.0;
      cos_t = -d[2];
      if (slab->ior != 1.0 && uniform(random) < fresnel(-d[2], 1.0 / slab->ior, &cos_t)) {
        d[2] = -d[2];
        continue;
      }
      t->reflectance += weight;
      if (resolved)
        tally_exit(t, p, cos_t, length, order, weight);
      return;
    }
    ++t->events;
    ++order;
    const double lost = weight * (1.0 - albedo);
    t->absorbed += lost;
    const int depth = resolved ? bin(p[2], EXTENT, PLAIN_DEPTHS) : -1;
    if (depth >= 0)
      t->depth[depth] += lost;
    weight -= lost;
    if (weight < 0.1) {
      if (uniform(random) * 0.1 >= weight)
        return;
      weight = 0.1;
    }
    turn(d, deflection(slab->g, uniform(random)), 6.28318531 * uniform(random));
  }
}

void plain_slab(const PlainSlab *slab, uint64_t photons, uint64_t seed, int resolved, PlainTallies *tallies) {
  uint32_t random[4] = {(uint32_t)seed ^ 0x9e3779b9u, (uint32_t)(seed >> 32) ^ 0x243f6a88u, 0xb7e15162u, 0x2545f491u};
  memset(tallies, 0, sizeof *tallies);
  for (int i = 0; i < 64; ++i)
    uniform(random);
  for (uint64_t i = 0; i < photons; ++i)
    walk(slab, random, resolved, tallies);
}
