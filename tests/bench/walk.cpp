// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Walks inside a mesh: scattering events a second, and the ratio to the same walks with one lane a work-item. Argument: mean
// free paths in the radius of the sphere.
#include <benchmark/benchmark.h>

#include <chrono>
#include <vector>

#include "common/meshes.hpp"
#include "tyndall/tyndall.hpp"

namespace {

// A sphere of scattering medium, albedo 0.99, walked from entries spread over its triangles.
class Bench {
public:
  Bench(uint32_t lanes, float mean_free_paths) : context(options(lanes)), scene(context) {
    TynMedium medium = tyn_medium();
    for (int c = 0; c < 3; ++c) {
      medium.sigma_s[c] = 0.99f * mean_free_paths;
      medium.sigma_a[c] = 0.01f * mean_free_paths;
    }
    tyn_test::MeshData mesh = tyn_test::icosphere(6);
    TynMesh view = mesh.view();
    context.check(tyn_scene_add_medium(scene.get(), &medium, &view.medium));
    context.check(tyn_scene_add_mesh(scene.get(), &view, nullptr));
    context.check(tyn_scene_commit(scene.get()));
    entries.resize(1 << 15);
    exits.resize(entries.size());
    for (size_t i = 0; i < entries.size(); ++i)
      entries[i] = entry(mesh, uint32_t(i * 7919 % mesh.triangle_count()));
    run(); // warm
  }

  double run() {
    auto start = std::chrono::steady_clock::now();
    context.check(tyn_walk(scene.get(), nullptr, entries.data(), entries.size(), exits.data(), &ledger));
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }

  TynLedger ledger{};

private:
  static TynContextOptions options(uint32_t lanes) {
    TynContextOptions options = tyn_context_options();
    options.lane_width = lanes;
    return options;
  }

  static TynWalkEntry entry(const tyn_test::MeshData &mesh, uint32_t triangle) {
    TynWalkEntry entry{};
    for (int i = 0; i < 3; ++i) {
      for (int corner = 0; corner < 3; ++corner)
        entry.position[i] += mesh.positions[3 * mesh.indices[3 * triangle + corner] + i] / 3;
      entry.weight[i] = 1;
    }
    entry.kind = TYN_ENTRY_COSINE;
    entry.triangle = triangle;
    entry.medium = TYN_NONE;
    entry.albedo[0] = entry.sigma_t[0] = -1;
    return entry;
  }

  tyndall::Context context;
  tyndall::Scene scene;
  std::vector<TynWalkEntry> entries;
  std::vector<TynWalkExit> exits;
};

void walk_in_sphere(benchmark::State &state) {
  Bench wide(0, float(state.range(0)));
  Bench narrow(1, float(state.range(0)));
  double wide_seconds = 0, narrow_seconds = 0;
  for (auto _ : state) {
    wide_seconds += wide.run();
    narrow_seconds += narrow.run();
  }
  double events = double(wide.ledger.scatterings) * double(state.iterations());
  state.counters["events/s"] = events / wide_seconds;
  state.counters["events/walk"] = double(wide.ledger.scatterings) / double(wide.ledger.walks);
  state.counters["ratio_to_one_lane"] = narrow_seconds / wide_seconds;
}

BENCHMARK(walk_in_sphere)->Arg(1)->Arg(10)->Arg(100)->Iterations(4)->Unit(benchmark::kMillisecond);

} // namespace

BENCHMARK_MAIN();
