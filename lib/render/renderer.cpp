// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "render/renderer.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "render/camera.hpp"
#include "render/wavefront.hpp"

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

// Sample counts at which the error is looked at, whatever the passes: so that where a render stops does not depend on the
// machine's speed. 16, then in steps of a quarter of the power of two below.
uint32_t next_check(uint32_t samples) {
  if (samples < 16)
    return 16;
  uint32_t power = 16;
  while (power <= samples / 2)
    power *= 2;
  return (samples / (power / 4) + 1) * (power / 4);
}

bool is_check(uint32_t samples) { return samples >= 16 && next_check(samples - 1) == samples; }

// Paths of the next pass: so many that a pass takes about half a second, for progress and cancelling, and no longer than
// there is time.
size_t adapt(size_t paths, double pass_seconds, double seconds_left, size_t capacity) {
  if (pass_seconds < 0.25)
    paths *= 2;
  else if (pass_seconds > 1 || pass_seconds > seconds_left)
    paths /= 2;
  return std::clamp<size_t>(paths, std::min<size_t>(4096, capacity), capacity);
}

} // namespace

TynRenderer::TynRenderer(TynScene &owner, const TynRenderOptions &given, uint32_t how)
    : scene(owner), options(given), largest_pass(tyn::Wavefront::preferred_capacity(owner.context)),
      film(owner.context, given.width, given.height), strategy(how), tables(tyn::make_tables(owner, how)),
      camera(tyn::camera_record(given.camera, given.width, given.height)) {
  scene.retain();
}

TynRenderer::~TynRenderer() = default;

void TynRenderer::retain() { references.fetch_add(1, std::memory_order_relaxed); }

void TynRenderer::release() {
  if (references.fetch_sub(1, std::memory_order_acq_rel) != 1)
    return;
  TynScene &kept = scene; // its context must outlive the buffers
  delete this;
  kept.release();
}

TynRenderParameters TynRenderer::parameters() const {
  TynRenderParameters p{};
  p.seed[0] = uint32_t(options.seed);
  p.seed[1] = uint32_t(options.seed >> 32);
  p.width = options.width;
  p.height = options.height;
  p.max_bounces = options.max_bounces;
  p.exit = options.exit;
  p.strategy = strategy;
  p.emitter_count = tables.emitter_count;
  std::copy(scene.environment.radiance, scene.environment.radiance + 3, p.environment);
  p.environment_image = scene.environment.image;
  p.environment_cos = float(std::cos(double(scene.environment.rotation)));
  p.environment_sin = float(std::sin(double(scene.environment.rotation)));
  p.environment_probability = tables.environment_probability;
  p.environment_hidden = scene.environment.hidden_from_camera;
  return p;
}

void TynRenderer::run(const TynRenderBudget &budget) {
  if (options.bssrdf != TYN_NONE && !bssrdf)
    bssrdf = std::make_unique<tyn::BssrdfWalks>(scene, options.bssrdf, budget.progress, budget.user);
  const Clock::time_point start = Clock::now();
  const double seconds_before = seconds;
  const uint64_t pixels = film.pixels();
  const uint32_t first = samples;
  const uint32_t goal =
      budget.samples ? uint32_t(std::min<uint64_t>(uint64_t(first) + budget.samples, UINT32_MAX)) : UINT32_MAX;
  const uint64_t useful = std::min<uint64_t>(pixels * (goal - first), largest_pass);
  tyn::Wavefront wavefront(scene, tables, size_t(useful), bssrdf.get());
  size_t paths = std::min<size_t>(wavefront.capacity(), 1 << 15);
  double error = 0;
  double elapsed = 0;

  const auto fraction = [&] {
    const double done = double(samples - first) + double(next_pixel) / double(pixels);
    double most = budget.samples ? done / budget.samples : 0;
    if (budget.seconds > 0)
      most = std::max(most, elapsed / budget.seconds);
    if (budget.target_error > 0 && error > 0) // the error falls with the square root of the samples
      most = std::max(most, std::pow(budget.target_error / error, 2));
    return std::min(most, 1.0);
  };
  const auto report = [&] {
    elapsed = seconds_since(start);
    seconds = seconds_before + elapsed;
    if (budget.progress && budget.progress(budget.user, fraction()) != 0)
      tyn::fail(TYN_ERROR_CANCELLED, "cancelled at %u samples a pixel", samples);
  };

  report();
  // a call that ended where a check was due may have left a film that is good enough
  if (budget.target_error > 0 && next_pixel == 0 && is_check(samples) && film.error() <= budget.target_error)
    return;
  while (samples < goal) {
    TynRenderParameters pass = parameters();
    uint32_t stop = budget.target_error > 0 ? std::min(goal, next_check(samples)) : goal;
    // the first sample of every pixel comes alone: a preview
    if (samples == 0)
      stop = 1;
    pass.first_sample = samples;
    pass.first_pixel = uint32_t(next_pixel);
    if (next_pixel > 0 || paths < 2 * pixels) {
      pass.pixel_count = uint32_t(std::min<uint64_t>(paths, pixels - next_pixel));
      pass.sample_count = 1;
    } else {
      pass.pixel_count = uint32_t(pixels);
      pass.sample_count = uint32_t(std::min<uint64_t>(paths / pixels, stop - samples));
    }
    const Clock::time_point pass_start = Clock::now();
    nonfinite_paths += wavefront.trace(pass, camera, film, ledger, times);
    next_pixel += pass.pixel_count;
    if (next_pixel == pixels) {
      next_pixel = 0;
      samples += pass.sample_count;
    }
    const double seconds_left = budget.seconds > 0 ? budget.seconds - seconds_since(start) : 1e9;
    paths = adapt(paths, seconds_since(pass_start), seconds_left, wavefront.capacity());

    const bool check = budget.target_error > 0 && next_pixel == 0 && is_check(samples);
    if (check)
      error = film.error();
    report();
    if (check && error <= budget.target_error)
      break;
    // every pixel has a sample before time counts, so that the film shows something everywhere
    if (budget.seconds > 0 && elapsed >= budget.seconds && samples > 0)
      break;
  }
}

TynRenderStats TynRenderer::stats() const {
  TynRenderStats s{};
  s.width = options.width;
  s.height = options.height;
  s.samples = samples;
  s.seconds = seconds;
  s.error = film.error();
  s.paths = uint64_t(samples) * film.pixels() + next_pixel;
  s.nonfinite_paths = nonfinite_paths;
  s.seed = options.seed;
  s.ledger = ledger.value();
  times.write(s);
  return s;
}
