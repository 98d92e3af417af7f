// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Walks inside a bumpy sphere of some 8e4 triangles, albedo 0.99, and the same walks written plainly over Embree's single rays
// on as many threads, and with a ray for every flight. Arguments: mean free paths in the sphere's width, and the mean cosine in percent.
#include <benchmark/benchmark.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <random>
#include <thread>
#include <vector>

#include "common/embree_oracle.hpp"
#include "common/walk_scene.hpp"
#include "scene/bvh.hpp"
#include "scene/distance_grid.hpp"
#include "walk/walk.hpp"

namespace {

using namespace tyn_test;

constexpr float ALBEDO = 0.99f, RADIUS = 1;
constexpr size_t WALKS = 1 << 15;
constexpr size_t PLAIN_WALKS = 1 << 13;

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

// Of the fastest run: others may use the machine. Every run walks the same walks.
struct Rate {
  double scatterings = 0, walks = 0, rays = 0, seconds = INFINITY;
};

class Bench {
public:
  Bench(float width, float g)
      : extinction(width / (2 * RADIUS)), cosine(g), mesh(bumpy_sphere(6, 0.2f)), context(make_context()),
        scene(make_scene(context.get(), mesh, grey_medium((1 - ALBEDO) * extinction, ALBEDO * extinction, g))),
        oracle(scene->meshes), entries(surface_entries(mesh, WALKS, 1)), entry_buffer(*context, bytes(entries)),
        exits(*context, WALKS * sizeof(TynWalkExit)), tallies(*context, WALKS * sizeof(TynWalkTally)) {
    context->write(entry_buffer, entries.data(), bytes(entries));
    Rate warm;
    run(warm);
  }

  void run(Rate &rate) {
    TynWalkParameters parameters = tyn::walk_parameters(*scene, tyn_walk_options());
    parameters.count = WALKS;
    const double start = now();
    tyn::enqueue_walk(*scene, parameters, entry_buffer.get(), exits.get(), tallies.get());
    context->finish();
    rate.seconds = std::min(rate.seconds, now() - start);
    rate.scatterings = rate.rays = 0;
    std::vector<TynWalkExit> done(WALKS);
    std::vector<TynWalkTally> tallied(WALKS);
    context->read(exits, done.data(), exits.size());
    context->read(tallies, tallied.data(), tallies.size());
    for (size_t i = 0; i < WALKS; ++i) {
      rate.scatterings += done[i].scatterings;
      rate.rays += tallied[i].rays;
    }
    rate.walks = double(WALKS);
  }

  // From now on every flight is traced.
  void forget_bounds() { context->fill_zero(scene->buffers.distances); }

  // On all cores.
  void run_plain(Rate &rate) {
    std::atomic<size_t> next{0};
    std::atomic<uint64_t> scatterings{0};
    auto work = [&] {
      uint64_t sum = 0;
      for (size_t i; (i = next++) < PLAIN_WALKS;)
        sum += walk_plainly(i * (WALKS / PLAIN_WALKS));
      scatterings += sum;
    };
    double start = now();
    std::vector<std::thread> threads(std::max(1u, std::thread::hardware_concurrency()));
    for (std::thread &thread : threads)
      thread = std::thread(work);
    for (std::thread &thread : threads)
      thread.join();
    rate.seconds = std::min(rate.seconds, now() - start);
    rate.scatterings = double(scatterings);
    rate.walks = double(PLAIN_WALKS);
  }

  // Time and bytes of what a commit makes for rays.
  void build(double &seconds, double &size) {
    double start = now();
    tyn::Bvh bvh = tyn::build_bvh(scene->meshes);
    std::vector<TynMeshRecord> records = scene->mesh_records;
    std::vector<uint8_t> codes = tyn::build_distance_grids(scene->meshes, records);
    seconds = now() - start;
    size = double(bytes(bvh.nodes) + bytes(bvh.blocks) + codes.size());
  }

private:
  template <class T>
  static size_t bytes(const std::vector<T> &values) {
    return values.size() * sizeof(T);
  }

  using Random = std::minstd_rand; // fast, so that Embree's rays are what is measured

  static float uniform(Random &random) { return (float(random() >> 7) + 0.5f) * 0x1p-24f; }

  // Turns a direction by a cosine, about itself by any angle (Duff et al. 2017, "Building an Orthonormal Basis, Revisited").
  static void turn(float (&d)[3], float mu, Random &random) {
    float phi = 6.2831853f * uniform(random), sine = std::sqrt(std::max(0.0f, 1 - mu * mu));
    float a = sine * std::cos(phi), b = sine * std::sin(phi), sign = std::copysign(1.0f, d[2]);
    float k = -1 / (sign + d[2]), m = d[0] * d[1] * k;
    float x = a * (1 + sign * d[0] * d[0] * k) + b * m + mu * d[0];
    float y = a * sign * m + b * (sign + d[1] * d[1] * k) + mu * d[1];
    float z = -a * sign * d[0] - b * d[1] + mu * d[2];
    float scale = 1 / std::sqrt(x * x + y * y + z * z);
    d[0] = x * scale, d[1] = y * scale, d[2] = z * scale;
  }

  float sample_cosine(Random &random) const {
    float u = uniform(random);
    if (cosine == 0)
      return 1 - 2 * u;
    float s = (1 - cosine * cosine) / (1 - cosine + 2 * cosine * u);
    return (1 + cosine * cosine - s * s) / (2 * cosine);
  }

  // Inwards from a triangle, by the cosine law.
  void start(const TynWalkEntry &entry, TynRay &ray, Random &random) const {
    const uint32_t *index = &mesh.indices[3 * entry.triangle];
    float e[2][3], n[3];
    for (int k = 0; k < 3; ++k)
      for (int i = 0; i < 2; ++i)
        e[i][k] = mesh.positions[3 * index[i + 1] + uint32_t(k)] - mesh.positions[3 * index[0] + uint32_t(k)];
    for (int k = 0; k < 3; ++k)
      n[k] = e[0][(k + 2) % 3] * e[1][(k + 1) % 3] - e[0][(k + 1) % 3] * e[1][(k + 2) % 3];
    float length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    for (int k = 0; k < 3; ++k) {
      ray.direction[k] = n[k] / length;
      ray.origin[k] = entry.position[k] + 1e-5f * ray.direction[k];
    }
    turn(ray.direction, std::sqrt(uniform(random)), random);
  }

  uint64_t walk_plainly(size_t i) const {
    Random random(uint32_t(i + 1) * 7919u);
    TynRay ray{};
    start(entries[i], ray, random);
    float weight = 1;
    for (uint64_t scatterings = 0;; ++scatterings) {
      ray.t_max = -std::log(uniform(random)) / extinction;
      if (oracle.intersect(ray).mesh != TYN_NONE)
        return scatterings;
      for (int k = 0; k < 3; ++k)
        ray.origin[k] += ray.t_max * ray.direction[k];
      weight *= ALBEDO;
      const float threshold = tyn_walk_options().roulette_threshold;
      if (weight < threshold) {
        if (uniform(random) * threshold >= weight)
          return scatterings + 1;
        weight = threshold;
      }
      turn(ray.direction, sample_cosine(random), random);
    }
  }

  float extinction, cosine;
  MeshData mesh;
  ContextHandle context;
  SceneHandle scene;
  EmbreeOracle oracle;
  std::vector<TynWalkEntry> entries;
  tyn::Buffer entry_buffer, exits, tallies;
};

void walk_in_bumpy_sphere(benchmark::State &state) {
  Bench bench(float(state.range(0)), 0.01f * float(state.range(1)));
  Rate rate, plain;
  for (auto _ : state) {
    bench.run(rate);
    state.PauseTiming();
    bench.run_plain(plain);
    state.ResumeTiming();
  }
  Rate traced;
  bench.forget_bounds();
  for (int i = 0; i < 3; ++i)
    bench.run(traced);
  double build_seconds = 0, build_bytes = 0;
  bench.build(build_seconds, build_bytes);
  state.counters["scatterings/s"] = rate.scatterings / rate.seconds;
  state.counters["walks/s"] = rate.walks / rate.seconds;
  state.counters["scatterings/walk"] = rate.scatterings / rate.walks;
  state.counters["plain/walk"] = plain.scatterings / plain.walks; // the same, but for noise
  state.counters["rays/scattering"] = rate.rays / rate.scatterings;
  state.counters["free"] = 1 - rate.rays / (rate.scatterings + rate.walks);
  state.counters["plain_scatterings/s"] = plain.scatterings / plain.seconds;
  state.counters["all_traced_scatterings/s"] = traced.scatterings / traced.seconds;
  state.counters["ratio_to_plain"] = rate.scatterings / rate.seconds * plain.seconds / plain.scatterings;
  state.counters["build_s"] = build_seconds;
  state.counters["build_bytes"] = build_bytes;
}

BENCHMARK(walk_in_bumpy_sphere)
    ->ArgsProduct({{20, 50, 200}, {0, 80}})
    ->Iterations(10)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

} // namespace

BENCHMARK_MAIN();
