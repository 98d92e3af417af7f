// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Files that are read whole.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace tyn::io {

using Bytes = std::vector<uint8_t>;

// Throws FILE unless `path` is a regular file that can be opened. Returns its size.
uint64_t require_readable(const std::string &path);

// Reads a regular file of at most `limit` bytes. Throws FILE, naming the file and the reason.
Bytes read_file(const std::string &path, uint64_t limit);

// The path of what a model refers to by `uri`: a relative path that stays in the folder of `model_path`. Percent-encoding is
// undone. Throws FORMAT for anything else (a scheme, an absolute path, "..").
std::string confined_path(const std::string &model_path, const std::string &uri);

} // namespace tyn::io
