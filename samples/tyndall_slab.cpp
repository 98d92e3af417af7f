// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
//
// tyndall-slab: Monte Carlo light transport in layered slabs and half-spaces.
#include "common/interrupt.hpp"
#include "common/outputs.hpp"
#include "slab/files.hpp"
#include "slab/outputs.hpp"
#include "slab/run.hpp"
#include "slab/stack.hpp"

namespace {

using namespace slab;
using tool::check;

constexpr const char *kName = "tyndall-slab";

void write_outputs(const Arguments &arguments, const Results &results) {
  if (!arguments.csv.empty())
    tool::write_file(arguments.csv, to_csv(arguments, results), kUnwritable);
  if (!arguments.plot.empty())
    tool::write_file(arguments.plot, tool::draw_png(to_figure(arguments, results)), kUnwritable);
  if (arguments.json)
    tool::print_json(to_json(kName, arguments, results));
  else if (!arguments.quiet)
    print_text(arguments, results);
}

int body(int argc, char **argv) {
  Arguments arguments;
  if (!parse_arguments(kName, argc, argv, arguments))
    return tool::kOk;
  check_writable(arguments);
  const Stack stack(arguments);
  std::vector<TynAddingDoublingResult> exact;
  if (arguments.exact) // before the photons: what it refuses should not cost an hour
    exact = solve_exactly(stack.slab(), arguments);
  const tool::Context context = tool::create_context(arguments.device);
  Results results;
  check(tyn_context_device(context.get(), &results.device), context.get());
  results.names = channel_names(arguments);
  tool::catch_interrupt();
  simulate(kName, context.get(), stack.slab(), stack.options(), arguments, results);
  for (size_t c = 0; c < exact.size(); ++c)
    results.channels[c].exact = exact[c];
  write_outputs(arguments, results);
  return results.interrupted ? tool::kInterrupted : tool::kOk;
}

} // namespace

int main(int argc, char **argv) { return tool::run(kName, argc, argv, body); }
