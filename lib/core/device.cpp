// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "core/device.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <mutex>
#include <cstring>

#include "core/opencl.hpp"
#include "core/status.hpp"

namespace tyn {
namespace {

template <size_t capacity>
void copy_text(char (&target)[capacity], const std::string &text) {
  const size_t length = std::min(text.size(), capacity - 1);
  std::memcpy(target, text.data(), length);
  target[length] = '\0';
}

// Lanes that fill the device's registers. A GPU makes its own of work-items.
uint32_t default_lanes(cl_device_id device, bool is_gpu) {
  if (is_gpu)
    return 1;
  const auto width = device_value<cl_uint>(device, CL_DEVICE_NATIVE_VECTOR_WIDTH_FLOAT);
  return width >= 16 ? 16 : width >= 8 ? 8 : 4;
}

std::vector<cl_platform_id> list_platforms() {
  cl_uint count = 0;
  // Without any driver the loader answers an error instead of 0.
  if (clGetPlatformIDs(0, nullptr, &count) != CL_SUCCESS || count == 0)
    return {};
  std::vector<cl_platform_id> platforms(count);
  if (clGetPlatformIDs(count, platforms.data(), nullptr) != CL_SUCCESS)
    return {};
  return platforms;
}

std::vector<cl_device_id> platform_devices(cl_platform_id platform) {
  cl_uint count = 0;
  if (clGetDeviceIDs(platform, CL_DEVICE_TYPE_ALL, 0, nullptr, &count) != CL_SUCCESS || count == 0)
    return {};
  std::vector<cl_device_id> ids(count);
  if (clGetDeviceIDs(platform, CL_DEVICE_TYPE_ALL, count, ids.data(), nullptr) != CL_SUCCESS)
    return {};
  return ids;
}

bool is_usable(cl_device_id id) {
  return device_value<cl_bool>(id, CL_DEVICE_AVAILABLE) && device_value<cl_bool>(id, CL_DEVICE_COMPILER_AVAILABLE);
}

// GPUs first, then CPUs, then what is neither.
int rank(const Device &device) {
  if (device.info.is_gpu)
    return 0;
  return device_value<cl_device_type>(device.id, CL_DEVICE_TYPE) & CL_DEVICE_TYPE_CPU ? 1 : 2;
}

std::string lower(std::string text) {
  for (char &c : text)
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

bool matches(const Device &device, const std::string &part) {
  return lower(device.info.name).find(part) != std::string::npos ||
         lower(device.info.platform).find(part) != std::string::npos;
}

// The index that `text` spells, or `none`.
size_t parse_index(const std::string &text, size_t none) {
  if (text.empty() || text.size() > 6 ||
      !std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isdigit(c) != 0; }))
    return none;
  return static_cast<size_t>(std::strtoul(text.c_str(), nullptr, 10));
}

std::string list_text(const std::vector<Device> &devices) {
  std::string text;
  for (size_t i = 0; i < devices.size(); ++i)
    text += format("%s%zu: %s (%s)", i ? ", " : "", i, devices[i].info.name, devices[i].info.platform);
  return text;
}

} // namespace

TynDeviceInfo describe_device(cl_device_id device) {
  TynDeviceInfo info{};
  const auto platform = device_value<cl_platform_id>(device, CL_DEVICE_PLATFORM);
  const auto type = device_value<cl_device_type>(device, CL_DEVICE_TYPE);
  copy_text(info.name, device_text(device, CL_DEVICE_NAME));
  copy_text(info.platform, platform_text(platform, CL_PLATFORM_NAME));
  copy_text(info.driver, device_text(device, CL_DRIVER_VERSION));
  // A simulator may claim to be both.
  info.is_gpu = (type & CL_DEVICE_TYPE_GPU) && !(type & CL_DEVICE_TYPE_CPU) ? 1 : 0;
  info.compute_units = device_value<cl_uint>(device, CL_DEVICE_MAX_COMPUTE_UNITS);
  info.memory = device_value<cl_ulong>(device, CL_DEVICE_GLOBAL_MEM_SIZE);
  info.lane_width = default_lanes(device, info.is_gpu != 0);
  return info;
}

std::vector<Device> list_devices() {
  // The first call loads the drivers, which neither ocl-icd nor PoCL 3.1 guards: two threads that make their first contexts
  // at the same time must not both be here.
  static std::mutex loading;
  const std::lock_guard<std::mutex> lock(loading);
  std::vector<Device> devices;
  for (cl_platform_id platform : list_platforms()) {
    for (cl_device_id id : platform_devices(platform)) {
      try {
        if (is_usable(id))
          devices.push_back({id, describe_device(id)});
      } catch (const Failure &) {
        // A driver that cannot describe its device must not hide the others.
      }
    }
  }
  std::stable_sort(devices.begin(), devices.end(), [](const Device &a, const Device &b) { return rank(a) < rank(b); });
  return devices;
}

const Device &choose_device(const std::vector<Device> &devices, const char *wanted) {
  if (devices.empty())
    fail(TYN_ERROR_NO_DEVICE,
         "no OpenCL device was found; install an OpenCL driver, e.g. PoCL for the CPU "
         "(Debian and Ubuntu: apt install pocl-opencl-icd); PoCL also needs a cache folder that can "
         "be written (POCL_CACHE_DIR, XDG_CACHE_HOME or HOME)");
  const std::string text = wanted ? wanted : "";
  const size_t index = parse_index(text, devices.size());
  if (index < devices.size())
    return devices[index];
  for (const Device &device : devices)
    if (matches(device, lower(text)))
      return device;
  fail(TYN_ERROR_NO_DEVICE, "no OpenCL device matches \"%s\"; there are: %s", text.c_str(), list_text(devices).c_str());
}

} // namespace tyn
