// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <vector>

#include "core/device.hpp"
#include "core/status.hpp"

namespace {

tyn::Device make_device(const char *name, const char *platform) {
  tyn::Device device;
  std::strcpy(device.info.name, name);
  std::strcpy(device.info.platform, platform);
  return device;
}

const std::vector<tyn::Device> two_devices = {
    make_device("NVIDIA GeForce RTX 4090", "NVIDIA CUDA"),
    make_device("cpu-haswell-AMD Ryzen", "Portable Computing Language"),
};

std::string choice(const char *wanted) { return tyn::choose_device(two_devices, wanted).info.name; }

std::string refusal(const std::vector<tyn::Device> &devices, const char *wanted) {
  try {
    tyn::choose_device(devices, wanted);
  } catch (const tyn::Failure &failure) {
    EXPECT_EQ(failure.status, TYN_ERROR_NO_DEVICE);
    return failure.what();
  }
  ADD_FAILURE() << "a device was chosen";
  return {};
}

} // namespace

TEST(Device, WithoutAWishTheFirstDeviceIsChosen) {
  EXPECT_EQ(choice(nullptr), two_devices[0].info.name);
  EXPECT_EQ(choice(""), two_devices[0].info.name);
}

TEST(Device, AnIndexIsChosenByNumber) {
  EXPECT_EQ(choice("0"), two_devices[0].info.name);
  EXPECT_EQ(choice("1"), two_devices[1].info.name);
}

TEST(Device, PartOfTheNameIsEnoughInAnyCase) {
  EXPECT_EQ(choice("ryzen"), two_devices[1].info.name);
  EXPECT_EQ(choice("GEFORCE"), two_devices[0].info.name);
}

TEST(Device, PartOfThePlatformsNameIsEnough) { EXPECT_EQ(choice("portable"), two_devices[1].info.name); }

TEST(Device, ANumberThatIsNoIndexMayBePartOfAName) { EXPECT_EQ(choice("4090"), two_devices[0].info.name); }

TEST(Device, WhereNothingMatchesTheMessageListsTheDevices) {
  const std::string text = refusal(two_devices, "Radeon");
  EXPECT_NE(text.find("\"Radeon\""), std::string::npos) << text;
  EXPECT_NE(text.find("0: NVIDIA GeForce RTX 4090 (NVIDIA CUDA)"), std::string::npos) << text;
  EXPECT_NE(text.find("1: cpu-haswell-AMD Ryzen"), std::string::npos) << text;
}

TEST(Device, AnIndexPastTheEndMatchesNothing) {
  EXPECT_NE(refusal(two_devices, "2").find("\"2\""), std::string::npos);
  refusal(two_devices, "99999999999999999999");
  refusal(two_devices, "-1");
}

TEST(Device, WithoutDevicesTheMessageSaysWhatToInstall) {
  EXPECT_NE(refusal({}, nullptr).find("pocl-opencl-icd"), std::string::npos);
  EXPECT_NE(refusal({}, "0").find("pocl-opencl-icd"), std::string::npos);
}

TEST(Device, EveryDeviceOfThisMachineIsDescribed) {
  uint32_t count = 0;
  ASSERT_EQ(tyn_device_count(&count), TYN_OK);
  ASSERT_GT(count, 0u) << "the tests need an OpenCL device";
  bool cpu_seen = false;
  for (uint32_t i = 0; i < count; ++i) {
    TynDeviceInfo info;
    ASSERT_EQ(tyn_device_info(i, &info), TYN_OK);
    EXPECT_GT(std::strlen(info.name), 0u);
    EXPECT_GT(std::strlen(info.platform), 0u);
    EXPECT_GT(std::strlen(info.driver), 0u);
    EXPECT_GT(info.compute_units, 0u);
    EXPECT_GT(info.memory, uint64_t{1} << 20);
    EXPECT_FALSE(info.is_gpu && cpu_seen) << "GPUs come first";
    cpu_seen = cpu_seen || !info.is_gpu;
    if (info.is_gpu)
      EXPECT_EQ(info.lane_width, 1u);
    else
      EXPECT_TRUE(info.lane_width == 4 || info.lane_width == 8 || info.lane_width == 16);
  }
}

TEST(Device, DeviceCallsRefuseNullAndAnIndexPastTheEnd) {
  EXPECT_EQ(tyn_device_count(nullptr), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_device_info(0, nullptr), TYN_ERROR_INVALID_ARGUMENT);
  TynDeviceInfo info;
  std::memset(&info, 7, sizeof info);
  const TynDeviceInfo before = info;
  EXPECT_EQ(tyn_device_info(1000000, &info), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(std::memcmp(&info, &before, sizeof info), 0);
}
