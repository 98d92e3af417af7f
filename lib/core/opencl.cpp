// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "core/opencl.hpp"

#include "core/status.hpp"

namespace tyn {
namespace {

TynStatus status_of(cl_int code) {
  switch (code) {
  case CL_MEM_OBJECT_ALLOCATION_FAILURE:
  case CL_OUT_OF_HOST_MEMORY:
    return TYN_ERROR_OUT_OF_MEMORY;
  default: // CL_OUT_OF_RESOURCES too: some drivers answer it after a kernel that crashed
    return TYN_ERROR_DEVICE;
  }
}

std::string trimmed(const std::string &text) {
  const std::string padding(" \t\r\n\0", 5);
  const size_t first = text.find_first_not_of(padding);
  if (first == std::string::npos)
    return {};
  return text.substr(first, text.find_last_not_of(padding) - first + 1);
}

} // namespace

#define TYN_CODE(name)                                                                                                 \
  case name:                                                                                                           \
    return #name

const char *cl_code_name(cl_int code) {
  switch (code) {
    TYN_CODE(CL_SUCCESS);
    TYN_CODE(CL_DEVICE_NOT_FOUND);
    TYN_CODE(CL_DEVICE_NOT_AVAILABLE);
    TYN_CODE(CL_COMPILER_NOT_AVAILABLE);
    TYN_CODE(CL_MEM_OBJECT_ALLOCATION_FAILURE);
    TYN_CODE(CL_OUT_OF_RESOURCES);
    TYN_CODE(CL_OUT_OF_HOST_MEMORY);
    TYN_CODE(CL_PROFILING_INFO_NOT_AVAILABLE);
    TYN_CODE(CL_MEM_COPY_OVERLAP);
    TYN_CODE(CL_IMAGE_FORMAT_MISMATCH);
    TYN_CODE(CL_IMAGE_FORMAT_NOT_SUPPORTED);
    TYN_CODE(CL_BUILD_PROGRAM_FAILURE);
    TYN_CODE(CL_MAP_FAILURE);
    TYN_CODE(CL_MISALIGNED_SUB_BUFFER_OFFSET);
    TYN_CODE(CL_EXEC_STATUS_ERROR_FOR_EVENTS_IN_WAIT_LIST);
    TYN_CODE(CL_COMPILE_PROGRAM_FAILURE);
    TYN_CODE(CL_LINKER_NOT_AVAILABLE);
    TYN_CODE(CL_LINK_PROGRAM_FAILURE);
    TYN_CODE(CL_DEVICE_PARTITION_FAILED);
    TYN_CODE(CL_KERNEL_ARG_INFO_NOT_AVAILABLE);
    TYN_CODE(CL_INVALID_VALUE);
    TYN_CODE(CL_INVALID_DEVICE_TYPE);
    TYN_CODE(CL_INVALID_PLATFORM);
    TYN_CODE(CL_INVALID_DEVICE);
    TYN_CODE(CL_INVALID_CONTEXT);
    TYN_CODE(CL_INVALID_QUEUE_PROPERTIES);
    TYN_CODE(CL_INVALID_COMMAND_QUEUE);
    TYN_CODE(CL_INVALID_HOST_PTR);
    TYN_CODE(CL_INVALID_MEM_OBJECT);
    TYN_CODE(CL_INVALID_IMAGE_FORMAT_DESCRIPTOR);
    TYN_CODE(CL_INVALID_IMAGE_SIZE);
    TYN_CODE(CL_INVALID_SAMPLER);
    TYN_CODE(CL_INVALID_BINARY);
    TYN_CODE(CL_INVALID_BUILD_OPTIONS);
    TYN_CODE(CL_INVALID_PROGRAM);
    TYN_CODE(CL_INVALID_PROGRAM_EXECUTABLE);
    TYN_CODE(CL_INVALID_KERNEL_NAME);
    TYN_CODE(CL_INVALID_KERNEL_DEFINITION);
    TYN_CODE(CL_INVALID_KERNEL);
    TYN_CODE(CL_INVALID_ARG_INDEX);
    TYN_CODE(CL_INVALID_ARG_VALUE);
    TYN_CODE(CL_INVALID_ARG_SIZE);
    TYN_CODE(CL_INVALID_KERNEL_ARGS);
    TYN_CODE(CL_INVALID_WORK_DIMENSION);
    TYN_CODE(CL_INVALID_WORK_GROUP_SIZE);
    TYN_CODE(CL_INVALID_WORK_ITEM_SIZE);
    TYN_CODE(CL_INVALID_GLOBAL_OFFSET);
    TYN_CODE(CL_INVALID_EVENT_WAIT_LIST);
    TYN_CODE(CL_INVALID_EVENT);
    TYN_CODE(CL_INVALID_OPERATION);
    TYN_CODE(CL_INVALID_GL_OBJECT);
    TYN_CODE(CL_INVALID_BUFFER_SIZE);
    TYN_CODE(CL_INVALID_MIP_LEVEL);
    TYN_CODE(CL_INVALID_GLOBAL_WORK_SIZE);
    TYN_CODE(CL_INVALID_PROPERTY);
    TYN_CODE(CL_INVALID_IMAGE_DESCRIPTOR);
    TYN_CODE(CL_INVALID_COMPILER_OPTIONS);
    TYN_CODE(CL_INVALID_LINKER_OPTIONS);
    TYN_CODE(CL_INVALID_DEVICE_PARTITION_COUNT);
  case -1001: // cl_khr_icd
    return "CL_PLATFORM_NOT_FOUND_KHR";
  default:
    return "unknown code";
  }
}

#undef TYN_CODE

void check_cl(cl_int code, const char *call, const std::string &detail) {
  if (code == CL_SUCCESS)
    return;
  fail(status_of(code), "%s%s%s failed: %s (%d)", call, detail.empty() ? "" : " for ", detail.c_str(),
       cl_code_name(code), code);
}

std::string platform_text(cl_platform_id platform, cl_platform_info parameter) {
  size_t size = 0;
  check_cl(clGetPlatformInfo(platform, parameter, 0, nullptr, &size), "clGetPlatformInfo");
  std::string text(size, '\0');
  check_cl(clGetPlatformInfo(platform, parameter, size, &text[0], nullptr), "clGetPlatformInfo");
  return trimmed(text);
}

std::string device_text(cl_device_id device, cl_device_info parameter) {
  size_t size = 0;
  check_cl(clGetDeviceInfo(device, parameter, 0, nullptr, &size), "clGetDeviceInfo");
  std::string text(size, '\0');
  check_cl(clGetDeviceInfo(device, parameter, size, &text[0], nullptr), "clGetDeviceInfo");
  return trimmed(text);
}

} // namespace tyn
