// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// EXT_meshopt_compression and KHR_meshopt_compression.
#pragma once

#include <string>

#include <tiny_gltf.h>

#include "io/gltf_container.hpp"

namespace tyn::io {

// What the extension of a buffer view says.
struct MeshoptView {
  int buffer = 0;
  uint64_t offset = 0, length = 0;
  uint64_t stride = 0, count = 0;
  std::string mode, filter;
};

// Finds either extension on a buffer view; false if it has none.
bool find_meshopt(const tinygltf::BufferView &view, MeshoptView &result);

// Decodes `source` into stride x count bytes. Throws FORMAT, naming `where`.
Bytes decode_meshopt(const MeshoptView &view, Span source, uint64_t max_bytes, const std::string &where);

} // namespace tyn::io
