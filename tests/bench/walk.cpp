// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Walks in generated meshes beside the same walks written plainly over Embree's single rays, on as many threads, in turns, in
// one process: speed of both, and whether they agree.
#include <cstdio>
#include <exception>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "bench/walk/report.hpp"

namespace {

using namespace bench;

struct Options {
  Axes axes;
  Effort effort = {3, 0.5};
  bool chosen = false; // by --all or a filter
  bool json = false, one_walk = false, overrides = false;
};

// Exit status to end with, or -1 to go on.
int parse(int argc, char **argv, Options &options) {
  CLI::App app("Walks in meshes: the library beside the same walk over Embree's single rays, in one run. Without --all "
               "or a filter: few cases, in some two minutes.\n");
  Axes &axes = options.axes;
  bool all = false;
  app.add_flag("--all", all, "every mesh with every medium");
  std::vector<CLI::Option *> filters = {
      app.add_option("--mesh", axes.meshes, "only these meshes")->check(CLI::IsMember(mesh_names())),
      app.add_option("--width", axes.widths, "only so many mean free paths across the mesh")
          ->check(CLI::PositiveNumber),
      app.add_option("--g", axes.gs, "only these mean cosines")->check(CLI::Range(-0.99, 0.99)),
      app.add_option("--ior", axes.iors, "only these indices of refraction")->check(CLI::Range(1.0, 4.0)),
      app.add_option("--albedo", axes.albedos, "only these albedos of a scattering")->check(CLI::Range(0.0, 1.0))};
  app.add_option("--repetitions", options.effort.repetitions, "of which the fastest counts")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--seconds", options.effort.seconds, "that a repetition of either walk should take")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_flag("--batch1", options.one_walk, "instead: the median time of tyn_walk with one entry, for each case");
  app.add_flag(
      "--overrides", options.overrides,
      "instead: the speed with colours, radii and media that the entries give, over that without, for each case");
  app.add_flag("--json", options.json, "print one JSON document");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError &error) {
    return app.exit(error);
  }
  options.chosen = all;
  for (const CLI::Option *filter : filters)
    options.chosen |= filter->count() > 0;
  return -1;
}

// By mesh and width: what a commit makes depends on the mean free path.
using Benches = std::map<std::pair<std::string, float>, std::unique_ptr<MeshBench>>;

// All of them at once, so that the meshes can take turns.
Benches make_benches(const tyndall::Context &context, const std::vector<Case> &cases) {
  std::map<std::pair<std::string, float>, std::vector<Case>> by_scene;
  for (const Case &c : cases)
    by_scene[{c.mesh, c.width}].push_back(c);
  Benches benches;
  for (const auto &[mesh_and_width, its_cases] : by_scene)
    benches[mesh_and_width] = std::make_unique<MeshBench>(context, its_cases);
  return benches;
}

void measure(const Benches &benches, const std::vector<Case> &cases, const Options &options, Results &results) {
  if (!options.json)
    print_header(results.device);
  for (const auto &[mesh_and_width, bench] : benches) {
    results.builds.push_back(bench->build(options.effort.repetitions));
    if (!options.json)
      print(results.builds.back());
  }
  if (!options.json)
    print_columns();
  for (const Case &c : cases) {
    results.cases.push_back(benches.at({c.mesh, c.width})->measure(c, options.effort));
    if (!options.json)
      print(results.cases.back());
    warn(results.cases.back());
  }
  if (!options.json)
    print_summary(results);
}

void time_one_walk(const Benches &benches, const std::vector<Case> &cases, const Options &options, Results &results) {
  for (const Case &c : cases) {
    results.one_walks.push_back(benches.at({c.mesh, c.width})->time_one_walk(c));
    if (!options.json)
      print(results.one_walks.back());
  }
}

void measure_overrides(const Benches &benches, const std::vector<Case> &cases, const Options &options,
                       Results &results) {
  for (const Case &c : cases) {
    results.overrides.push_back(benches.at({c.mesh, c.width})->measure_overrides(c, options.effort));
    if (!options.json)
      print(results.overrides.back());
  }
}

void run(const Options &options) {
  tyndall::Context context;
  Results results;
  context.check(tyn_context_device(context.get(), &results.device));
  const std::vector<Case> cases = options.chosen ? all_cases(options.axes) : few_cases();
  const Benches benches = make_benches(context, cases);
  (options.one_walk    ? time_one_walk
   : options.overrides ? measure_overrides
                       : measure)(benches, cases, options, results);
  if (options.json)
    print_json(results);
}

} // namespace

int main(int argc, char **argv) {
  Options options;
  int status = parse(argc, argv, options);
  if (status >= 0)
    return status;
  try {
    run(options);
    return 0;
  } catch (const std::exception &error) {
    std::fprintf(stderr, "bench-walk: %s\n", error.what());
    return 1;
  }
}
