// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Which OpenCL devices there are, and which one a user means.
#pragma once

#include <string>
#include <vector>

#include "tyndall/tyndall_cl.h"

namespace tyn {

struct Device {
  cl_device_id id = nullptr;
  TynDeviceInfo info{};
};

// All usable devices of all platforms: GPUs, then CPUs, then the rest. Empty if there are none.
std::vector<Device> list_devices();

// What a user calls `wanted`: an index into `devices`, else part of a device's or its platform's
// name, case ignored; the first device for nullptr or "". Throws NO_DEVICE with the list of devices
// when nothing matches.
const Device &choose_device(const std::vector<Device> &devices, const char *wanted);

TynDeviceInfo describe_device(cl_device_id device);

} // namespace tyn
