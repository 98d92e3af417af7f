// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Walks in one mesh, by the library and plainly over Embree, timed in turns.
#pragma once

#include <cmath>
#include <memory>
#include <vector>

#include "bench/walk/cases.hpp"
#include "common/plain_walk.hpp"
#include "core/context.hpp"
#include "tyndall/tyndall.hpp"

namespace bench {

struct Rate {
  tyn_test::WalkSums sums;    // of all runs, each with walks of its own
  tyn_test::WalkSums fastest; // of the fastest run: others may use the machine
  double seconds = 0;         // of the fastest run

  void add(const tyn_test::WalkSums &run, double run_seconds);
  double scatterings_per_second() const { return fastest.scatterings / seconds; }
  double walks_per_second() const { return fastest.walks / seconds; }
  double scatterings_per_walk() const { return sums.scatterings / sums.walks; }
  double rays_per_scattering() const { return sums.rays / sums.scatterings; }
  // Variance of a mean escaped weight that took a second: smaller is better.
  double variance_seconds() const { return sums.variance() / walks_per_second(); }
};

struct Result {
  Case what;
  Rate ours, plain;

  double ratio() const { return ours.scatterings_per_second() / plain.scatterings_per_second(); }
  // The plain walk traces every flight.
  double free_flights() const { return 1 - ours.rays_per_scattering() / plain.rays_per_scattering(); }
  // Difference of the mean escaped weights, in standard errors of it.
  double disagreement() const;
};

// A commit, and what it makes for rays: the tree, its local roots, the grid of distance bounds, the horizons.
struct Build {
  std::string mesh;
  float width = 0;
  uint32_t triangles = 0;
  double seconds = INFINITY, bytes = 0;
};

// Median time of tyn_walk with one entry, once warm.
struct OneWalk {
  Case what;
  double seconds;
};

// Scatterings per second of walks whose entries say more than their mesh, over those of walks that leave all to one medium:
struct Overrides {
  Case what;
  double same_values;   // entries with the medium's own albedo and extinction
  double own_values;    // entries with coloured albedos and extinctions around them
  double several_media; // entries of all media of the scene in turns, over as many walks in a batch a medium
};

struct Effort {
  int repetitions;
  double seconds; // that one repetition should take, of each
};

class MeshBench {
public:
  // One scene with all media of `cases`, which are of one mesh and one width.
  MeshBench(const tyndall::Context &context, const std::vector<Case> &cases);

  Build build(int repetitions) const;
  Result measure(const Case &what, const Effort &effort);
  OneWalk time_one_walk(const Case &what);
  Overrides measure_overrides(const Case &what, const Effort &effort);

private:
  // Adds the media and the mesh, and commits, which takes as many seconds as it returns.
  double fill(tyndall::Scene &filled) const;
  std::vector<TynWalkEntry> spread_entries(const Case &what, size_t count) const;
  void run(const std::vector<TynWalkEntry> &walked, Rate &rate);
  void run_plainly(const Case &what, const std::vector<TynWalkEntry> &walked, Rate &rate);

  std::vector<Case> cases;
  tyn_test::MeshData mesh;
  tyndall::Context context;
  tyndall::Scene scene;
  std::unique_ptr<tyn_test::EmbreeOracle> oracle;
  std::unique_ptr<tyn_test::PlainWalk> plain;
  std::vector<TynWalkEntry> entries;
  tyn::Buffer entry_buffer, exits, tallies;
  uint64_t next_path = 0, next_plain_path = 0; // no two runs have random numbers in common
};

} // namespace bench
