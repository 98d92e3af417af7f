// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The batch calls: host pointers in batches that fit the device, and the caller's buffers.
#include <algorithm>
#include <vector>

#include "core/batch.hpp"
#include "core/buffer_argument.hpp"
#include "tyndall/tyndall_cl.h"
#include "walk/walk.hpp"

namespace tyn {

namespace {

// Between two batches progress is reported and the caller may cancel.
constexpr size_t largest_batch = 1 << 17;
constexpr size_t bytes_per_walk = sizeof(TynWalkEntry) + sizeof(TynWalkExit) + sizeof(TynWalkTally);

void add_path_offset(TynWalkParameters &parameters, uint64_t first_path) {
  parameters.first_path[0] = static_cast<uint32_t>(first_path);
  parameters.first_path[1] = static_cast<uint32_t>(first_path >> 32);
}

void walk_on_host(TynScene &scene, const TynWalkOptions &options, const TynWalkEntry *entries, size_t count,
                  TynWalkExit *exits, TynLedger &ledger) {
  TynContext &context = scene.context;
  size_t batch = batch_size(context, count, largest_batch, bytes_per_walk, sizeof(TynWalkEntry), "walk");
  Buffer entry_buffer(context, batch * sizeof(TynWalkEntry), CL_MEM_READ_ONLY);
  Buffer exit_buffer(context, batch * sizeof(TynWalkExit));
  Buffer tally_buffer(context, batch * sizeof(TynWalkTally));
  std::vector<TynWalkTally> tallies(batch);
  TynWalkParameters parameters = walk_parameters(scene, options);
  parameters.callers_winding = 1;
  for (size_t begin = 0; begin < count; begin += batch) {
    if (options.progress && options.progress(options.user, double(begin) / double(count)) != 0)
      fail(TYN_ERROR_CANCELLED, "cancelled after %zu of %zu walks", begin, count);
    size_t n = std::min(batch, count - begin);
    add_path_offset(parameters, options.first_path + begin);
    parameters.count = static_cast<uint32_t>(n);
    context.write(entry_buffer, entries + begin, n * sizeof(TynWalkEntry));
    enqueue_walk(scene, parameters, entry_buffer.get(), exit_buffer.get(), tally_buffer.get());
    context.read(exit_buffer, exits + begin, n * sizeof(TynWalkExit));
    context.read(tally_buffer, tallies.data(), n * sizeof(TynWalkTally));
    add_to_ledger(ledger, entries + begin, exits + begin, tallies.data(), n);
  }
  if (options.progress)
    options.progress(options.user, 1.0);
}

void walk_on_device(TynScene &scene, const TynWalkOptions &options, cl_mem entries, size_t count, cl_mem exits,
                    TynLedger *ledger) {
  if (count > UINT32_MAX)
    fail(TYN_ERROR_INVALID_ARGUMENT, "count is %zu; it must be at most %u", count, UINT32_MAX);
  TynContext &context = scene.context;
  require_buffer(context, "entries", entries, count, sizeof(TynWalkEntry));
  require_buffer(context, "exits", exits, count, sizeof(TynWalkExit));
  TynWalkParameters parameters = walk_parameters(scene, options);
  parameters.callers_winding = 1;
  parameters.count = static_cast<uint32_t>(count);
  // OpenCL keeps the buffer alive until the kernel is done, also after it is released here
  Buffer tallies(context, count * sizeof(TynWalkTally));
  enqueue_walk(scene, parameters, entries, exits, tallies.get());
  context.flush();
  if (!ledger)
    return;
  std::vector<TynWalkEntry> host_entries(count);
  std::vector<TynWalkExit> host_exits(count);
  std::vector<TynWalkTally> host_tallies(count);
  context.read(entries, host_entries.data(), count * sizeof(TynWalkEntry));
  context.read(exits, host_exits.data(), count * sizeof(TynWalkExit));
  context.read(tallies, host_tallies.data(), count * sizeof(TynWalkTally));
  add_to_ledger(*ledger, host_entries.data(), host_exits.data(), host_tallies.data(), count);
}

} // namespace

} // namespace tyn

TynStatus tyn_walk(TynScene *scene, const TynWalkOptions *options, const TynWalkEntry *entries, size_t count,
                   TynWalkExit *exits, TynLedger *ledger) {
  if (!scene)
    return TYN_ERROR_INVALID_ARGUMENT;
  return tyn::guarded(&scene->context, [&] {
    scene->require_committed();
    TynWalkOptions checked = tyn::checked_options(options);
    if (count > 0) {
      tyn::require_pointer("entries", entries);
      tyn::require_pointer("exits", exits);
    }
    tyn::validate_entries(*scene, entries, count);
    TynLedger sums{};
    TynLedger &target = ledger ? *ledger : sums;
    target = sums;
    if (count > 0)
      tyn::walk_on_host(*scene, checked, entries, count, exits, target);
  });
}

TynStatus tyn_walk_cl(TynScene *scene, const TynWalkOptions *options, cl_mem entries, size_t count, cl_mem exits,
                      TynLedger *ledger) {
  if (!scene)
    return TYN_ERROR_INVALID_ARGUMENT;
  return tyn::guarded(&scene->context, [&] {
    scene->require_committed();
    TynWalkOptions checked = tyn::checked_options(options);
    if (ledger)
      *ledger = TynLedger{};
    if (count > 0)
      tyn::walk_on_device(*scene, checked, entries, count, exits, ledger);
  });
}
