// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "core/context.hpp"
#include "core/opencl.hpp"

TEST(Status, EveryStatusHasANameOfItsOwn) {
  std::set<std::string> names;
  for (TynStatus status = TYN_OK; status <= TYN_ERROR_INTERNAL; ++status)
    names.insert(tyn_status_string(status));
  EXPECT_EQ(names.size(), 11u);
  EXPECT_EQ(names.count("unknown status"), 0u);
}

TEST(Status, TheDocumentedNameIsGiven) {
  EXPECT_STREQ(tyn_status_string(TYN_ERROR_INVALID_ARGUMENT), "invalid argument");
}

TEST(Status, AnyOtherNumberIsUnknown) {
  EXPECT_STREQ(tyn_status_string(-1), "unknown status");
  EXPECT_STREQ(tyn_status_string(11), "unknown status");
  EXPECT_STREQ(tyn_status_string(INT32_MAX), "unknown status");
}

TEST(Status, TheLibraryHasTheHeadersVersion) { EXPECT_EQ(tyn_version(), uint32_t{TYN_VERSION}); }

TEST(Status, FormatTakesTextOfAnyLength) {
  const std::string text(5000, 'x');
  EXPECT_EQ(tyn::format("%s %d", text.c_str(), 7), text + " 7");
  EXPECT_EQ(tyn::format("%s", ""), "");
}

TEST(Status, FailThrowsStatusAndText) {
  try {
    tyn::fail(TYN_ERROR_FORMAT, "line %d", 12);
  } catch (const tyn::Failure &failure) {
    EXPECT_EQ(failure.status, TYN_ERROR_FORMAT);
    EXPECT_STREQ(failure.what(), "line 12");
    return;
  }
  FAIL() << "nothing was thrown";
}

TEST(Status, ExceptionsBecomeStatusesAtTheBoundary) {
  const auto thrown = [](auto &&exception) { return tyn::guarded(nullptr, [&] { throw exception; }); };
  EXPECT_EQ(tyn::guarded(nullptr, [] {}), TYN_OK);
  EXPECT_EQ(thrown(tyn::Failure(TYN_ERROR_CANCELLED, "")), TYN_ERROR_CANCELLED);
  EXPECT_EQ(thrown(std::bad_alloc()), TYN_ERROR_OUT_OF_MEMORY);
  EXPECT_EQ(thrown(std::runtime_error("")), TYN_ERROR_INTERNAL);
  EXPECT_EQ(thrown(1), TYN_ERROR_INTERNAL);
}

TEST(Status, AnOpenClErrorNamesTheCallAndTheCode) {
  try {
    tyn::check_cl(CL_INVALID_KERNEL_ARGS, "clEnqueueNDRangeKernel", "walk");
  } catch (const tyn::Failure &failure) {
    EXPECT_EQ(failure.status, TYN_ERROR_DEVICE);
    EXPECT_STREQ(failure.what(), "clEnqueueNDRangeKernel for walk failed: CL_INVALID_KERNEL_ARGS (-52)");
    return;
  }
  FAIL() << "nothing was thrown";
}

TEST(Status, AFailedAllocationOnTheDeviceIsOutOfMemory) {
  try {
    tyn::check_cl(CL_MEM_OBJECT_ALLOCATION_FAILURE, "clEnqueueNDRangeKernel");
  } catch (const tyn::Failure &failure) {
    EXPECT_EQ(failure.status, TYN_ERROR_OUT_OF_MEMORY);
    return;
  }
  FAIL() << "nothing was thrown";
}
