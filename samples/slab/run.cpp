// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "slab/run.hpp"

#include "common/call_progress.hpp"
#include "slab/messages.hpp"

namespace slab {

void simulate(const char *tool_name, TynContext *context, const TynSlab &slab, TynSlabOptions options,
              const Arguments &arguments, Results &results) {
  TynSlabResult *handle = nullptr;
  TynStatus status = TYN_OK;
  {
    tool::CallProgress progress(tool_name, arguments.quiet);
    options.progress = &tool::CallProgress::report;
    options.user = &progress;
    status = tyn_slab_simulate(context, &slab, &options, &handle);
  }
  const ResultHandle owner(handle);
  results.interrupted = status == TYN_ERROR_CANCELLED;
  if (status == TYN_ERROR_INVALID_ARGUMENT)
    throw tool::Error(tool::kUsage, in_options(tyn_context_message(context), arguments));
  if (!results.interrupted)
    tool::check(status, context);
  read_results(handle, results);
}

} // namespace slab
