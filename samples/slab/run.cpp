// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "slab/run.hpp"

#include "common/call_progress.hpp"

namespace slab {

void simulate(const char *tool_name, TynContext *context, const TynSlab &slab, TynSlabOptions options, bool quiet,
              Results &results) {
  TynSlabResult *handle = nullptr;
  TynStatus status = TYN_OK;
  {
    tool::CallProgress progress(tool_name, quiet);
    options.progress = &tool::CallProgress::report;
    options.user = &progress;
    status = tyn_slab_simulate(context, &slab, &options, &handle);
  }
  const ResultHandle owner(handle);
  results.interrupted = status == TYN_ERROR_CANCELLED;
  if (!results.interrupted)
    tool::check(status, context, status == TYN_ERROR_INVALID_ARGUMENT ? tool::kUsage : tool::kFailed);
  read_results(handle, results);
}

} // namespace slab
