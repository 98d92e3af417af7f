// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The size of a PNG or JPEG image from its first bytes.
#pragma once

#include <cstdint>

#include "io/input_file.hpp"

namespace tyn::io {

struct ImageSize {
  uint32_t width = 0, height = 0; // 0 0: neither PNG nor JPEG, or cut off
};

// Asked before an image is decoded: a few bytes can claim a picture that does not fit into the memory.
ImageSize image_size(const Bytes &encoded);

} // namespace tyn::io
