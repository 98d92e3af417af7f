// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// What a context does on its queue: kernels and copies.
#include "core/context.hpp"
#include "core/kernel_times.hpp"
#include "core/opencl.hpp"
#include "core/program.hpp"

namespace {

constexpr size_t largest_chosen_local = 64;

// A local size that divides `global`. Few different ones, because PoCL compiles a kernel anew for
// each.
size_t choose_local(size_t global) {
  size_t local = largest_chosen_local;
  while (global % local != 0)
    local /= 2;
  return local;
}

size_t round_up(size_t value, size_t step) { return (value + step - 1) / step * step; }

void require_inside(const tyn::Buffer &buffer, size_t bytes, size_t offset) {
  if (bytes > buffer.size() || offset > buffer.size() - bytes)
    tyn::fail(TYN_ERROR_INTERNAL, "%zu bytes at %zu reach beyond a buffer of %zu bytes", bytes, offset, buffer.size());
}

} // namespace

tyn::Program &TynContext::find_program(const char *program) {
  const auto found = programs.find(program);
  return found != programs.end() ? *found->second : add_program(tyn::find_source(program));
}

tyn::Program &TynContext::add_program(const tyn::KernelSource &source) {
  auto program =
      std::make_unique<tyn::Program>(cl, device, source, tyn::build_options(device_info, device), program_cache);
  return *(programs[source.name] = std::move(program));
}

cl_kernel TynContext::find_kernel(const char *program, const char *name) {
  std::pair<std::string, std::string> key(program, name);
  const auto found = kernels.find(key);
  if (found != kernels.end())
    return found->second;
  cl_int code = CL_SUCCESS;
  cl_kernel kernel = clCreateKernel(find_program(program).get(), name, &code);
  tyn::check_cl(code, "clCreateKernel", key.first + "/" + key.second);
  try {
    kernels.emplace(std::move(key), kernel);
  } catch (...) {
    clReleaseKernel(kernel);
    throw;
  }
  return kernel;
}

void TynContext::build(const char *program) { find_program(program); }

void TynContext::build(const tyn::KernelSource &source) { add_program(source); }

bool TynContext::from_cache(const char *program) const {
  const auto found = programs.find(program);
  return found != programs.end() && found->second->from_cache();
}

void TynContext::set_argument_bytes(cl_kernel kernel, cl_uint index, size_t size, const void *value) {
  tyn::check_cl(clSetKernelArg(kernel, index, size, value), "clSetKernelArg", tyn::format("argument %u", index));
}

void TynContext::enqueue(cl_kernel kernel, const char *name, size_t global, size_t local) {
  if (global == 0)
    return;
  if (local == 0 && !is_gpu())
    local = choose_local(global);
  if (local != 0)
    global = round_up(global, local);
  cl_event *event = times ? times->next(name) : nullptr;
  tyn::check_cl(clEnqueueNDRangeKernel(queue, kernel, 1, nullptr, &global, local ? &local : nullptr, 0, nullptr, event),
                "clEnqueueNDRangeKernel", name);
}

void TynContext::read(cl_mem buffer, void *host, size_t bytes, size_t offset) {
  if (bytes == 0)
    return;
  tyn::check_cl(clEnqueueReadBuffer(queue, buffer, CL_TRUE, offset, bytes, host, 0, nullptr, nullptr),
                "clEnqueueReadBuffer", tyn::format("%zu bytes", bytes));
}

void TynContext::write(const tyn::Buffer &buffer, const void *host, size_t bytes, size_t offset) {
  require_inside(buffer, bytes, offset);
  if (bytes == 0)
    return;
  tyn::check_cl(clEnqueueWriteBuffer(queue, buffer.get(), CL_TRUE, offset, bytes, host, 0, nullptr, nullptr),
                "clEnqueueWriteBuffer", tyn::format("%zu bytes", bytes));
}

void TynContext::fill_zero(const tyn::Buffer &buffer) {
  if (buffer.size() == 0)
    return;
  const cl_uint zero = 0;
  const size_t pattern = buffer.size() % sizeof zero == 0 ? sizeof zero : 1;
  tyn::check_cl(clEnqueueFillBuffer(queue, buffer.get(), &zero, pattern, 0, buffer.size(), 0, nullptr, nullptr),
                "clEnqueueFillBuffer", tyn::format("%zu bytes", buffer.size()));
}

void TynContext::flush() { tyn::check_cl(clFlush(queue), "clFlush"); }

void TynContext::finish() { tyn::check_cl(clFinish(queue), "clFinish"); }
