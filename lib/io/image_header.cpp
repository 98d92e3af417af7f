// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "io/image_header.hpp"

#include <cstring>

namespace tyn::io {
namespace {

uint32_t big_endian(const uint8_t *bytes, int count) {
  uint32_t value = 0;
  for (int i = 0; i < count; i++)
    value = value << 8 | bytes[i];
  return value;
}

// Whether a JPEG marker begins a frame, whose header holds the size: SOF0 to SOF15 without DHT, JPG and DAC.
bool begins_frame(uint8_t marker) {
  return marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
}

ImageSize jpeg_size(const Bytes &bytes) {
  size_t at = 2;
  while (at + 9 <= bytes.size()) {
    if (bytes[at] != 0xff) // between segments only padding is allowed, which is 0xff as well
      return {};
    const uint8_t marker = bytes[at + 1];
    if (marker == 0xff) {
      at++;
      continue;
    }
    if (begins_frame(marker))
      return {big_endian(&bytes[at + 7], 2), big_endian(&bytes[at + 5], 2)};
    const bool without_length = marker == 0x01 || (marker >= 0xd0 && marker <= 0xd8);
    at += without_length ? 2 : 2 + size_t(big_endian(&bytes[at + 2], 2));
  }
  return {};
}

} // namespace

ImageSize image_size(const Bytes &bytes) {
  static const uint8_t PNG_SIGNATURE[8] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  if (bytes.size() >= 24 && std::memcmp(bytes.data(), PNG_SIGNATURE, 8) == 0)
    return {big_endian(&bytes[16], 4), big_endian(&bytes[20], 4)};
  if (bytes.size() >= 4 && bytes[0] == 0xff && bytes[1] == 0xd8)
    return jpeg_size(bytes);
  return {};
}

} // namespace tyn::io
