// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "bench/walk/measure.hpp"

#include <algorithm>
#include <chrono>
#include <random>
#include <stdexcept>
#include <thread>

#include "common/walk_scene.hpp"
#include "walk/walk.hpp"

namespace bench {

namespace {

using namespace tyn_test;

constexpr size_t MOST_WALKS = 1 << 18, PILOT_WALKS = 1 << 12, PLAIN_PILOT_WALKS = 1 << 10;

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

template <class T>
size_t bytes(const std::vector<T> &values) {
  return values.size() * sizeof(T);
}

// Threads for the plain walk: as many as the device has, if it is the processor.
unsigned threads(const TynContext &context) {
  return std::max(1u, context.is_gpu() ? std::thread::hardware_concurrency() : context.device_info.compute_units);
}

// How many walks take about that long, by a run of fewer.
size_t walks_for(const Rate &pilot, double seconds) {
  double walks = pilot.walks_per_second() * seconds;
  return size_t(std::clamp(walks, double(PLAIN_PILOT_WALKS), double(MOST_WALKS)));
}

} // namespace

void Rate::add(const WalkSums &run, double run_seconds) {
  sums += run;
  if (seconds > 0 && run.scatterings / run_seconds <= scatterings_per_second())
    return;
  fastest = run;
  seconds = run_seconds;
}

double Result::disagreement() const {
  return std::fabs(ours.sums.mean() - plain.sums.mean()) /
         std::hypot(ours.sums.standard_error(), plain.sums.standard_error());
}

MeshBench::MeshBench(const tyndall::Context &context_, const std::vector<Case> &cases_)
    : cases(cases_), mesh(make_mesh(cases[0].mesh)), context(context_), scene(context),
      entries(surface_entries(mesh, MOST_WALKS, 1)), entry_buffer(*context.get(), bytes(entries)),
      exits(*context.get(), MOST_WALKS * sizeof(TynWalkExit)),
      tallies(*context.get(), MOST_WALKS * sizeof(TynWalkTally)) {
  fill(scene);
  TynMeshInfo info{};
  info.size = sizeof info;
  scene.check(tyn_scene_mesh_info(scene.get(), 0, &info));
  if (!info.closed || info.inverted_components || info.turned_triangles)
    throw std::runtime_error(cases[0].mesh + " is not closed, or not wound outwards");
  oracle = std::make_unique<EmbreeOracle>(scene.get()->meshes);
  plain = std::make_unique<PlainWalk>(mesh, *oracle);
}

double MeshBench::fill(tyndall::Scene &filled) const {
  TynMesh view = mesh.view();
  for (const Case &c : cases) {
    TynMedium medium = grey_medium((1 - c.albedo) * c.sigma_t(), c.albedo * c.sigma_t(), c.g, c.ior);
    filled.check(tyn_scene_add_medium(filled.get(), &medium, &view.medium));
  }
  filled.check(tyn_scene_add_mesh(filled.get(), &view, nullptr));
  const double start = now();
  filled.check(tyn_scene_commit(filled.get()));
  return now() - start;
}

Build MeshBench::build(int repetitions) const {
  Build result;
  result.mesh = cases[0].mesh;
  result.width = cases[0].width;
  result.triangles = mesh.triangle_count();
  const tyn::SceneBuffers &buffers = scene.get()->buffers;
  result.bytes = double(buffers.nodes.size() + buffers.blocks.size() + buffers.cells.size()) +
                 double(sizeof(TynTriangleRecord::horizon)) * result.triangles;
  for (int i = 0; i < repetitions; ++i) {
    tyndall::Scene again(context);
    result.seconds = std::min(result.seconds, fill(again));
  }
  return result;
}

// All over the surface.
std::vector<TynWalkEntry> MeshBench::spread_entries(const Case &what, size_t count) const {
  auto same = [&](const Case &other) { return other.same_medium(what); };
  const auto medium = uint32_t(std::find_if(cases.begin(), cases.end(), same) - cases.begin());
  std::vector<TynWalkEntry> result(count);
  for (size_t k = 0; k < count; ++k) {
    result[k] = entries[k * entries.size() / count];
    result[k].medium = medium;
  }
  return result;
}

void MeshBench::run(const std::vector<TynWalkEntry> &walked, Rate &rate) {
  TynContext &on = *context.get();
  TynWalkOptions options = tyn_walk_options();
  options.first_path = next_path;
  next_path += walked.size();
  TynWalkParameters parameters = tyn::walk_parameters(*scene.get(), options);
  parameters.count = uint32_t(walked.size());
  on.write(entry_buffer, walked.data(), bytes(walked));
  on.finish();
  const double start = now();
  tyn::enqueue_walk(*scene.get(), parameters, entry_buffer.get(), exits.get(), tallies.get());
  on.finish();
  const double seconds = now() - start;
  std::vector<TynWalkExit> done(walked.size());
  std::vector<TynWalkTally> tallied(walked.size());
  on.read(exits, done.data(), bytes(done));
  on.read(tallies, tallied.data(), bytes(tallied));
  WalkSums sums;
  for (size_t i = 0; i < done.size(); ++i) {
    double weight = done[i].status == TYN_WALK_ESCAPED ? double(done[i].weight[0]) : 0;
    sums += {1, double(done[i].scatterings), double(tallied[i].rays), weight, weight * weight};
  }
  rate.add(sums, seconds);
}

void MeshBench::run_plainly(const Case &what, const std::vector<TynWalkEntry> &walked, Rate &rate) {
  const double start = now();
  const WalkSums sums =
      plain->run({what.sigma_t(), what.albedo, what.g, what.ior}, walked, next_plain_path, threads(*context.get()));
  rate.add(sums, now() - start);
  next_plain_path += walked.size();
}

Result MeshBench::measure(const Case &what, const Effort &effort) {
  Result result;
  result.what = what;
  Rate pilot, plain_pilot;
  for (int k = 0; k < 2; ++k) // the first may have to compile
    run(spread_entries(what, PILOT_WALKS), pilot);
  run_plainly(what, spread_entries(what, PLAIN_PILOT_WALKS), plain_pilot);
  const std::vector<TynWalkEntry> ours = spread_entries(what, walks_for(pilot, effort.seconds));
  const std::vector<TynWalkEntry> theirs = spread_entries(what, walks_for(plain_pilot, effort.seconds));
  for (int k = 0; k < effort.repetitions; ++k) {
    run(ours, result.ours);
    run_plainly(what, theirs, result.plain);
  }
  return result;
}

OneWalk MeshBench::time_one_walk(const Case &what) {
  constexpr size_t CALLS = 501;
  const std::vector<TynWalkEntry> walked = spread_entries(what, CALLS);
  TynWalkOptions options = tyn_walk_options();
  TynWalkExit exit;
  std::vector<double> seconds(CALLS);
  for (int warm = 0; warm < 2; ++warm)
    for (size_t k = 0; k < CALLS; ++k) {
      options.first_path = k;
      const double start = now();
      scene.check(tyn_walk(scene.get(), &options, &walked[k], 1, &exit, nullptr));
      seconds[k] = now() - start;
    }
  std::nth_element(seconds.begin(), seconds.begin() + CALLS / 2, seconds.end());
  return {what, seconds[CALLS / 2]};
}

Overrides MeshBench::measure_overrides(const Case &what, const Effort &effort) {
  Rate pilot;
  for (int k = 0; k < 2; ++k) // the first may have to compile
    run(spread_entries(what, PILOT_WALKS), pilot);
  const size_t count = walks_for(pilot, effort.seconds);
  const std::vector<TynWalkEntry> as_it_is = spread_entries(what, count);
  std::vector<TynWalkEntry> same = as_it_is, own = as_it_is, several = as_it_is;
  std::mt19937 random(1);
  std::uniform_real_distribution<float> around(0.8f, 1.2f);
  for (size_t k = 0; k < count; ++k) {
    several[k].medium = uint32_t(k % cases.size());
    for (int c = 0; c < 3; ++c) {
      same[k].albedo[c] = what.albedo;
      same[k].sigma_t[c] = what.sigma_t();
      own[k].albedo[c] = 1 - (1 - what.albedo) * around(random);
      own[k].sigma_t[c] = what.sigma_t() * around(random);
    }
  }
  Rate alone, same_rate, own_rate, several_rate;
  std::vector<Rate> by_medium(cases.size());
  for (int k = 0; k < effort.repetitions; ++k) {
    run(as_it_is, alone);
    run(same, same_rate);
    run(own, own_rate);
    run(several, several_rate);
    for (size_t i = 0; i < cases.size(); ++i)
      run(spread_entries(cases[i], count / cases.size()), by_medium[i]);
  }
  WalkSums sums;
  double seconds = 0;
  for (const Rate &rate : by_medium) {
    sums += rate.fastest;
    seconds += rate.seconds;
  }
  return {what, same_rate.scatterings_per_second() / alone.scatterings_per_second(),
          own_rate.scatterings_per_second() / alone.scatterings_per_second(),
          several_rate.scatterings_per_second() / (sums.scatterings / seconds)};
}

} // namespace bench
