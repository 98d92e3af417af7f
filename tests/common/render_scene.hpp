// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Renders for tests: cameras, a renderer with its layers, and estimates over its film.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/handles.hpp"
#include "kernels/shared_render.h"
#include "lib/render/renderer.hpp"

namespace tyn_test {

// A camera at `from` that looks at `to`; `up` must not be along the view.
TynCamera look_at(const double (&from)[3], const double (&to)[3], const double (&up)[3], double yfov);
// The same without perspective, `ymag` half the height of the view.
TynCamera look_at_flat(const double (&from)[3], const double (&to)[3], const double (&up)[3], double ymag);

TynEnvironment constant_environment(float radiance);
// A material whose interface reflects nothing: all light meets the diffuse base.
TynMaterial matte(float color);

struct Estimate {
  double mean, standard_error;
};

class Render {
public:
  explicit Render(TynScene *scene, const TynRenderOptions &options, uint32_t strategy = TYN_STRATEGY_MIS);
  ~Render() { tyn_renderer_release(handle); }
  Render(const Render &) = delete;
  Render &operator=(const Render &) = delete;
  operator TynRenderer *() const { return handle; }
  TynRenderer *operator->() const { return handle; }

  void run(uint32_t samples);
  std::vector<float> layer(uint32_t layer) const;
  TynRenderStats stats() const;
  // Mean over the film of one channel of beauty, from the pixels' own variances.
  Estimate mean(uint32_t channel = 0) const;
  std::string message() const;

private:
  TynRenderer *handle = nullptr;
};

// Options for a film of width x height pixels.
TynRenderOptions film_options(uint32_t width, uint32_t height, const TynCamera &camera);

} // namespace tyn_test
