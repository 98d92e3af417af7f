// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The check of a buffer that a caller passes in.
#pragma once

#include "core/context.hpp"
#include "core/argument.hpp"

namespace tyn {

// Of the context's cl_context, and large enough for `count` elements of `element` bytes.
inline void require_buffer(const TynContext &context, const char *name, cl_mem buffer, size_t count, size_t element) {
  require_pointer(name, buffer);
  size_t bytes = 0, needed = 0;
  cl_context owner = nullptr;
  if (clGetMemObjectInfo(buffer, CL_MEM_SIZE, sizeof bytes, &bytes, nullptr) != CL_SUCCESS ||
      clGetMemObjectInfo(buffer, CL_MEM_CONTEXT, sizeof owner, &owner, nullptr) != CL_SUCCESS)
    fail(TYN_ERROR_INVALID_ARGUMENT, "%s is not a buffer", name);
  if (owner != context.cl)
    fail(TYN_ERROR_INVALID_ARGUMENT, "%s belongs to another cl_context than the object's", name);
  if (__builtin_mul_overflow(count, element, &needed) || bytes < needed)
    fail(TYN_ERROR_INVALID_ARGUMENT, "%s has %zu bytes; %zu elements of %zu bytes do not fit", name, bytes, count,
         element);
}

} // namespace tyn
