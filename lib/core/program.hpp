// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// A compiled OpenCL program, from the disk cache or from source.
#pragma once

#include <string>

#include "core/cache.hpp"
#include "core/kernels.hpp"
#include "tyndall/tyndall_cl.h"

namespace tyn {

// The embedded program called `name`. Throws INTERNAL if there is none.
const KernelSource &find_source(const char *name);

// The options that every program is built with.
std::string build_options(const TynDeviceInfo &device, cl_device_id id);

// Whether the platform is PoCL: it compiles a kernel when it is first launched with a local size,
// not when its program is built, and it keeps what it compiled in a disk cache of its own.
bool is_pocl(cl_device_id device);

class Program {
public:
  // Throws KERNEL_BUILD with device, options and build log. `cache_directory`: "" for no cache.
  Program(cl_context cl, cl_device_id target, const KernelSource &source, const std::string &options,
          const std::string &cache_directory);
  Program(const Program &) = delete;
  Program &operator=(const Program &) = delete;
  // Stores what was compiled since.
  ~Program();

  cl_program get() const { return program; }
  bool from_cache() const { return loaded_size != 0; }

private:
  bool load(cl_context cl, const std::string &options);
  void compile(cl_context cl, const KernelSource &source, const std::string &options);
  void store() noexcept;

  cl_device_id device;
  cl_program program = nullptr;
  std::string key;
  std::string path;       // in the cache; "": no cache
  size_t loaded_size = 0; // of the binary that came from the cache
};

} // namespace tyn
