// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "slab/escapes.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "media/phase.hpp"

namespace tyn {
namespace {

constexpr int PER_OCTAVE = 8;
constexpr uint32_t FIRST_ORDER = TYN_ESCAPE_FIRST_ORDER;
constexpr double FEWEST_ORDERS = 256; // in units of 1 / (1 - g): then light has long been diffuse
constexpr double NEAREST = 1.0 / 256; // in mean free paths
constexpr double FARTHEST = 128;      // in reduced ones
constexpr int STAGES = 3;             // each follows walks over 1 / 8 of the orders of the one before
constexpr uint32_t TRIAL = 4096;      // walks that tell how many events a walk has
constexpr double PROMPT = 2e8;        // scattering events of a launch
constexpr uint32_t BATCH = TYN_SLAB_BATCH;

uint32_t number_of(double x) {
  const auto value = float(x);
  uint32_t bits;
  static_assert(sizeof bits == sizeof value, "");
  std::memcpy(&bits, &value, sizeof bits);
  return bits >> TYN_ESCAPE_SHIFT;
}

Slab white_half_space(const TynPhase &phase, double ior) {
  Slab slab;
  slab.channels = 1;
  slab.layers.push_back({{0.0}, {1.0}, phase, std::max(ior, 1.0), double(INFINITY)});
  slab.ior_above = std::max(1 / ior, 1.0);
  slab.ior_below = 1;
  return slab;
}

// Walks over orders below 2^octaves.
class Stage {
public:
  Stage(TynContext &context, const Slab &slab, int octaves_, const EscapeGrid &whole, uint64_t seed)
      : octaves(octaves_), grid{uint32_t(octaves * PER_OCTAVE), whole.first_radius, whole.radii},
        engine(context, slab, options(octaves, seed), &grid), counts(grid.cells()) {
    engine.prepare();
  }

  void walk(uint32_t count) {
    const int64_t *tallies = engine.walk(0, walked, count, BATCH);
    for (uint32_t batch = 0; batch * BATCH < count; ++batch, tallies += engine.parameters().tally_count) {
      events += uint64_t(tallies[TYN_SLAB_TALLY_EVENTS]);
      for (size_t i = 0; i < counts.size(); ++i)
        counts[i] += uint64_t(tallies[engine.parameters().escapes + i]);
    }
    walked += count;
  }

  uint32_t most_at_once() const { return engine.most_batches() * BATCH; }

  // Adds what was counted to that of all stages.
  void add_to(Escapes &all) const {
    for (uint32_t order = 0; order < grid.orders; ++order)
      all.walks[order] += walked;
    uint64_t back = 0;
    for (size_t i = 0; i < counts.size(); ++i) {
      all.counts[i] += counts[i];
      back += counts[i];
    }
    if (grid.orders == all.grid.orders)
      all.left = walked - back;
  }

  uint64_t walked = 0, events = 0;

private:
  static TynSlabOptions options(int octaves, uint64_t seed) {
    TynSlabOptions options = tyn_slab_options();
    options.max_order = (1u << octaves) - 1;
    options.seed = seed;
    return options;
  }

  const int octaves;
  const EscapeGrid grid;
  BatchEngine engine;
  std::vector<uint64_t> counts;
};

struct Watch {
  const EscapeOptions &options;
  double before; // fraction of all work that the stages before have done

  void report(double fraction) const {
    if (options.progress && options.progress(options.user, before + fraction / STAGES) != 0)
      fail(TYN_ERROR_CANCELLED, "cancelled by the progress callback");
  }
};

// The number of walks is set by those of a trial, so that it does not depend on the machine.
void walk_stage(Stage &stage, uint64_t events, uint32_t at_once, const Watch &watch) {
  stage.walk(TRIAL);
  const double each = double(std::max<uint64_t>(stage.events, 1)) / TRIAL;
  const auto wanted = uint64_t(std::max(double(events) / each, double(TRIAL)));
  const auto prompt = uint64_t(std::max(PROMPT / each, 1.0)); // so that a caller need not wait long to cancel
  while (stage.walked < wanted) {
    stage.walk(uint32_t(std::min<uint64_t>({wanted - stage.walked, stage.most_at_once(), at_once, prompt})));
    watch.report(double(stage.walked) / double(wanted));
  }
}

} // namespace

double escape_border(uint32_t number) {
  return std::ldexp(double(PER_OCTAVE + number % PER_OCTAVE), int(number / PER_OCTAVE) - 127 - 3);
}

EscapeGrid escape_grid(double mean_cosine) {
  const double path = 1 / std::min(1 - mean_cosine, 1.0); // reduced, in mean free paths
  EscapeGrid grid;
  grid.orders = uint32_t(std::ceil(std::log2(FEWEST_ORDERS * path))) * PER_OCTAVE;
  grid.first_radius = number_of(NEAREST);
  grid.radii = number_of(FARTHEST * path) - grid.first_radius + 1;
  return grid;
}

Escapes count_escapes(TynContext &context, const TynPhase &phase, double ior, const EscapeOptions &options) {
  Escapes all;
  all.grid = escape_grid(phase_mean_cosine(phase));
  const int octaves = int(all.grid.orders) / PER_OCTAVE;
  all.walks.resize(all.grid.orders);
  all.counts.resize(all.grid.cells());
  const Slab slab = white_half_space(phase, ior);
  const uint32_t at_once = BATCH * std::max(2u, 2 * context.device_info.compute_units);
  for (int i = 0; i < STAGES; ++i) {
    Stage stage(context, slab, octaves - 3 * i, all.grid, options.seed + uint64_t(i));
    walk_stage(stage, options.events / STAGES, at_once, {options, double(i) / STAGES});
    stage.add_to(all);
  }
  return all;
}

} // namespace tyn
