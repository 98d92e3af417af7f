// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "common/outputs.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>

namespace tool {
namespace {

// The file that a path leads to, whether it is there or not, through links.
std::filesystem::path target_of(const std::string &path) {
  std::error_code ignored;
  std::filesystem::path target = path;
  for (int link = 0; link < 8 && std::filesystem::is_symlink(target, ignored); ++link)
    target = target.parent_path() / std::filesystem::read_symlink(target, ignored);
  return std::filesystem::weakly_canonical(std::filesystem::absolute(target, ignored), ignored);
}

bool write_all(int file, const std::string &content) {
  size_t written = 0;
  while (written < content.size()) {
    const ssize_t count = write(file, content.data() + written, content.size() - written);
    if (count < 0 && errno == EINTR)
      continue;
    if (count <= 0)
      return false;
    written += static_cast<size_t>(count);
  }
  return true;
}

// mkstemp's files are the owner's alone; others get what the umask leaves them.
void open_to_others(int file) {
  const mode_t mask = umask(0);
  umask(mask);
  (void)!fchmod(file, 0666 & ~mask); // a file system without modes is no reason to fail
}

} // namespace

void check_writable(const std::string &path, ExitCode code) {
  const size_t slash = path.rfind('/');
  const std::string folder = slash == std::string::npos ? "." : path.substr(0, slash + 1);
  struct stat status;
  if (stat(path.c_str(), &status) == 0 && S_ISDIR(status.st_mode))
    throw Error(code, path + " is a folder");
  if (stat(folder.c_str(), &status) != 0)
    throw Error(code, path + " cannot be written: its folder: " + std::strerror(errno));
  if (!S_ISDIR(status.st_mode))
    throw Error(code, path + " cannot be written: " + folder + " is not a folder");
  if (access(folder.c_str(), W_OK | X_OK) != 0)
    throw Error(code, path + " cannot be written: its folder: " + std::strerror(errno));
}

bool same_file(const std::string &one, const std::string &other) {
  return !one.empty() && !other.empty() && target_of(one) == target_of(other);
}

void check_distinct(const std::string &output, const std::string &other) {
  if (same_file(output, other))
    throw Error(kUsage, output + " is the same file as " + other);
}

bool has_extension(const std::string &path, const std::string &extension) {
  if (path.size() <= extension.size())
    return false;
  std::string end = path.substr(path.size() - extension.size());
  for (char &c : end)
    c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return end == extension;
}

void write_file(const std::string &path, const std::string &content, ExitCode code) {
  struct stat status;
  // A rename would put a plain file in the place of a device or a pipe.
  const bool special = stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode);
  const std::string target = special ? path : target_of(path).string();
  std::string temporary = target + ".XXXXXX";
  const int file = special ? open(path.c_str(), O_WRONLY | O_CLOEXEC) : mkstemp(&temporary[0]);
  if (file < 0)
    throw Error(code, path + " cannot be written: " + std::strerror(errno));
  if (!special)
    open_to_others(file);
  int reason = write_all(file, content) ? 0 : errno;
  if (close(file) != 0 && !reason)
    reason = errno;
  if (!special && !reason && std::rename(temporary.c_str(), target.c_str()) != 0)
    reason = errno;
  if (!reason)
    return;
  if (!special)
    unlink(temporary.c_str());
  throw Error(code, path + " cannot be written: " + std::strerror(reason));
}

} // namespace tool
