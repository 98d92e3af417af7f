// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// tyn_slab_simulate: batches of photons until a limit is reached.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>

#include "core/argument.hpp"
#include "core/context.hpp"
#include "slab/options.hpp"
#include "slab/batches.hpp"
#include "slab/tallies.hpp"

namespace tyn {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

// How many photons the next batch has: a function of what is asked for and of what is done, never of time or of the device, so
// that where batches end is reproducible. A standard error needs some tens of them. They grow with the run, since small ones
// are less efficient; they are larger where there are many tallies to go through after each, and smaller where many channels
// make a round of them long.
uint32_t batch_size(uint64_t asked, uint32_t tallies, size_t channels, uint64_t done) {
  const uint64_t least = std::max<uint64_t>(512 / channels, 64);
  const uint64_t first = std::clamp<uint64_t>(4 * uint64_t(tallies), least, TYN_SLAB_BATCH);
  uint64_t size = asked ? std::clamp<uint64_t>(asked / 64, 1, first) : first;
  while (size < TYN_SLAB_BATCH && size * 64 <= done)
    size *= 2;
  return uint32_t(std::min<uint64_t>(size, TYN_SLAB_BATCH));
}

class Run {
public:
  Run(TynContext &context, const Slab &slab_, const TynSlabOptions &options_)
      : slab(slab_), options(options_), engine(context, slab, options),
        cores(std::max(1u, context.device_info.compute_units)) {
    for (uint32_t c = 0; c < slab.channels; ++c)
      channels.emplace_back(slab, c, options, engine.parameters(), engine.specular());
  }

  // Returns whether the caller cancelled.
  bool run() {
    const Clock::time_point building = Clock::now();
    engine.prepare();
    build_seconds = seconds_since(building);
    start = Clock::now();
    do {
      launch();
      if (options.progress && options.progress(options.user, fraction()) != 0 && !finished())
        return true;
    } while (!finished());
    return false;
  }

  std::unique_ptr<TynSlabResult> result() const {
    auto result = std::make_unique<TynSlabResult>();
    TynSlabRun &run = result->run;
    run.size = sizeof run;
    run.photons = done;
    run.seconds = seconds_since(start);
    run.build_seconds = build_seconds;
    run.seed = options.seed;
    run.channel_count = slab.channels;
    run.layer_count = uint32_t(slab.layers.size());
    for (const Estimates &channel : channels) {
      run.events += channel.events();
      result->channels.push_back(channel.result());
    }
    return result;
  }

private:
  // The error is trusted from some batches on.
  static constexpr uint64_t trusted_batches = 16;
  // Between two looks at the clock and at the caller's wishes.
  static constexpr double launch_seconds = 0.05;

  // Some batches of every channel.
  void launch() {
    const Clock::time_point begin = Clock::now();
    const uint32_t size = batch_size(options.photons, engine.parameters().tally_count, channels.size(), done);
    const uint64_t left = options.photons ? options.photons - done : UINT64_MAX;
    const uint64_t before_growth = size < TYN_SLAB_BATCH && size * 64ull > done ? size * 64ull - done : UINT64_MAX;
    const double fitting = std::clamp(photons_at_once / size, double(cores), 1024.0);
    const uint32_t most = std::clamp(engine.most_batches() / uint32_t(channels.size()), 1u, uint32_t(fitting));
    const uint64_t wanted = std::min({uint64_t(size) * most, left, round_up(before_growth, size)});
    const auto photons = uint32_t(wanted);
    std::vector<std::vector<int64_t>> tallies;
    for (size_t c = 0; c < channels.size(); ++c) {
      const int64_t *walked = engine.walk(c, done, photons, size);
      tallies.emplace_back(walked, walked + uint64_t(engine.parameters().tally_count) * ((photons + size - 1) / size));
    }
    add_batches(tallies, photons, size);
    const double seconds = std::max(seconds_since(begin), 1e-6);
    photons_at_once = photons * launch_seconds / seconds;
  }

  static uint64_t round_up(uint64_t value, uint64_t step) {
    return value > UINT64_MAX - step ? value : (value + step - 1) / step * step;
  }

  // One after the other, so that a target error ends the run at the same batch whatever was walked at once.
  void add_batches(const std::vector<std::vector<int64_t>> &tallies, uint32_t photons, uint32_t size) {
    for (uint32_t first = 0, batch = 0; first < photons && !reached(); first += size, ++batch) {
      const uint32_t count = std::min(size, photons - first);
      for (size_t c = 0; c < channels.size(); ++c)
        channels[c].add(tallies[c].data() + size_t(batch) * engine.parameters().tally_count, count);
      done += count;
      ++batches;
    }
  }

  bool reached() const {
    return options.target_error > 0 && batches >= trusted_batches && error() <= options.target_error;
  }

  double error() const {
    double largest = 0;
    for (const Estimates &channel : channels)
      largest = std::max(largest, channel.error());
    return largest;
  }

  bool finished() const {
    if (options.photons && done >= options.photons)
      return true;
    if (options.seconds > 0 && seconds_since(start) >= options.seconds)
      return true;
    return reached();
  }

  // How far along the limit is that will end the run.
  double fraction() const {
    double largest = 0;
    if (options.photons)
      largest = double(done) / double(options.photons);
    if (options.seconds > 0)
      largest = std::max(largest, seconds_since(start) / options.seconds);
    const double now = options.target_error > 0 && batches > 1 ? error() : 0;
    if (now > 0) // it falls with the square root of the number of photons
      largest = std::max(largest, options.target_error * options.target_error / (now * now));
    return std::min(largest, 1.0);
  }

  const Slab &slab;
  const TynSlabOptions &options;
  BatchEngine engine;
  std::vector<Estimates> channels;
  Clock::time_point start;
  double build_seconds = 0;
  uint64_t done = 0;
  uint64_t batches = 0;
  const uint32_t cores;
  double photons_at_once = 0; // what a launch of that time walks; how large a batch is changes meanwhile
};

} // namespace

} // namespace tyn

extern "C" TynStatus tyn_slab_simulate(TynContext *context, const TynSlab *slab, const TynSlabOptions *options,
                                       TynSlabResult **result) {
  if (result)
    *result = nullptr;
  if (!context)
    return TYN_ERROR_INVALID_ARGUMENT;
  return tyn::guarded(context, [&] {
    tyn::require_pointer("result", result);
    const tyn::Slab checked = tyn::read_slab(slab);
    const TynSlabOptions asked = tyn::read_slab_options(options, checked);
    tyn::Run run(*context, checked, asked);
    const bool cancelled = run.run();
    *result = run.result().release();
    if (cancelled)
      tyn::fail(TYN_ERROR_CANCELLED, "cancelled by the progress callback");
  });
}
