// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

namespace tyn {

// One OpenCL program: kernels/NAME.cl with every include resolved. Written at build time by
// cmake/embed_kernels.cpp.
struct KernelSource {
  const char *name; // file name without .cl
  const char *text; // null-terminated, with #line directives that point to the files it was made of
  size_t size;      // bytes, without the terminator
  uint64_t hash;    // FNV-1a of the text
};

extern const KernelSource kernel_sources[]; // sorted by name
extern const size_t kernel_source_count;

} // namespace tyn
