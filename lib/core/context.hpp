// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// A device, its queue, its programs and its memory budget. Knows nothing of light.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/status.hpp"
#include "tyndall/tyndall_cl.h"

namespace tyn {

// A device buffer whose size is counted against the context's memory limit. Move-only.
class Buffer {
public:
  Buffer() = default;
  Buffer(TynContext &owner, size_t wanted, cl_mem_flags flags = CL_MEM_READ_WRITE, const void *initial = nullptr);
  Buffer(Buffer &&other) noexcept;
  Buffer &operator=(Buffer &&other) noexcept;
  Buffer(const Buffer &) = delete;
  Buffer &operator=(const Buffer &) = delete;
  ~Buffer();

  cl_mem get() const { return mem; }
  // What was asked for; a buffer of 0 bytes holds a dummy so that kernels can take it.
  size_t size() const { return bytes; }
  explicit operator bool() const { return mem != nullptr; }

private:
  // Outlives the buffer: whoever owns buffers holds a reference to the context.
  TynContext *context = nullptr;
  cl_mem mem = nullptr;
  size_t bytes = 0;
};

// Local memory for a kernel argument.
struct Local {
  size_t bytes;
};

class KernelTimes;
class Program;
struct KernelSource;

} // namespace tyn

struct TynContext {
  // Throws tyn::Failure. The second one works on the caller's objects, which it retains.
  static TynContext *create(const TynContextOptions &options);
  static TynContext *create(const TynContextOptions &options, cl_context cl, cl_command_queue queue);
  void retain();
  void release();

  // Enqueues kernel `name` of program `program` (kernels/<program>.cl), built on first use, over
  // `global` work-items in groups of `local` (otherwise global is rounded up, and the kernel must
  // check its index). 0 leaves the choice to the context, which never rounds up; a fixed size is
  // better: PoCL compiles a kernel anew for each local size. Arguments are scalars and shared
  // structs by value, tyn::Buffer, cl_mem, or tyn::Local.
  template <class... Arguments>
  void launch(const char *program, const char *name, size_t global, size_t local, const Arguments &...arguments) {
    cl_kernel kernel = find_kernel(program, name);
    cl_uint index = 0;
    (set_argument(kernel, index++, arguments), ...);
    enqueue(kernel, name, global, local);
  }

  // Blocking copies between host and device. bytes == 0 is allowed.
  void read(const tyn::Buffer &buffer, void *host, size_t bytes, size_t offset = 0) {
    read(buffer.get(), host, bytes, offset);
  }
  void read(cl_mem buffer, void *host, size_t bytes, size_t offset = 0);
  void write(const tyn::Buffer &buffer, const void *host, size_t bytes, size_t offset = 0);
  void fill_zero(const tyn::Buffer &buffer);
  void flush();
  void finish();

  // Bytes that may still be allocated under the memory limit, and the largest single buffer.
  uint64_t memory_available() const;
  uint64_t largest_buffer() const;
  // Of what is kept between runs beside compiled programs; "": nothing is.
  const std::string &cache_folder() const { return cache_directory; }
  bool is_gpu() const { return device_info.is_gpu != 0; }
  uint32_t lanes() const { return device_info.lane_width; }

  // Compiles a program now, before it is needed. On PoCL this is only the smaller part: see
  // core/program.hpp.
  void build(const char *program);
  // The same for a source that is not embedded, such as a test's; launch finds it by its name from
  // then on.
  void build(const tyn::KernelSource &source);
  // Whether a program, which must have been built, came from the disk cache.
  bool from_cache(const char *program) const;

  // Never throws; without memory for `text` the message is empty.
  void set_message(const char *text) noexcept;

  TynDeviceInfo device_info{};
  std::string message;
  cl_context cl = nullptr;
  cl_command_queue queue = nullptr;
  cl_device_id device = nullptr;

  uint64_t memory_limit = 0; // bytes; never more than the device has
  uint64_t memory_used = 0;  // by tyn::Buffer

  tyn::KernelTimes *times = nullptr; // what measures the launches, if anything; it sets and resets this

private:
  TynContext();
  ~TynContext();
  void setup(const TynContextOptions &options);
  tyn::Program &find_program(const char *program);
  tyn::Program &add_program(const tyn::KernelSource &source);
  cl_kernel find_kernel(const char *program, const char *name);
  void enqueue(cl_kernel kernel, const char *name, size_t global, size_t local);
  void set_argument_bytes(cl_kernel kernel, cl_uint index, size_t size, const void *value);
  void set_argument(cl_kernel kernel, cl_uint index, const tyn::Buffer &buffer) {
    cl_mem mem = buffer.get();
    set_argument_bytes(kernel, index, sizeof mem, &mem);
  }
  void set_argument(cl_kernel kernel, cl_uint index, const tyn::Local &local) {
    set_argument_bytes(kernel, index, local.bytes, nullptr);
  }
  template <class T>
  void set_argument(cl_kernel kernel, cl_uint index, const T &value) {
    static_assert(std::is_trivially_copyable<T>::value, "kernel arguments are plain data");
    set_argument_bytes(kernel, index, sizeof value, &value);
  }

  std::atomic<uint32_t> references{1};
  std::string cache_directory; // "": no cache
  std::string program_cache;   // the same, of compiled programs
  std::map<std::string, std::unique_ptr<tyn::Program>> programs;
  std::map<std::pair<std::string, std::string>, cl_kernel> kernels;
};

namespace tyn {

// The status of the exception being handled; its text becomes the message of `context`, if there is
// one.
TynStatus translate_exception(TynContext *context) noexcept;

// Runs `body` at the C boundary: exceptions become a status and, if there is a context, its
// message.
template <class Body>
TynStatus guarded(TynContext *context, Body &&body) {
  try {
    body();
    return TYN_OK;
  } catch (...) {
    return translate_exception(context);
  }
}

} // namespace tyn
