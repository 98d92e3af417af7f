// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
//
// tyndall-profile: profiles of BSSRDF models, and their error against exact transport.
#include "common/interrupt.hpp"
#include "common/outputs.hpp"
#include "profile/exact.hpp"
#include "profile/models.hpp"
#include "profile/outputs.hpp"
#include "slab/files.hpp"
#include "slab/results.hpp"
#include "slab/stack.hpp"

#include <cstdio>

namespace {

using namespace profile;

constexpr const char *kName = "tyndall-profile";

void write_outputs(const Arguments &arguments, const Results &results) {
  if (!arguments.csv.empty())
    tool::write_file(arguments.csv, to_csv(arguments, results), slab::kUnwritable);
  if (!arguments.plot.empty())
    tool::write_file(arguments.plot, tool::draw_png(to_figure(arguments, results)), slab::kUnwritable);
  if (arguments.json)
    tool::print_json(to_json(kName, arguments, results));
  else if (!arguments.quiet)
    print_text(arguments, results);
}

// Of a run that was interrupted.
void say_what_is_missing(const Arguments &arguments, const Results &results) {
  std::string missing;
  for (const std::string &model : results.missing)
    missing += (missing.empty() ? "the model " : " and ") + model;
  if (arguments.compare)
    missing += std::string(missing.empty() ? "" : " and ") + "the comparison of --error";
  if (!missing.empty())
    std::fprintf(stderr, "%s: interrupted: without %s\n", kName, missing.c_str());
}

int body(int argc, char **argv) {
  Arguments arguments;
  if (!parse_arguments(kName, argc, argv, arguments))
    return tool::kOk;
  slab::check_writable(arguments);
  const slab::Stack stack(arguments);
  const Rings rings = rings_around(arguments.radii, arguments.channels());
  const tool::Context context = tool::create_context(arguments.device);
  Results results;
  tool::check(tyn_context_device(context.get(), &results.device), context.get());
  results.channel_names = slab::channel_names(arguments);
  tool::catch_interrupt();
  evaluate_models(kName, context.get(), stack.slab(), arguments, arguments.compare ? &rings : nullptr, results);
  if (results.interrupted && !arguments.quiet)
    say_what_is_missing(arguments, results);
  arguments.compare = arguments.compare && !results.interrupted;
  if (arguments.compare)
    compare_with_exact(kName, context.get(), stack.slab(), arguments, rings, results);
  write_outputs(arguments, results);
  return results.interrupted ? tool::kInterrupted : tool::kOk;
}

} // namespace

int main(int argc, char **argv) { return tool::run(kName, argc, argv, body); }
