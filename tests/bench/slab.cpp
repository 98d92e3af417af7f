// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The slab engine beside a plain scalar C walk (tests/common/plain_slab.c) on one core, in turns, in one process: scattering
// events a second of both, and their ratio.
#include <benchmark/benchmark.h>

#include <chrono>
#include <memory>

#include "common/plain_slab.h"
#include "tyndall/tyndall.hpp"

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

struct Rate {
  double events = 0, seconds = 0;
  double rate() const { return events / seconds; }
};

class Bench {
public:
  Bench(const PlainSlab &medium_, bool resolved_) : medium(medium_), resolved(resolved_) {
    layer.sigma_a = &medium.sigma_a;
    layer.sigma_s = &medium.sigma_s;
    layer.g = medium.g;
    layer.ior = medium.ior;
    slab.layers = &layer;
    slab.layer_count = 1;
    if (resolved) {
      options.radial_max = options.depth_max = options.path_max = 2;
      options.radial_bins = PLAIN_RINGS;
      options.angular_bins = PLAIN_ANGLES;
      options.radial_angular = 1;
      options.depth_bins = PLAIN_DEPTHS;
      options.path_bins = PLAIN_PATHS;
      options.order_bins = PLAIN_ORDERS;
    }
    run(1000); // warm
  }

  void run(uint64_t photons) {
    options.photons = photons;
    TynSlabResult *result = nullptr;
    const Clock::time_point start = Clock::now();
    context.check(tyn_slab_simulate(context.get(), &slab, &options, &result));
    ours.seconds += seconds_since(start);
    TynSlabRun done{};
    done.size = sizeof done;
    tyn_slab_result_run(result, &done);
    ours.events += double(done.events);
    tyn_slab_result_release(result);
    ++options.seed;
  }

  void run_plain(uint64_t photons) {
    const Clock::time_point start = Clock::now();
    plain_slab(&medium, photons, options.seed, resolved, tallies.get());
    plain.seconds += seconds_since(start);
    plain.events += double(tallies->events);
  }

  Rate ours, plain;

private:
  PlainSlab medium;
  bool resolved;
  tyndall::Context context;
  TynSlabLayer layer = tyn_slab_layer();
  TynSlab slab = tyn_slab();
  TynSlabOptions options = tyn_slab_options();
  std::unique_ptr<PlainTallies> tallies = std::make_unique<PlainTallies>();
};

void compare(benchmark::State &state, const PlainSlab &medium, bool resolved) {
  Bench bench(medium, resolved);
  bench.ours = Rate();
  for (auto _ : state) {
    bench.run(1 << 23);
    bench.run_plain(1 << 17);
  }
  state.counters["events/s"] = bench.ours.rate();
  state.counters["plain events/s"] = bench.plain.rate();
  state.counters["ratio"] = bench.ours.rate() / bench.plain.rate();
}

const PlainSlab matched = {1, 9, 0, 1}, bright = {1, 99, 0, 1}, dielectric = {1, 9, 0.75, 1.5};

BENCHMARK_CAPTURE(compare, matched_half_space_totals, matched, false)->UseRealTime();
BENCHMARK_CAPTURE(compare, bright_half_space_totals, bright, false)->UseRealTime();
BENCHMARK_CAPTURE(compare, dielectric_hg_totals, dielectric, false)->UseRealTime();
BENCHMARK_CAPTURE(compare, dielectric_hg_everything, dielectric, true)->UseRealTime();

} // namespace

BENCHMARK_MAIN();
