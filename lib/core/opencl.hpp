// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// OpenCL calls with errors as tyn::Failure.
#pragma once

#include <string>
#include <vector>

#include "tyndall/tyndall_cl.h"

namespace tyn {

// "CL_OUT_OF_RESOURCES" for -5, ...; "unknown code" for a code that OpenCL 1.2 does not define.
const char *cl_code_name(cl_int code);

// Throws unless `code` is CL_SUCCESS. `call` is the OpenCL function, `detail` what it was called
// for (may be empty).
void check_cl(cl_int code, const char *call, const std::string &detail = {});

// Text queries without the padding and the terminator that some drivers leave in them.
std::string platform_text(cl_platform_id platform, cl_platform_info parameter);
std::string device_text(cl_device_id device, cl_device_info parameter);

template <class T>
T device_value(cl_device_id device, cl_device_info parameter) {
  T value{};
  check_cl(clGetDeviceInfo(device, parameter, sizeof value, &value, nullptr), "clGetDeviceInfo");
  return value;
}

} // namespace tyn
