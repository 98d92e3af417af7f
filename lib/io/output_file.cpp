// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output_file.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "io/failure.hpp"

namespace tyn::io {
namespace {

// Follows a symbolic link, so that the file it points to is replaced and not the link.
std::string resolved(const std::string &path) {
  char *real = realpath(path.c_str(), nullptr);
  if (!real)
    return path;
  const std::string result = real;
  std::free(real);
  return result;
}

} // namespace

OutputFile::OutputFile(const std::string &path) : given(path), target(resolved(path)) {
  struct stat info;
  const bool exists = stat(target.c_str(), &info) == 0;
  errno = exists && S_ISDIR(info.st_mode) ? EISDIR : 0;
  if (path.empty() || errno == EISDIR)
    fail(TYN_ERROR_FILE, "cannot write \"%s\": %s", printable(given).c_str(),
         path.empty() ? "the name is empty" : std::strerror(errno));
  const bool direct = exists && !S_ISREG(info.st_mode);
  if (!direct)
    temporary = target + ".part";
  // A file left by a crash is removed first; O_EXCL then refuses a link that someone else puts there.
  if (!direct)
    unlink(temporary.c_str());
  const int flags = direct ? O_WRONLY | O_CLOEXEC : O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC;
  const int descriptor = open(direct ? target.c_str() : temporary.c_str(), flags, 0666);
  if (descriptor >= 0)
    file = fdopen(descriptor, "wb");
  if (!file) {
    const int reason = errno;
    if (descriptor >= 0) {
      close(descriptor);
      unlink(temporary.c_str());
    }
    errno = reason;
    fail_with_errno("cannot write");
  }
}

OutputFile::~OutputFile() {
  if (file)
    std::fclose(file);
  if (file && !temporary.empty())
    unlink(temporary.c_str());
}

void OutputFile::fail_with_errno(const char *what) const {
  fail(TYN_ERROR_FILE, "%s %s: %s", what, printable(given).c_str(), std::strerror(errno));
}

void OutputFile::write(const void *data, size_t size) {
  errno = 0;
  if (std::fwrite(data, 1, size, file) != size)
    fail_with_errno("cannot write");
  position += size;
}

void OutputFile::seek(uint64_t to) {
  if (fseeko(file, off_t(to), SEEK_SET) != 0)
    fail_with_errno("cannot write");
  position = to;
}

void OutputFile::commit() {
  if (std::fflush(file) != 0)
    fail_with_errno("cannot write");
  if (!temporary.empty() && fsync(fileno(file)) != 0)
    fail_with_errno("cannot write");
  FILE *closing = file;
  file = nullptr;
  if (std::fclose(closing) != 0 || (!temporary.empty() && std::rename(temporary.c_str(), target.c_str()) != 0)) {
    const int reason = errno;
    if (!temporary.empty())
      unlink(temporary.c_str());
    errno = reason;
    fail_with_errno("cannot write");
  }
}

} // namespace tyn::io
