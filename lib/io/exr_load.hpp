// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// OpenEXR images in.
#pragma once

#include <string>
#include <vector>

#include "io/failure.hpp"

namespace tyn::io {

struct ExrImage {
  uint32_t width = 0, height = 0;
  std::vector<float> pixels; // R G B 1, finite and not negative, Rec.709 primaries, rows from top to bottom
};

// Reads R G B (or Y) of the first part. Throws FILE and FORMAT.
ExrImage read_exr(const std::string &path);

} // namespace tyn::io
