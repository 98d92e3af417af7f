// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "core/context.hpp"

namespace {

constexpr uint64_t mebibyte = 1048576;

class BufferTest : public testing::Test {
protected:
  void SetUp() override {
    TynContextOptions options = tyn_context_options();
    options.cache_directory = "";
    options.memory_limit = 8 * mebibyte;
    ASSERT_EQ(tyn_context_create(&options, &context), TYN_OK);
  }
  void TearDown() override { tyn_context_release(context); }
  TynContext *context = nullptr;
};

} // namespace

TEST_F(BufferTest, BuffersCountAgainstTheLimitUntilTheyGo) {
  EXPECT_EQ(context->memory_available(), 8 * mebibyte);
  {
    const tyn::Buffer a(*context, 3 * mebibyte);
    const tyn::Buffer b(*context, 2 * mebibyte);
    EXPECT_EQ(context->memory_available(), 3 * mebibyte);
    EXPECT_EQ(context->largest_buffer(), 3 * mebibyte);
  }
  EXPECT_EQ(context->memory_available(), 8 * mebibyte);
}

TEST_F(BufferTest, PastTheLimitItIsOutOfMemoryAndNothingChanges) {
  const tyn::Buffer a(*context, 6 * mebibyte);
  EXPECT_EQ(tyn::guarded(context, [&] { tyn::Buffer b(*context, 3 * mebibyte); }), TYN_ERROR_OUT_OF_MEMORY);
  EXPECT_EQ(context->message, "out of device memory: a buffer of 3.0 MiB was asked for, 2.0 MiB "
                              "are left of 8.0 MiB");
  EXPECT_EQ(context->memory_available(), 2 * mebibyte);
}

TEST_F(BufferTest, ASizeNoDeviceHasIsOutOfMemory) {
  TynContextOptions options = tyn_context_options();
  options.cache_directory = "";
  TynContext *whole = nullptr;
  ASSERT_EQ(tyn_context_create(&options, &whole), TYN_OK);
  EXPECT_EQ(whole->memory_available(), whole->device_info.memory);
  EXPECT_EQ(tyn::guarded(whole, [&] { tyn::Buffer huge(*whole, SIZE_MAX / 2); }), TYN_ERROR_OUT_OF_MEMORY);
  EXPECT_EQ(whole->memory_available(), whole->device_info.memory);
  tyn_context_release(whole);
}

TEST_F(BufferTest, AnEmptyBufferIsAnArgumentAndCostsNothing) {
  const tyn::Buffer empty(*context, 0);
  EXPECT_TRUE(empty);
  EXPECT_EQ(empty.size(), 0u);
  EXPECT_EQ(context->memory_available(), 8 * mebibyte);
  context->fill_zero(empty);
}

TEST_F(BufferTest, AMovedBufferIsCountedOnce) {
  tyn::Buffer a(*context, mebibyte);
  tyn::Buffer b(std::move(a));
  EXPECT_FALSE(a);
  EXPECT_TRUE(b);
  tyn::Buffer c;
  c = std::move(b);
  EXPECT_EQ(c.size(), mebibyte);
  EXPECT_EQ(context->memory_available(), 7 * mebibyte);
  c = tyn::Buffer();
  EXPECT_EQ(context->memory_available(), 8 * mebibyte);
}

TEST_F(BufferTest, ReplacingABufferFreesTheOldOne) {
  tyn::Buffer a(*context, 3 * mebibyte);
  a = tyn::Buffer(*context, mebibyte);
  EXPECT_EQ(a.size(), mebibyte);
  EXPECT_EQ(context->memory_available(), 7 * mebibyte);
}

TEST_F(BufferTest, ALimitAboveTheDevicesMemoryIsTheDevicesMemory) {
  TynContextOptions options = tyn_context_options();
  options.cache_directory = "";
  options.memory_limit = UINT64_MAX;
  TynContext *whole = nullptr;
  ASSERT_EQ(tyn_context_create(&options, &whole), TYN_OK);
  EXPECT_EQ(whole->memory_available(), whole->device_info.memory);
  tyn_context_release(whole);
}
