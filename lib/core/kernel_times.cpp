// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "core/kernel_times.hpp"

namespace tyn {

KernelTimes::KernelTimes(TynContext &owner) : context(owner) {
  cl_command_queue_properties properties = 0;
  if (clGetCommandQueueInfo(context.queue, CL_QUEUE_PROPERTIES, sizeof properties, &properties, nullptr) == CL_SUCCESS)
    measuring = (properties & CL_QUEUE_PROFILING_ENABLE) != 0;
  if (measuring)
    context.times = this;
}

KernelTimes::~KernelTimes() {
  if (measuring)
    context.times = nullptr;
  for (const Launch &launch : launches)
    if (launch.second)
      clReleaseEvent(launch.second);
}

double KernelTimes::seconds(const Launch &launch) {
  cl_ulong start = 0, end = 0; // nanoseconds
  if (clGetEventProfilingInfo(launch.second, CL_PROFILING_COMMAND_START, sizeof start, &start, nullptr) != CL_SUCCESS ||
      clGetEventProfilingInfo(launch.second, CL_PROFILING_COMMAND_END, sizeof end, &end, nullptr) != CL_SUCCESS ||
      end < start)
    return -1;
  return 1e-9 * double(end - start);
}

} // namespace tyn
