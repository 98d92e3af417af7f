// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// tyn_slab_simulate: rounds of photons until a limit is reached.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>

#include "core/argument.hpp"
#include "core/context.hpp"
#include "media/phase.hpp"
#include "slab/options.hpp"
#include "slab/round.hpp"
#include "slab/tallies.hpp"

namespace tyn {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

// How many photons the next round has: a function of what was asked for and what is done, never of time, so that where the
// rounds end is reproducible. A standard error needs some tens of them; they grow with the run, so that a long one is not made
// of a million.
uint64_t round_size(uint64_t asked, uint64_t done) {
  const uint64_t first = asked ? std::clamp<uint64_t>(asked / 64, 1, 8192) : 8192;
  uint64_t size = first;
  while (size < TYN_SLAB_ROUND && size * 64 <= done)
    size *= 2;
  size = std::min<uint64_t>(size, TYN_SLAB_ROUND);
  return asked ? std::min(size, asked - done) : size;
}

class Run {
public:
  Run(TynContext &context, const Slab &slab_, const TynSlabOptions &options_)
      : slab(slab_), options(options_), engine(context, slab, options) {
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
      const uint64_t photons = round_size(options.photons, done);
      for (size_t c = 0; c < channels.size(); ++c)
        channels[c].add(engine.walk(c, done, uint32_t(photons)), photons);
      done += photons;
      ++rounds;
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
  // The error is trusted from some rounds on.
  static constexpr uint32_t trusted_rounds = 16;

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
    return options.target_error > 0 && rounds >= trusted_rounds && error() <= options.target_error;
  }

  // How far along the limit is that will end the run.
  double fraction() const {
    double largest = 0;
    if (options.photons)
      largest = double(done) / double(options.photons);
    if (options.seconds > 0)
      largest = std::max(largest, seconds_since(start) / options.seconds);
    const double now = options.target_error > 0 && rounds > 1 ? error() : 0;
    if (now > 0) // it falls with the square root of the number of photons
      largest = std::max(largest, options.target_error * options.target_error / (now * now));
    return std::min(largest, 1.0);
  }

  const Slab &slab;
  const TynSlabOptions &options;
  RoundEngine engine;
  std::vector<Estimates> channels;
  Clock::time_point start;
  double build_seconds = 0;
  uint64_t done = 0;
  uint32_t rounds = 0;
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
