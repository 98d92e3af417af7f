// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output_file.hpp"

#include <cerrno>
#include <climits>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <random>
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

// Creates a file of a name of its own beside `target`, which `temporary` gets: like mkstemp, but with the mode that the umask
// leaves of 0666. (A process cannot ask for its umask without changing it for all threads.)
int create_beside(const std::string &target, std::string &temporary) {
  const size_t slash = target.rfind('/'), start = slash == std::string::npos ? 0 : slash + 1;
  const std::string name = target.substr(start, NAME_MAX - std::strlen("..XXXXXX"));
  std::random_device random;
  int descriptor = -1;
  for (int attempt = 0; attempt < 100 && descriptor < 0; attempt++) {
    temporary = target.substr(0, start) + text(".%s.%06x", name.c_str(), random() & 0xffffffu);
    // O_EXCL also refuses a link that someone else puts there.
    descriptor = open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0 && errno != EEXIST)
      break;
  }
  return descriptor;
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
  const int descriptor = direct ? open(target.c_str(), O_WRONLY | O_CLOEXEC) : create_beside(target, temporary);
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
