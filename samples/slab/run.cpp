// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "slab/run.hpp"

#include "common/interrupt.hpp"
#include "common/progress.hpp"

#include <optional>

namespace slab {
namespace {

struct Display {
  const char *tool_name;
  bool quiet;
  std::optional<tool::Progress> progress;
};

int32_t on_progress(void *user, double fraction) {
  tool::ProgressState state;
  state.fraction = fraction;
  // Begun here, so that compiling kernels does not count as time for photons.
  Display &display = *static_cast<Display *>(user);
  if (!display.progress)
    display.progress.emplace(display.tool_name, display.quiet);
  display.progress->update(state);
  return tool::interrupted();
}

} // namespace

void simulate(const char *tool_name, TynContext *context, const TynSlab &slab, TynSlabOptions options, bool quiet,
              Results &results) {
  Display display = {tool_name, quiet, {}};
  options.progress = on_progress;
  options.user = &display;
  TynSlabResult *handle = nullptr;
  const TynStatus status = tyn_slab_simulate(context, &slab, &options, &handle);
  const ResultHandle owner(handle);
  if (display.progress)
    display.progress->finish();
  results.interrupted = status == TYN_ERROR_CANCELLED;
  if (!results.interrupted)
    tool::check(status, context, status == TYN_ERROR_INVALID_ARGUMENT ? tool::kUsage : tool::kFailed);
  read_results(handle, results);
}

} // namespace slab
