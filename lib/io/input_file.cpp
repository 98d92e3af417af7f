// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input_file.hpp"

#include <cerrno>
#include <cinttypes>
#include <cstdio>
#include <cstring>
#include <memory>
#include <sys/stat.h>

#include "io/failure.hpp"

namespace tyn::io {
namespace {

int hex_digit(char c) {
  if (c >= '0' && c <= '9')
    return c - '0';
  if (c >= 'a' && c <= 'f')
    return c - 'a' + 10;
  return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

std::string percent_decoded(const std::string &uri) {
  std::string result;
  for (size_t i = 0; i < uri.size(); i++) {
    const bool escaped =
        uri[i] == '%' && i + 2 < uri.size() && hex_digit(uri[i + 1]) >= 0 && hex_digit(uri[i + 2]) >= 0;
    result += escaped ? char(hex_digit(uri[i + 1]) * 16 + hex_digit(uri[i + 2])) : uri[i];
    i += escaped ? 2 : 0;
  }
  return result;
}

bool has_parent_step(const std::string &path) {
  for (size_t begin = 0; begin <= path.size();) {
    const size_t end = std::min(path.find('/', begin), path.size());
    if (path.compare(begin, end - begin, "..") == 0)
      return true;
    begin = end + 1;
  }
  return false;
}

} // namespace

namespace {

using File = std::unique_ptr<FILE, int (*)(FILE *)>;

File open_regular(const std::string &path, uint64_t &size) {
  // Looked at before it is opened: opening a named pipe would wait for a writer.
  struct stat info;
  if (stat(path.c_str(), &info) != 0)
    fail(TYN_ERROR_FILE, "cannot open %s: %s", printable(path).c_str(), std::strerror(errno));
  if (!S_ISREG(info.st_mode))
    fail(TYN_ERROR_FILE, "cannot read %s: it is %s", printable(path).c_str(),
         S_ISDIR(info.st_mode) ? "a folder" : "not a regular file");
  File file(std::fopen(path.c_str(), "rbe"), std::fclose);
  if (!file)
    fail(TYN_ERROR_FILE, "cannot open %s: %s", printable(path).c_str(), std::strerror(errno));
  size = uint64_t(info.st_size);
  return file;
}

} // namespace

uint64_t require_readable(const std::string &path) {
  uint64_t size = 0;
  open_regular(path, size);
  return size;
}

Bytes read_file(const std::string &path, uint64_t limit) {
  uint64_t size = 0;
  const File file = open_regular(path, size);
  if (size > limit)
    fail(TYN_ERROR_FILE, "%s has %" PRIu64 " bytes; at most %" PRIu64 " are read", printable(path).c_str(), size,
         limit);
  Bytes bytes(static_cast<size_t>(size));
  if (!bytes.empty() && std::fread(bytes.data(), 1, bytes.size(), file.get()) != bytes.size())
    fail(TYN_ERROR_FILE, "cannot read %s: %s", printable(path).c_str(),
         std::ferror(file.get()) ? std::strerror(errno) : "it became shorter");
  return bytes;
}

std::string confined_path(const std::string &model_path, const std::string &uri) {
  const std::string path = percent_decoded(uri);
  const char *problem = nullptr;
  if (path.empty() || path.find('\0') != std::string::npos)
    problem = "is not a path";
  else if (path[0] == '/' || path.find('\\') != std::string::npos || path.find(':') < path.find('/'))
    problem = "is not a relative path";
  else if (has_parent_step(path))
    problem = "leaves the folder of the model";
  if (problem)
    fail(TYN_ERROR_FORMAT, "the URI \"%s\" %s", printable(uri).c_str(), problem);
  const size_t slash = model_path.rfind('/');
  return slash == std::string::npos ? path : model_path.substr(0, slash + 1) + path;
}

} // namespace tyn::io
