// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "render/film.hpp"

#include <cmath>
#include <limits>

namespace tyn {
namespace {

// Planes of the layers that are stored as they are read, in the order of their channels.
std::vector<uint32_t> stored_planes(uint32_t layer) {
  const auto three = [](uint32_t first) { return std::vector<uint32_t>{first, first + 1, first + 2}; };
  switch (layer) {
  case TYN_LAYER_BEAUTY:
    return {TYN_PLANE_BEAUTY, TYN_PLANE_BEAUTY + 1, TYN_PLANE_BEAUTY + 2, TYN_PLANE_ALPHA};
  case TYN_LAYER_SUBSURFACE:
    return three(TYN_PLANE_LIGHT + 3 * TYN_EVENT_SUBSURFACE);
  case TYN_LAYER_SPECULAR:
    return three(TYN_PLANE_LIGHT + 3 * TYN_EVENT_SPECULAR);
  case TYN_LAYER_DIFFUSE:
    return three(TYN_PLANE_LIGHT + 3 * TYN_EVENT_DIFFUSE);
  case TYN_LAYER_EMISSION:
    return three(TYN_PLANE_LIGHT + 3 * TYN_EVENT_NONE);
  case TYN_LAYER_ALBEDO:
    return three(TYN_PLANE_ALBEDO);
  case TYN_LAYER_NORMAL:
    return three(TYN_PLANE_NORMAL);
  default:
    return {TYN_PLANE_SAMPLES};
  }
}

} // namespace

Film::Film(TynContext &owner, uint32_t width, uint32_t height)
    : context(owner), pixel_count(size_t(width) * height),
      planes(owner, pixel_count * TYN_PLANE_COUNT * sizeof(float)) {
  context.fill_zero(planes);
}

std::vector<float> Film::plane(uint32_t first, uint32_t count) const {
  std::vector<float> values(pixel_count * count);
  context.read(planes, values.data(), values.size() * sizeof(float), first * pixel_count * sizeof(float));
  return values;
}

void Film::read(uint32_t layer, float *out) const {
  if (layer == TYN_LAYER_VARIANCE)
    return read_variance(out);
  if (layer == TYN_LAYER_DEPTH)
    return read_depth(out);
  const std::vector<uint32_t> sources = stored_planes(layer);
  for (size_t channel = 0; channel < sources.size(); channel++) {
    const std::vector<float> values = plane(sources[channel]);
    for (size_t i = 0; i < pixel_count; i++)
      out[i * sources.size() + channel] = values[i];
  }
}

void Film::read_variance(float *out) const {
  const std::vector<float> samples = plane(TYN_PLANE_SAMPLES);
  for (uint32_t channel = 0; channel < 3; channel++) {
    const std::vector<float> spread = plane(TYN_PLANE_SPREAD + channel);
    for (size_t i = 0; i < pixel_count; i++) {
      const float n = samples[i];
      out[3 * i + channel] = n < 2 ? 0.0f : spread[i] / (n - 1) / n;
    }
  }
}

void Film::read_depth(float *out) const {
  const std::vector<float> depth = plane(TYN_PLANE_DEPTH), hits = plane(TYN_PLANE_HITS);
  for (size_t i = 0; i < pixel_count; i++)
    out[i] = hits[i] > 0 ? depth[i] : std::numeric_limits<float>::infinity();
}

double Film::error() const {
  const std::vector<float> beauty = plane(TYN_PLANE_BEAUTY, 3);
  const std::vector<float> spread = plane(TYN_PLANE_LUMINANCE), samples = plane(TYN_PLANE_SAMPLES);
  std::vector<double> luminance(pixel_count);
  double mean = 0;
  for (size_t i = 0; i < pixel_count; i++) {
    if (samples[i] < 2)
      return 0;
    luminance[i] = 0.2126 * double(beauty[i]) + 0.7152 * double(beauty[pixel_count + i]) +
                   0.0722 * double(beauty[2 * pixel_count + i]);
    mean += luminance[i] / double(pixel_count);
  }
  if (!(mean > 0))
    return 0; // a black image is exact
  double sum = 0;
  for (size_t i = 0; i < pixel_count; i++) {
    const double n = double(samples[i]);
    const double standard_error = std::sqrt(std::max(0.0, double(spread[i])) / (n - 1) / n);
    sum += standard_error / (luminance[i] + 0.01 * mean);
  }
  return sum / double(pixel_count);
}

} // namespace tyn
