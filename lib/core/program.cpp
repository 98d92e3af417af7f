// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "core/program.hpp"

#include <cstring>

#include "core/opencl.hpp"
#include "core/status.hpp"

namespace tyn {
namespace {

std::string build_log(cl_program program, cl_device_id device) {
  size_t size = 0;
  if (clGetProgramBuildInfo(program, device, CL_PROGRAM_BUILD_LOG, 0, nullptr, &size) != CL_SUCCESS)
    return {};
  std::string log(size, '\0');
  if (clGetProgramBuildInfo(program, device, CL_PROGRAM_BUILD_LOG, size, &log[0], nullptr) != CL_SUCCESS)
    return {};
  log.resize(std::strlen(log.c_str()));
  return log;
}

// The program's binary for its only device; empty if the driver has none to give.
Binary get_binary(cl_program program) {
  size_t size = 0;
  if (clGetProgramInfo(program, CL_PROGRAM_BINARY_SIZES, sizeof size, &size, nullptr) != CL_SUCCESS)
    return {};
  Binary binary(size);
  unsigned char *data = binary.data();
  if (size == 0 || clGetProgramInfo(program, CL_PROGRAM_BINARIES, sizeof data, &data, nullptr) != CL_SUCCESS)
    return {};
  return binary;
}

} // namespace

const KernelSource &find_source(const char *name) {
  for (size_t i = 0; i < kernel_source_count; ++i)
    if (std::strcmp(kernel_sources[i].name, name) == 0)
      return kernel_sources[i];
  fail(TYN_ERROR_INTERNAL, "there is no kernel program \"%s\"", name);
}

bool is_pocl(cl_device_id device) {
  const auto platform = device_value<cl_platform_id>(device, CL_DEVICE_PLATFORM);
  return platform_text(platform, CL_PLATFORM_NAME) == "Portable Computing Language";
}

std::string build_options(const TynDeviceInfo &device, cl_device_id id) {
  const bool has_fma = device_value<cl_device_fp_config>(id, CL_DEVICE_SINGLE_FP_CONFIG) & CL_FP_FMA;
  const bool has_prefetch = !device.is_gpu && is_pocl(id); // Clang's
  return format("-cl-std=CL1.2 -D TYN_LANES=%u%s%s%s", device.lane_width, device.is_gpu ? " -D TYN_GPU=1" : "",
                has_fma ? " -D TYN_FMA=1" : "", has_prefetch ? " -D TYN_PREFETCH=1" : "");
}

Program::Program(cl_context cl, cl_device_id target, const KernelSource &source, const std::string &options,
                 const std::string &cache_directory)
    : device(target) {
  if (!cache_directory.empty()) {
    key = cache_key(device, source.hash, source.size, options);
    path = cache_path(cache_directory, source.name, key);
    if (load(cl, options))
      return;
  }
  compile(cl, source, options);
  // PoCL's binary lacks the machine code until the kernels have been launched: it is stored at the
  // end.
  if (!path.empty() && !is_pocl(device))
    store();
}

Program::~Program() {
  if (!path.empty() && is_pocl(device))
    store();
  if (program)
    clReleaseProgram(program);
}

bool Program::load(cl_context cl, const std::string &options) {
  const Binary binary = load_binary(path, key);
  if (binary.empty())
    return false;
  const size_t size = binary.size();
  const unsigned char *data = binary.data();
  cl_int code = CL_SUCCESS;
  cl_int loaded = CL_SUCCESS;
  program = clCreateProgramWithBinary(cl, 1, &device, &size, &data, &loaded, &code);
  if (code == CL_SUCCESS && loaded == CL_SUCCESS &&
      clBuildProgram(program, 1, &device, options.c_str(), nullptr, nullptr) == CL_SUCCESS) {
    loaded_size = size;
    return true;
  }
  // The driver does not want it: compile instead.
  if (program)
    clReleaseProgram(program);
  program = nullptr;
  return false;
}

void Program::compile(cl_context cl, const KernelSource &source, const std::string &options) {
  cl_int code = CL_SUCCESS;
  program = clCreateProgramWithSource(cl, 1, const_cast<const char **>(&source.text), &source.size, &code);
  check_cl(code, "clCreateProgramWithSource", source.name);
  code = clBuildProgram(program, 1, &device, options.c_str(), nullptr, nullptr);
  if (code == CL_SUCCESS)
    return;
  const std::string log = build_log(program, device);
  clReleaseProgram(program);
  program = nullptr;
  fail(TYN_ERROR_KERNEL_BUILD, "the kernels of \"%s\" did not compile on %s with options \"%s\": %s (%d)\n%s",
       source.name, device_text(device, CL_DEVICE_NAME).c_str(), options.c_str(), cl_code_name(code), code,
       log.c_str());
}

void Program::store() noexcept {
  try {
    const Binary binary = get_binary(program);
    // PoCL adds the machine code of each new local size: only then is a loaded binary out of date.
    if (!binary.empty() && binary.size() != loaded_size)
      store_binary(path, key, binary);
  } catch (...) {
    // A cache that cannot be written costs time at the next start and nothing else.
  }
}

} // namespace tyn
