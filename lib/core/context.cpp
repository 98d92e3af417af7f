// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The life of a context. Kernels and copies are in commands.cpp, the C calls in context_api.cpp.
#include "core/context.hpp"

#include <algorithm>
#include <cstdlib>

#include "core/device.hpp"
#include "core/opencl.hpp"
#include "core/program.hpp"

namespace {

uint32_t choose_lanes(uint32_t wanted, uint32_t by_device) {
  switch (wanted) {
  case 0:
    return by_device;
  case 1:
  case 4:
  case 8:
  case 16:
    return wanted;
  default:
    tyn::fail(TYN_ERROR_INVALID_ARGUMENT, "TynContextOptions::lane_width is %u; allowed: 0, 1, 4, 8, 16", wanted);
  }
}

// PoCL keeps a disk cache of its own, down to the machine code, and asking it for a binary makes it
// compile every kernel once more. So programs go to ours only for those who name a folder.
bool keeps_programs(const char *wanted, cl_device_id device) {
  return wanted || std::getenv("TYNDALL_CACHE_DIR") || !tyn::is_pocl(device);
}

template <class T>
T queue_value(cl_command_queue queue, cl_command_queue_info parameter) {
  T value{};
  tyn::check_cl(clGetCommandQueueInfo(queue, parameter, sizeof value, &value, nullptr), "clGetCommandQueueInfo");
  return value;
}

} // namespace

TynContext::TynContext() = default;

TynContext::~TynContext() {
  if (queue)
    clFinish(queue);
  for (const auto &entry : kernels)
    clReleaseKernel(entry.second);
  programs.clear();
  if (queue)
    clReleaseCommandQueue(queue);
  if (cl)
    clReleaseContext(cl);
}

TynContext *TynContext::create(const TynContextOptions &options) {
  const char *wanted = options.device && options.device[0] ? options.device : std::getenv("TYNDALL_DEVICE");
  const std::vector<tyn::Device> devices = tyn::list_devices();
  const tyn::Device &chosen = tyn::choose_device(devices, wanted);

  std::unique_ptr<TynContext, void (*)(TynContext *)> context(new TynContext, [](TynContext *c) { delete c; });
  context->device = chosen.id;
  context->setup(options);
  cl_int code = CL_SUCCESS;
  context->cl = clCreateContext(nullptr, 1, &chosen.id, nullptr, nullptr, &code);
  tyn::check_cl(code, "clCreateContext", chosen.info.name);
  context->queue = clCreateCommandQueue(context->cl, chosen.id, CL_QUEUE_PROFILING_ENABLE, &code);
  tyn::check_cl(code, "clCreateCommandQueue", chosen.info.name);
  return context.release();
}

TynContext *TynContext::create(const TynContextOptions &options, cl_context cl, cl_command_queue queue) {
  if (!cl)
    tyn::fail(TYN_ERROR_INVALID_ARGUMENT, "the cl_context is NULL");
  if (!queue)
    tyn::fail(TYN_ERROR_INVALID_ARGUMENT, "the cl_command_queue is NULL");
  if (queue_value<cl_context>(queue, CL_QUEUE_CONTEXT) != cl)
    tyn::fail(TYN_ERROR_INVALID_ARGUMENT, "the cl_command_queue belongs to another cl_context");
  const auto properties = queue_value<cl_command_queue_properties>(queue, CL_QUEUE_PROPERTIES);
  if (properties & CL_QUEUE_OUT_OF_ORDER_EXEC_MODE_ENABLE)
    tyn::fail(TYN_ERROR_INVALID_ARGUMENT, "the cl_command_queue is out of order; only in-order queues are supported");

  std::unique_ptr<TynContext, void (*)(TynContext *)> context(new TynContext, [](TynContext *c) { delete c; });
  context->device = queue_value<cl_device_id>(queue, CL_QUEUE_DEVICE);
  context->setup(options);
  tyn::check_cl(clRetainContext(cl), "clRetainContext");
  context->cl = cl;
  tyn::check_cl(clRetainCommandQueue(queue), "clRetainCommandQueue");
  context->queue = queue;
  return context.release();
}

void TynContext::setup(const TynContextOptions &options) {
  device_info = tyn::describe_device(device);
  device_info.lane_width = choose_lanes(options.lane_width, device_info.lane_width);
  memory_limit = device_info.memory;
  if (options.memory_limit)
    memory_limit = std::min<uint64_t>(memory_limit, options.memory_limit);
  cache_directory = options.cache_directory ? options.cache_directory : tyn::environment_cache_directory();
  if (keeps_programs(options.cache_directory, device))
    program_cache = cache_directory;
}

void TynContext::retain() { references.fetch_add(1, std::memory_order_relaxed); }

void TynContext::release() {
  if (references.fetch_sub(1, std::memory_order_acq_rel) == 1)
    delete this;
}

uint64_t TynContext::memory_available() const { return memory_limit > memory_used ? memory_limit - memory_used : 0; }

uint64_t TynContext::largest_buffer() const {
  const auto largest = tyn::device_value<cl_ulong>(device, CL_DEVICE_MAX_MEM_ALLOC_SIZE);
  return std::min<uint64_t>(largest, memory_available());
}

void TynContext::set_message(const char *text) noexcept {
  try {
    message = text;
  } catch (...) {
    message.clear();
  }
}

TynStatus tyn::translate_exception(TynContext *context) noexcept {
  const auto report = [context](const char *text) {
    if (context)
      context->set_message(text);
  };
  try {
    throw;
  } catch (const Failure &failure) {
    report(failure.what());
    return failure.status;
  } catch (const std::bad_alloc &) {
    report("out of host memory");
    return TYN_ERROR_OUT_OF_MEMORY;
  } catch (const std::exception &error) {
    report(error.what());
    return TYN_ERROR_INTERNAL;
  } catch (...) {
    report("unknown exception");
    return TYN_ERROR_INTERNAL;
  }
}
