// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Work that goes to the device in parts.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/context.hpp"

namespace tyn {

// How many of `count` elements go at once: at most `most`, and what fits the memory where each takes `bytes` in all and
// `largest` of them in one buffer. Fails if not even one fits; `element` says one of what.
size_t batch_size(const TynContext &context, size_t count, size_t most, size_t bytes, size_t largest,
                  const char *element);

} // namespace tyn
