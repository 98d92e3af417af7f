// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/context.hpp"

namespace tyn {

// A read-only buffer that holds `values`.
template <class T>
Buffer upload(TynContext &context, const std::vector<T> &values) {
  Buffer buffer(context, values.size() * sizeof(T), CL_MEM_READ_ONLY);
  context.write(buffer, values.data(), values.size() * sizeof(T));
  return buffer;
}

} // namespace tyn
