// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// How long the device takes for the kernels that a context launches.
#pragma once

#include <utility>
#include <vector>

#include "core/context.hpp"

namespace tyn {

// Measures every kernel that its context launches as long as it exists; one a context at a time. The context's own queue
// can be measured at no cost worth naming, one of the caller's only if it was made with CL_QUEUE_PROFILING_ENABLE.
class KernelTimes {
public:
  explicit KernelTimes(TynContext &context);
  ~KernelTimes();
  KernelTimes(const KernelTimes &) = delete;
  KernelTimes &operator=(const KernelTimes &) = delete;

  // Calls take(name, seconds) for every launch so far; all of them must be done. False if they were not measured: then what
  // it was called with is worth nothing.
  template <class Take>
  bool each(Take &&take) const {
    for (const Launch &launch : launches) {
      const double taken = seconds(launch);
      if (taken < 0)
        return false;
      take(launch.first, taken);
    }
    return measuring;
  }

  // For the context: where the event of the next launch goes.
  cl_event *next(const char *name) { return &launches.emplace_back(name, nullptr).second; }

private:
  using Launch = std::pair<const char *, cl_event>; // names of kernels are literals
  static double seconds(const Launch &launch);      // < 0: unknown

  TynContext &context;
  bool measuring = false;
  std::vector<Launch> launches;
};

} // namespace tyn
