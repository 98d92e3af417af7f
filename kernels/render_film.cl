// SPDX-License-Identifier: Apache-2.0
// The film: each pixel takes in its samples of a pass in their order, so that splitting passes changes no bit.
#include "math.clh"
#include "shared_render.h"

// One pixel's place in the planes (TYN_PLANE_*).
typedef struct {
  global float *first;
  size_t stride;
} FilmPixel;

static void film_mean(FilmPixel pixel, uint plane, float value, float n) {
  global float *mean = pixel.first + plane * pixel.stride;
  *mean += (value - *mean) / n;
}

static float film_luminance(float r, float g, float b) { return 0.2126f * r + 0.7152f * g + 0.0722f * b; }

// Mean and sum of squared deviations (Welford 1962).
static void film_beauty(FilmPixel pixel, const float beauty[3], float n) {
  float before[3], after[3];
  for (uint c = 0; c < 3; ++c) {
    global float *mean = pixel.first + (TYN_PLANE_BEAUTY + c) * pixel.stride;
    global float *spread = pixel.first + (TYN_PLANE_SPREAD + c) * pixel.stride;
    before[c] = beauty[c] - *mean;
    *mean += before[c] / n;
    after[c] = beauty[c] - *mean;
    *spread += before[c] * after[c];
  }
  global float *spread = pixel.first + TYN_PLANE_LUMINANCE * pixel.stride;
  *spread += film_luminance(before[0], before[1], before[2]) * film_luminance(after[0], after[1], after[2]);
}

static int film_add_sample(FilmPixel pixel, global const TynPathResult *result) {
  float n = pixel.first[TYN_PLANE_SAMPLES * pixel.stride] + 1.0f;
  pixel.first[TYN_PLANE_SAMPLES * pixel.stride] = n;
  float beauty[3];
  for (uint c = 0; c < 3; ++c)
    beauty[c] = ((result->light[0][c] + result->light[1][c]) + result->light[2][c]) + result->light[3][c];
  int good = isfinite(beauty[0]) && isfinite(beauty[1]) && isfinite(beauty[2]);
  if (!good)
    beauty[0] = beauty[1] = beauty[2] = 0.0f;
  film_beauty(pixel, beauty, n);
  for (uint event = 0; event < TYN_EVENT_COUNT; ++event)
    for (uint c = 0; c < 3; ++c)
      film_mean(pixel, TYN_PLANE_LIGHT + 3 * event + c, good ? result->light[event][c] : 0.0f, n);
  for (uint c = 0; c < 3; ++c) {
    film_mean(pixel, TYN_PLANE_ALBEDO + c, result->albedo[c], n);
    film_mean(pixel, TYN_PLANE_NORMAL + c, result->normal[c], n);
  }
  int hit = isfinite(result->depth);
  film_mean(pixel, TYN_PLANE_ALPHA, hit ? 1.0f : 0.0f, n);
  if (hit) {
    float hits = pixel.first[TYN_PLANE_HITS * pixel.stride] + 1.0f;
    pixel.first[TYN_PLANE_HITS * pixel.stride] = hits;
    film_mean(pixel, TYN_PLANE_DEPTH, result->depth, hits);
  }
  return good;
}

kernel void film_add(global float *film, global const TynPathResult *results, volatile global uint *counters,
                     TynRenderParameters parameters) {
  uint i = (uint)get_global_id(0);
  if (i >= parameters.pixel_count)
    return;
  FilmPixel pixel;
  pixel.first = film + parameters.first_pixel + i;
  pixel.stride = (size_t)parameters.width * parameters.height;
  for (uint sample = 0; sample < parameters.sample_count; ++sample)
    if (!film_add_sample(pixel, results + (size_t)sample * parameters.pixel_count + i))
      atomic_inc(counters + TYN_COUNT_BAD);
}
