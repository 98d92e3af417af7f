// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The image as it grows: planes of floats on the device (TYN_PLANE_* of kernels/shared_render.h).
#pragma once

#include <vector>

#include "kernels/shared_render.h"
#include "core/context.hpp"

namespace tyn {

class Film {
public:
  Film(TynContext &context, uint32_t width, uint32_t height); // all zero

  const Buffer &buffer() const { return planes; }
  size_t pixels() const { return pixel_count; }
  // Writes pixels() x tyn_layer_channels(layer) floats.
  void read(uint32_t layer, float *out) const;
  // TynRenderBudget::target_error's measure; 0 before every pixel has two samples.
  double error() const;

private:
  std::vector<float> plane(uint32_t first, uint32_t count = 1) const;
  void read_variance(float *out) const;
  void read_depth(float *out) const;

  TynContext &context;
  size_t pixel_count;
  Buffer planes;
};

} // namespace tyn
