// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
//
// Files that a tool writes: looked at before the work, and put in place whole or not at all.
#pragma once

#include "common/tool.hpp"

#include <string>

namespace tool {

// Throws `code` if a file could not be created at `path`, so that an hour's work is not lost.
void check_writable(const std::string &path, ExitCode code = kFailed);

// Whether two paths lead to one file, be it there or not.
bool same_file(const std::string &one, const std::string &other);

// Throws if both paths lead to one file: one must not take the place of another that is read or written.
void check_distinct(const std::string &output, const std::string &other);

// Whether `path` ends in `extension` (lower case, with its point), whatever its case, and is more than that.
bool has_extension(const std::string &path, const std::string &extension);

// Writes a file under another name and renames it, so that nobody sees half of it. Throws `code`.
void write_file(const std::string &path, const std::string &content, ExitCode code = kFailed);

} // namespace tool
