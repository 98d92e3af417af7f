// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The outside of a glTF file: the GLB container, or plain JSON.
#pragma once

#include <cstddef>
#include <cstdint>

#include "io/input_file.hpp"

namespace tyn::io {

// Bytes that someone else owns.
struct Span {
  const uint8_t *data = nullptr;
  size_t size = 0;
};

struct GltfContainer {
  Span json;
  Span binary;         // the BIN chunk; empty if there is none
  bool is_glb = false; // only in a GLB may the first buffer go without a uri
};

// Splits a file's bytes, which must outlive the result. Throws FORMAT.
GltfContainer split_container(const Bytes &bytes);

} // namespace tyn::io
