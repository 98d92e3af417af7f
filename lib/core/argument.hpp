// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Checks of what callers pass in. Each throws INVALID_ARGUMENT with the element's name, its value and what is allowed.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>

#include "core/status.hpp"

namespace tyn {

inline void require_pointer(const char *name, const void *pointer) {
  if (!pointer)
    fail(TYN_ERROR_INVALID_ARGUMENT, "%s is NULL", name);
}

inline void require_finite(const char *name, double value) {
  if (!std::isfinite(value))
    fail(TYN_ERROR_INVALID_ARGUMENT, "%s is %g; it must be finite", name, value);
}

// Both limits are allowed. A NaN fails.
inline void require_between(const char *name, double value, double lowest, double highest) {
  if (!(value >= lowest && value <= highest))
    fail(TYN_ERROR_INVALID_ARGUMENT, "%s is %g; it must be in [%g, %g]", name, value, lowest, highest);
}

inline void require_positive(const char *name, double value) {
  if (!(value > 0 && std::isfinite(value)))
    fail(TYN_ERROR_INVALID_ARGUMENT, "%s is %g; it must be finite and > 0", name, value);
}

inline void require_not_negative(const char *name, double value) {
  if (!(value >= 0 && std::isfinite(value)))
    fail(TYN_ERROR_INVALID_ARGUMENT, "%s is %g; it must be finite and >= 0", name, value);
}

// An enumeration or a flag: 0 .. count-1.
inline void require_choice(const char *name, uint32_t value, uint32_t count) {
  if (value >= count)
    fail(TYN_ERROR_INVALID_ARGUMENT, "%s is %u; it must be in 0 .. %u", name, value, count - 1);
}

// An index into `count` things called `things`, or TYN_NONE.
inline void require_index_or_none(const char *name, uint32_t value, size_t count, const char *things) {
  if (value != TYN_NONE && value >= count)
    fail(TYN_ERROR_INVALID_ARGUMENT, "%s is %u, but the scene has %zu %s; it must be less, or TYN_NONE", name, value,
         count, things);
}

inline void require_index(const char *name, uint32_t value, size_t count, const char *things) {
  if (value >= count)
    fail(TYN_ERROR_INVALID_ARGUMENT, "%s is %u, but the scene has %zu %s", name, value, count, things);
}

// Three components, checked one by one under the name "NAME[i]".
template <class Check, class... Limits>
void require_each(Check check, const char *name, const float (&values)[3], Limits... limits) {
  for (int i = 0; i < 3; i++) {
    char element[96];
    snprintf(element, sizeof element, "%s[%d]", name, i);
    check(element, values[i], limits...);
  }
}

// A direction whose length is within 1e-3 of 1.
inline void require_unit(const char *name, const float (&v)[3]) {
  require_each(require_finite, name, v);
  double length = std::sqrt(double(v[0]) * v[0] + double(v[1]) * v[1] + double(v[2]) * v[2]);
  if (!(std::abs(length - 1) <= 1e-3))
    fail(TYN_ERROR_INVALID_ARGUMENT, "%s is (%g, %g, %g) of length %g; it must have unit length", name, v[0], v[1],
         v[2], length);
}

// The size member of a struct of the API: 0 and sizes below the struct's first version are mistakes; a larger one
// comes from a program that was compiled for a later library, whose fields this one would silently ignore.
inline void require_size(const char *type, size_t size, size_t first_version, size_t known) {
  if (size < first_version)
    fail(TYN_ERROR_INVALID_ARGUMENT, "%s::size is %zu; it must be sizeof(%s) = %zu", type, size, type, known);
  if (size > known)
    fail(TYN_ERROR_INVALID_ARGUMENT,
         "%s::size is %zu, but this library knows only %zu bytes: the program was compiled for a later version", type,
         size, known);
}

} // namespace tyn
