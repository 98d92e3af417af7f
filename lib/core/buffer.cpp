// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "core/context.hpp"
#include "core/opencl.hpp"

namespace tyn {
namespace {

// OpenCL has no empty buffers; kernels that take one get this many bytes instead, outside the
// accounting.
constexpr size_t dummy_bytes = 16;

bool is_out_of_memory(cl_int code) {
  return code == CL_OUT_OF_RESOURCES || code == CL_MEM_OBJECT_ALLOCATION_FAILURE || code == CL_OUT_OF_HOST_MEMORY ||
         code == CL_INVALID_BUFFER_SIZE;
}

double mebibytes(uint64_t bytes) { return static_cast<double>(bytes) / 1048576.0; }

void require_room(const TynContext &context, uint64_t bytes) {
  if (bytes > context.memory_available())
    fail(TYN_ERROR_OUT_OF_MEMORY,
         "out of device memory: a buffer of %.1f MiB was asked for, %.1f MiB are left of %.1f MiB", mebibytes(bytes),
         mebibytes(context.memory_available()), mebibytes(context.memory_limit));
  if (bytes > context.largest_buffer())
    fail(TYN_ERROR_OUT_OF_MEMORY, "a buffer of %.1f MiB was asked for; the largest that %s allows is %.1f MiB",
         mebibytes(bytes), context.device_info.name, mebibytes(context.largest_buffer()));
}

} // namespace

Buffer::Buffer(TynContext &owner, size_t wanted, cl_mem_flags flags, const void *initial)
    : context(&owner), bytes(wanted) {
  require_room(owner, bytes);
  if (bytes == 0)
    initial = nullptr;
  if (initial)
    flags |= CL_MEM_COPY_HOST_PTR;
  cl_int code = CL_SUCCESS;
  mem = clCreateBuffer(owner.cl, flags, bytes ? bytes : dummy_bytes, const_cast<void *>(initial), &code);
  if (is_out_of_memory(code))
    fail(TYN_ERROR_OUT_OF_MEMORY, "clCreateBuffer failed for %.1f MiB with %.1f MiB in use: %s (%d)", mebibytes(bytes),
         mebibytes(owner.memory_used), cl_code_name(code), code);
  check_cl(code, "clCreateBuffer");
  owner.memory_used += bytes;
}

Buffer::Buffer(Buffer &&other) noexcept { *this = std::move(other); }

Buffer &Buffer::operator=(Buffer &&other) noexcept {
  std::swap(context, other.context);
  std::swap(mem, other.mem);
  std::swap(bytes, other.bytes);
  return *this;
}

Buffer::~Buffer() {
  if (!mem)
    return;
  clReleaseMemObject(mem);
  context->memory_used -= bytes;
}

} // namespace tyn
