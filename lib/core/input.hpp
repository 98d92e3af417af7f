// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Option structs that begin with their size: reading those of older callers, and filling in the caller's.
#pragma once

#include <cstring>

#include "core/argument.hpp"

namespace tyn {

// A copy of *given in today's size; members that the caller's version lacks keep those of `defaults`.
// All structs but TynBssrdfOptions, TynMedium, TynRenderOptions and TynRenderStats are at their first version: when one grows,
// give its old size here.
template <class T>
T read_struct(const char *type, const T *given, const T &defaults, size_t first_version = sizeof(T)) {
  require_pointer(type, given);
  require_size(type, given->size, first_version, sizeof(T));
  T result = defaults;
  std::memcpy(static_cast<void *>(&result), given, given->size);
  result.size = sizeof(T);
  return result;
}

// Writes as much of `value` as the caller's struct has room for; its `size` stays.
template <class T>
void write_struct(const char *type, T *target, T value, size_t first_version = sizeof(T)) {
  require_pointer(type, target);
  require_size(type, target->size, first_version, sizeof(T));
  value.size = target->size;
  std::memcpy(static_cast<void *>(target), &value, target->size);
}

} // namespace tyn
