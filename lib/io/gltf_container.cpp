// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "io/gltf_container.hpp"

#include "io/failure.hpp"

namespace tyn::io {
namespace {

constexpr uint32_t GLB_MAGIC = 0x46546c67;  // "glTF"
constexpr uint32_t CHUNK_JSON = 0x4e4f534a; // "JSON"
constexpr uint32_t CHUNK_BIN = 0x004e4942;  // "BIN"
constexpr size_t HEADER_SIZE = 12;
constexpr size_t CHUNK_HEADER_SIZE = 8;

uint32_t little_endian(const uint8_t *bytes) {
  return uint32_t(bytes[0]) | uint32_t(bytes[1]) << 8 | uint32_t(bytes[2]) << 16 | uint32_t(bytes[3]) << 24;
}

// Stores a chunk where it belongs; chunks of other types are to be ignored (glTF 2.0, section 4.4.3).
void take_chunk(GltfContainer &container, uint32_t type, Span chunk, size_t index) {
  if (index == 0 && type != CHUNK_JSON)
    fail(TYN_ERROR_FORMAT, "the first chunk of the GLB is not JSON (its type is 0x%08x)", type);
  if (index == 0)
    container.json = chunk;
  else if (type == CHUNK_BIN && !container.binary.data)
    container.binary = chunk;
}

GltfContainer split_glb(const Bytes &bytes) {
  if (bytes.size() < HEADER_SIZE)
    fail(TYN_ERROR_FORMAT, "the GLB header is cut off after %zu bytes", bytes.size());
  const uint32_t version = little_endian(&bytes[4]);
  const size_t length = little_endian(&bytes[8]);
  if (version != 2)
    fail(TYN_ERROR_FORMAT, "GLB version %u; only version 2 is supported", version);
  if (length > bytes.size())
    fail(TYN_ERROR_FORMAT, "the GLB is cut off: its header says %zu bytes, the file has %zu", length, bytes.size());
  GltfContainer container;
  container.is_glb = true;
  size_t at = HEADER_SIZE;
  for (size_t index = 0; at + CHUNK_HEADER_SIZE <= length; index++) {
    const size_t size = little_endian(&bytes[at]);
    const uint32_t type = little_endian(&bytes[at + 4]);
    at += CHUNK_HEADER_SIZE;
    if (size > length - at)
      fail(TYN_ERROR_FORMAT, "chunk %zu of the GLB has %zu bytes, but only %zu are left", index, size, length - at);
    take_chunk(container, type, {bytes.data() + at, size}, index);
    at += size;
  }
  if (!container.json.data)
    fail(TYN_ERROR_FORMAT, "the GLB has no JSON chunk");
  return container;
}

} // namespace

GltfContainer split_container(const Bytes &bytes) {
  if (bytes.size() >= 4 && little_endian(bytes.data()) == GLB_MAGIC)
    return split_glb(bytes);
  GltfContainer container;
  container.json = {bytes.data(), bytes.size()};
  if (bytes.size() >= 3 && bytes[0] == 0xef && bytes[1] == 0xbb && bytes[2] == 0xbf) // byte order mark
    container.json = {bytes.data() + 3, bytes.size() - 3};
  return container;
}

} // namespace tyn::io
