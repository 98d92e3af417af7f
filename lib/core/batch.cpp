// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "core/batch.hpp"

#include <algorithm>

namespace tyn {

size_t batch_size(const TynContext &context, size_t count, size_t most, size_t bytes, size_t largest,
                  const char *element) {
  const uint64_t fits = std::min(context.memory_available() / bytes, context.largest_buffer() / largest);
  if (fits == 0)
    fail(TYN_ERROR_OUT_OF_MEMORY, "%llu bytes of device memory are left; one %s needs %zu",
         static_cast<unsigned long long>(context.memory_available()), element, bytes);
  return static_cast<size_t>(std::min<uint64_t>(fits, std::min(count, most)));
}

} // namespace tyn
