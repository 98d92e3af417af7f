// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <numeric>
#include <string>
#include <thread>
#include <vector>

#include "core/context.hpp"
#include "core/kernels.hpp"

namespace {

TynContextOptions uncached() {
  TynContextOptions options = tyn_context_options();
  options.cache_directory = "";
  return options;
}

class ContextTest : public testing::Test {
protected:
  void SetUp() override {
    const TynContextOptions options = uncached();
    ASSERT_EQ(tyn_context_create(&options, &context), TYN_OK);
  }
  void TearDown() override { tyn_context_release(context); }
  TynContext *context = nullptr;
};

// What creating a context with `options` answers; `message` gets the reason.
TynStatus create_status(TynContextOptions options, std::string *message = nullptr) {
  char text[512] = "untouched";
  options.message = text;
  options.message_capacity = sizeof text;
  TynContext *context = reinterpret_cast<TynContext *>(&options);
  const TynStatus status = tyn_context_create(&options, &context);
  if (status == TYN_OK)
    tyn_context_release(context);
  else
    EXPECT_EQ(context, nullptr);
  if (message)
    *message = text;
  return status;
}

tyn::KernelSource make_source(const char *text) { return {"test", text, std::strlen(text), 0}; }

const char *const add_text = "__kernel void add(__global int *values, int count, int step) {\n"
                             "  int i = (int)get_global_id(0);\n"
                             "  if (i < count) values[i] += step;\n"
                             "}\n";

} // namespace

TEST(Context, NullOptionsAreTheDefaults) {
  TynContext *context = nullptr;
  ASSERT_EQ(tyn_context_create(nullptr, &context), TYN_OK);
  EXPECT_STREQ(tyn_context_message(context), "");
  tyn_context_release(context);
}

TEST(Context, NullIsRefusedEverywhere) {
  TynDeviceInfo info;
  EXPECT_EQ(tyn_context_create(nullptr, nullptr), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_context_device(nullptr, &info), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_context_fail(nullptr, TYN_ERROR_FILE, "x"), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_context_cl(nullptr, nullptr, nullptr, nullptr), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_STREQ(tyn_context_message(nullptr), "");
  tyn_context_retain(nullptr);
  tyn_context_release(nullptr);
}

TEST(Context, OptionsWithoutASizeAreRefused) {
  TynContextOptions options = uncached();
  options.size = 0;
  EXPECT_EQ(create_status(options), TYN_ERROR_INVALID_ARGUMENT);
}

TEST(Context, OptionsOfAnOlderHeaderKeepTheirMeaning) {
  TynContextOptions options = uncached();
  options.lane_width = 3; // beyond the size given: not there
  options.size = offsetof(TynContextOptions, lane_width);
  TynContext *context = nullptr;
  ASSERT_EQ(tyn_context_create(&options, &context), TYN_OK);
  tyn_context_release(context);
}

TEST(Context, ALaneWidthIsTakenOrRefused) {
  for (uint32_t lanes : {1u, 4u, 8u, 16u}) {
    TynContextOptions options = uncached();
    options.lane_width = lanes;
    TynContext *context = nullptr;
    TynDeviceInfo info;
    ASSERT_EQ(tyn_context_create(&options, &context), TYN_OK);
    ASSERT_EQ(tyn_context_device(context, &info), TYN_OK);
    EXPECT_EQ(info.lane_width, lanes);
    tyn_context_release(context);
  }
  TynContextOptions options = uncached();
  options.lane_width = 3;
  std::string message;
  EXPECT_EQ(create_status(options, &message), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(message, "TynContextOptions::lane_width is 3; allowed: 0, 1, 4, 8, 16");
}

TEST(Context, ADeviceThatIsNotThereIsNoDevice) {
  TynContextOptions options = uncached();
  options.device = "no such device";
  std::string message;
  EXPECT_EQ(create_status(options, &message), TYN_ERROR_NO_DEVICE);
  EXPECT_NE(message.find("no OpenCL device matches \"no such device\""), std::string::npos);
}

// In a process of its own: the OpenCL loader looks for drivers once.
TEST(Context, WithoutADriverThereIsNoDevice) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  const auto ask = [] {
    setenv("OCL_ICD_VENDORS", "/nonexistent", 1);
    uint32_t count = 1;
    std::string message;
    const bool empty = tyn_device_count(&count) == TYN_OK && count == 0;
    const bool refused = create_status(uncached(), &message) == TYN_ERROR_NO_DEVICE;
    const bool helpful = message.find("no OpenCL device was found") == 0;
    std::_Exit(empty && refused && helpful ? 0 : 1);
  };
  EXPECT_EXIT(ask(), testing::ExitedWithCode(0), "");
}

TEST(Context, AMessageIsCutToItsCapacity) {
  TynContextOptions options = uncached();
  options.device = "no such device";
  char text[8] = "1234567";
  options.message = text;
  options.message_capacity = 4;
  TynContext *context = nullptr;
  EXPECT_EQ(tyn_context_create(&options, &context), TYN_ERROR_NO_DEVICE);
  EXPECT_STREQ(text, "no ");
  EXPECT_EQ(text[4], '5');
}

TEST(Context, TheEnvironmentChoosesADeviceUnlessTheOptionsDo) {
  const char *before = std::getenv("TYNDALL_DEVICE");
  const std::string saved = before ? before : "";
  setenv("TYNDALL_DEVICE", "no such device", 1);
  EXPECT_EQ(create_status(uncached()), TYN_ERROR_NO_DEVICE);
  TynContextOptions options = uncached();
  options.device = "0";
  EXPECT_EQ(create_status(options), TYN_OK);
  if (before)
    setenv("TYNDALL_DEVICE", saved.c_str(), 1);
  else
    unsetenv("TYNDALL_DEVICE");
}

TEST_F(ContextTest, AReferenceKeepsItAlive) {
  tyn_context_retain(context);
  tyn_context_release(context);
  EXPECT_STREQ(tyn_context_message(context), "");
}

TEST_F(ContextTest, ABuiltOnLibraryCanRecordAFailure) {
  EXPECT_EQ(tyn_context_fail(context, TYN_ERROR_FILE, "cannot read x"), TYN_ERROR_FILE);
  EXPECT_STREQ(tyn_context_message(context), "cannot read x");
  EXPECT_EQ(tyn_context_fail(context, TYN_ERROR_FORMAT, nullptr), TYN_ERROR_FORMAT);
  EXPECT_STREQ(tyn_context_message(context), "");
}

TEST_F(ContextTest, AFailureBecomesItsMessage) {
  EXPECT_EQ(tyn::guarded(context, [] { tyn::fail(TYN_ERROR_INVALID_OPERATION, "not %s", "now"); }),
            TYN_ERROR_INVALID_OPERATION);
  EXPECT_STREQ(tyn_context_message(context), "not now");
}

TEST_F(ContextTest, AKernelRunsOverEveryItemWhateverTheLocalSize) {
  context->build(make_source(add_text));
  std::vector<int> values(1001);
  std::iota(values.begin(), values.end(), 0);
  const size_t bytes = values.size() * sizeof(int);
  const tyn::Buffer buffer(*context, bytes, CL_MEM_READ_WRITE, values.data());
  const int count = static_cast<int>(values.size());
  context->launch("test", "add", values.size(), 64, buffer, count, 3);
  context->launch("test", "add", values.size(), 0, buffer, count, 4);
  context->launch("test", "add", 0, 64, buffer, count, 100);
  std::vector<int> result(values.size());
  context->read(buffer, result.data(), bytes);
  for (size_t i = 0; i < values.size(); ++i)
    ASSERT_EQ(result[i], values[i] + 7);
}

TEST_F(ContextTest, CopiesTakeAnOffsetAndStayInside) {
  const tyn::Buffer buffer(*context, 16);
  context->fill_zero(buffer);
  const int in = 42;
  context->write(buffer, &in, sizeof in, 8);
  int out[4] = {9, 9, 9, 9};
  context->read(buffer, out, sizeof out);
  EXPECT_EQ(out[1], 0);
  EXPECT_EQ(out[2], 42);
  context->read(buffer, nullptr, 0);
  context->write(buffer, nullptr, 0);
  EXPECT_THROW(context->write(buffer, &in, sizeof in, 13), tyn::Failure);
  EXPECT_THROW(context->write(buffer, &in, sizeof in, SIZE_MAX), tyn::Failure);
}

TEST_F(ContextTest, AnOddBufferIsZeroedToItsEnd) {
  const char ones[5] = {1, 1, 1, 1, 1};
  const tyn::Buffer buffer(*context, sizeof ones, CL_MEM_READ_WRITE, ones);
  context->fill_zero(buffer);
  char out[5];
  context->read(buffer, out, sizeof out);
  EXPECT_EQ(std::string(out, 5), std::string(5, '\0'));
}

TEST_F(ContextTest, AnUnknownProgramOrKernelIsNamed) {
  EXPECT_EQ(tyn::guarded(context, [&] { context->launch("nothing", "add", 1, 1); }), TYN_ERROR_INTERNAL);
  EXPECT_NE(context->message.find("\"nothing\""), std::string::npos);
  context->build(make_source(add_text));
  EXPECT_EQ(tyn::guarded(context, [&] { context->launch("test", "subtract", 1, 1); }), TYN_ERROR_DEVICE);
  EXPECT_NE(context->message.find("test/subtract"), std::string::npos) << context->message;
  EXPECT_NE(context->message.find("CL_INVALID_KERNEL_NAME"), std::string::npos) << context->message;
}

TEST_F(ContextTest, ABuildFailureTellsDeviceOptionsAndLog) {
  const char *text = "__kernel void broken(void) { undeclared_thing = 1; }\n";
  EXPECT_EQ(tyn::guarded(context, [&] { context->build(make_source(text)); }), TYN_ERROR_KERNEL_BUILD);
  const std::string message = tyn_context_message(context);
  EXPECT_NE(message.find(context->device_info.name), std::string::npos) << message;
  EXPECT_NE(message.find("-cl-std=CL1.2 -D TYN_LANES="), std::string::npos) << message;
  EXPECT_NE(message.find("undeclared_thing"), std::string::npos) << message;
  // The failure leaves the context as it was.
  context->build(make_source(add_text));
}

TEST_F(ContextTest, KernelsAreToldTheLaneWidth) {
  context->build(make_source("__kernel void lanes(__global int *out) { *out = TYN_LANES; }\n"));
  const tyn::Buffer buffer(*context, sizeof(int));
  context->launch("test", "lanes", 1, 1, buffer);
  int lanes = 0;
  context->read(buffer, &lanes, sizeof lanes);
  EXPECT_EQ(lanes, static_cast<int>(context->lanes()));
}

TEST(Context, DifferentContextsWorkAtTheSameTime) {
  const auto work = [](int step, int *sum) {
    const TynContextOptions options = uncached();
    TynContext *context = nullptr;
    ASSERT_EQ(tyn_context_create(&options, &context), TYN_OK);
    context->build(make_source(add_text));
    {
      const tyn::Buffer buffer(*context, 400);
      context->fill_zero(buffer);
      for (int i = 0; i < 50; ++i)
        context->launch("test", "add", 100, 4, buffer, 100, step);
      std::vector<int> values(100);
      context->read(buffer, values.data(), 400);
      *sum = std::accumulate(values.begin(), values.end(), 0);
    }
    tyn_context_release(context);
  };
  int one = 0, two = 0;
  std::thread other(work, 1, &one);
  work(2, &two);
  other.join();
  EXPECT_EQ(one, 5000);
  EXPECT_EQ(two, 10000);
}
