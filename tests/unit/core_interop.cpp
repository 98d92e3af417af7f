// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The caller's own OpenCL context and queue.
#include <gtest/gtest.h>

#include <string>

#include "core/context.hpp"
#include "core/device.hpp"

namespace {

class InteropTest : public testing::Test {
protected:
  void SetUp() override {
    const auto devices = tyn::list_devices();
    ASSERT_FALSE(devices.empty()) << "the tests need an OpenCL device";
    device = devices[0].id;
    cl = make_context();
    queue = make_queue(cl, 0);
    options.cache_directory = "";
  }
  void TearDown() override {
    clReleaseCommandQueue(queue);
    clReleaseContext(cl);
  }
  cl_context make_context() const {
    cl_int code = CL_SUCCESS;
    cl_context made = clCreateContext(nullptr, 1, &device, nullptr, nullptr, &code);
    EXPECT_EQ(code, CL_SUCCESS);
    return made;
  }
  cl_command_queue make_queue(cl_context owner, cl_command_queue_properties properties) const {
    cl_int code = CL_SUCCESS;
    cl_command_queue made = clCreateCommandQueue(owner, device, properties, &code);
    return code == CL_SUCCESS ? made : nullptr;
  }
  std::string refusal(cl_context given, cl_command_queue given_queue) {
    char text[256] = "";
    options.message = text;
    options.message_capacity = sizeof text;
    TynContext *context = nullptr;
    EXPECT_EQ(tyn_context_create_cl(&options, given, given_queue, &context), TYN_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(context, nullptr);
    return text;
  }
  cl_uint queue_references() const {
    cl_uint count = 0;
    clGetCommandQueueInfo(queue, CL_QUEUE_REFERENCE_COUNT, sizeof count, &count, nullptr);
    return count;
  }

  TynContextOptions options = tyn_context_options();
  cl_device_id device = nullptr;
  cl_context cl = nullptr;
  cl_command_queue queue = nullptr;
};

} // namespace

TEST_F(InteropTest, TheCallersObjectsAreUsedAndGivenBack) {
  TynContext *context = nullptr;
  ASSERT_EQ(tyn_context_create_cl(&options, cl, queue, &context), TYN_OK);
  cl_context used = nullptr;
  cl_command_queue used_queue = nullptr;
  cl_device_id used_device = nullptr;
  EXPECT_EQ(tyn_context_cl(context, &used, &used_queue, &used_device), TYN_OK);
  EXPECT_EQ(used, cl);
  EXPECT_EQ(used_queue, queue);
  EXPECT_EQ(used_device, device);
  EXPECT_EQ(tyn_context_cl(context, nullptr, nullptr, nullptr), TYN_OK);
  EXPECT_EQ(queue_references(), 2u);
  tyn_context_release(context);
  EXPECT_EQ(queue_references(), 1u);
}

TEST_F(InteropTest, TheCallerMayReleaseFirst) {
  TynContext *context = nullptr;
  cl_context own = make_context();
  cl_command_queue own_queue = make_queue(own, 0);
  ASSERT_EQ(tyn_context_create_cl(nullptr, own, own_queue, &context), TYN_OK);
  clReleaseCommandQueue(own_queue);
  clReleaseContext(own);
  {
    const tyn::Buffer buffer(*context, 64);
    context->fill_zero(buffer);
    int value = 1;
    context->read(buffer, &value, sizeof value);
    EXPECT_EQ(value, 0);
  }
  tyn_context_release(context);
}

TEST_F(InteropTest, ABufferOfTheCallersCanBeRead) {
  const int in = 17;
  cl_int code = CL_SUCCESS;
  cl_mem mem = clCreateBuffer(cl, CL_MEM_READ_WRITE | CL_MEM_COPY_HOST_PTR, sizeof in, const_cast<int *>(&in), &code);
  ASSERT_EQ(code, CL_SUCCESS);
  TynContext *context = nullptr;
  ASSERT_EQ(tyn_context_create_cl(&options, cl, queue, &context), TYN_OK);
  int out = 0;
  context->read(mem, &out, sizeof out);
  EXPECT_EQ(out, 17);
  tyn_context_release(context);
  clReleaseMemObject(mem);
}

TEST_F(InteropTest, ANameOfADeviceIsIgnored) {
  options.device = "no such device";
  TynContext *context = nullptr;
  ASSERT_EQ(tyn_context_create_cl(&options, cl, queue, &context), TYN_OK);
  tyn_context_release(context);
}

TEST_F(InteropTest, NullObjectsAreRefused) {
  EXPECT_EQ(refusal(nullptr, queue), "the cl_context is NULL");
  EXPECT_EQ(refusal(cl, nullptr), "the cl_command_queue is NULL");
  EXPECT_EQ(tyn_context_create_cl(&options, cl, queue, nullptr), TYN_ERROR_INVALID_ARGUMENT);
}

TEST_F(InteropTest, AQueueOfAnotherContextIsRefused) {
  cl_context other = make_context();
  EXPECT_EQ(refusal(other, queue), "the cl_command_queue belongs to another cl_context");
  clReleaseContext(other);
}

TEST_F(InteropTest, AnOutOfOrderQueueIsRefused) {
  cl_command_queue unordered = make_queue(cl, CL_QUEUE_OUT_OF_ORDER_EXEC_MODE_ENABLE);
  if (!unordered)
    GTEST_SKIP() << "this device has no out-of-order queues";
  EXPECT_NE(refusal(cl, unordered).find("out of order"), std::string::npos);
  clReleaseCommandQueue(unordered);
}
