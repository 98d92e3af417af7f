// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// A file that appears under its name only when it is complete.
#pragma once

#include <cstdint>
#include <cstdio>
#include <string>

namespace tyn::io {

// Writes to a new file .NAME.XXXXXX beside PATH, which commit() flushes to the disk and renames to PATH. Without commit() the
// destructor removes it, so a full disk or a crash leaves whatever was there before, and of two writers the last one to commit
// wins. A device such as /dev/null is written to directly.
// Every member throws FILE with one line on failure.
class OutputFile {
public:
  explicit OutputFile(const std::string &path);
  ~OutputFile();
  OutputFile(const OutputFile &) = delete;
  OutputFile &operator=(const OutputFile &) = delete;

  void write(const void *data, size_t size);
  void seek(uint64_t position);
  uint64_t tell() const { return position; }
  void commit();

private:
  [[noreturn]] void fail_with_errno(const char *what) const;

  std::string given;     // what the caller called it
  std::string target;    // that, with a symbolic link followed
  std::string temporary; // empty: written to directly
  FILE *file = nullptr;
  uint64_t position = 0;
};

} // namespace tyn::io
