// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cache.hpp"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <system_error>

#include "core/opencl.hpp"
#include "core/status.hpp"

namespace fs = std::filesystem;

namespace tyn {
namespace {

// A cache file: this header, the key, the binary. Native byte order: the binary is for this machine
// anyway.
struct Header {
  char magic[8];
  uint64_t key_size;
  uint64_t binary_size;
  uint64_t checksum; // of key and binary
};

constexpr char magic[8] = {'T', 'Y', 'N', 'C', 'L', 'B', '0', '1'};
constexpr unsigned format_version = 1; // part of the key
constexpr uint64_t largest_binary = uint64_t{1} << 30;

struct CloseFile {
  void operator()(std::FILE *file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

Header make_header(const std::string &key, const Binary &binary) {
  Header header{};
  std::memcpy(header.magic, magic, sizeof magic);
  header.key_size = key.size();
  header.binary_size = binary.size();
  header.checksum = hash_bytes(binary.data(), binary.size(), hash_bytes(key.data(), key.size()));
  return header;
}

Binary read_binary(const std::string &path, const std::string &key) {
  const File file(std::fopen(path.c_str(), "rb"));
  Header header{};
  if (!file || std::fread(&header, sizeof header, 1, file.get()) != 1)
    return {};
  if (std::memcmp(header.magic, magic, sizeof magic) != 0 || header.key_size != key.size() || header.binary_size == 0 ||
      header.binary_size > largest_binary)
    return {};
  // A damaged size must not make us allocate more than there is to read.
  if (fs::file_size(path) != sizeof header + header.key_size + header.binary_size)
    return {};
  std::string stored(key.size(), '\0');
  Binary binary(static_cast<size_t>(header.binary_size));
  if (std::fread(&stored[0], 1, stored.size(), file.get()) != stored.size() || stored != key)
    return {};
  if (std::fread(binary.data(), 1, binary.size(), file.get()) != binary.size())
    return {};
  if (make_header(key, binary).checksum != header.checksum)
    return {};
  return binary;
}

bool write_file(const std::string &path, const std::string &key, const Binary &binary) {
  File file(std::fopen(path.c_str(), "wbx"));
  if (!file)
    return false;
  const Header header = make_header(key, binary);
  const bool written = std::fwrite(&header, sizeof header, 1, file.get()) == 1 &&
                       std::fwrite(key.data(), 1, key.size(), file.get()) == key.size() &&
                       std::fwrite(binary.data(), 1, binary.size(), file.get()) == binary.size();
  return std::fclose(file.release()) == 0 && written;
}

// A name that no other thread or process is writing to.
std::string temporary_name(const std::string &path, const void *unique) {
  const auto ticks = std::chrono::steady_clock::now().time_since_epoch().count();
  const auto place = reinterpret_cast<uintptr_t>(unique);
  return path + format(".%llx%llx.tmp", static_cast<unsigned long long>(ticks), static_cast<unsigned long long>(place));
}

bool write_binary(const std::string &path, const std::string &key, const Binary &binary) {
  std::error_code error;
  fs::create_directories(fs::path(path).parent_path(), error);
  const std::string temporary = temporary_name(path, &error);
  if (write_file(temporary, key, binary)) {
    fs::rename(temporary, path, error);
    if (!error)
      return true;
  }
  fs::remove(temporary, error);
  return false;
}

} // namespace

uint64_t hash_bytes(const void *data, size_t size, uint64_t state) {
  const auto *bytes = static_cast<const unsigned char *>(data);
  for (size_t i = 0; i < size; ++i)
    state = (state ^ bytes[i]) * 0x100000001b3u;
  return state;
}

std::string environment_cache_directory() {
  if (const char *directory = std::getenv("TYNDALL_CACHE_DIR"))
    return directory;
  // The XDG base directory specification has relative paths ignored.
  if (const char *base = std::getenv("XDG_CACHE_HOME"))
    if (base[0] == '/')
      return std::string(base) + "/tyndall";
  if (const char *home = std::getenv("HOME"))
    if (home[0] == '/')
      return std::string(home) + "/.cache/tyndall";
  return {};
}

std::string cache_key(cl_device_id device, uint64_t source_hash, size_t source_size, const std::string &options) {
  const auto platform = device_value<cl_platform_id>(device, CL_DEVICE_PLATFORM);
  return format("cache %u\nsource %016llx %zu\noptions %s\nplatform %s, %s\ndevice %s, %s, %s\n", format_version,
                static_cast<unsigned long long>(source_hash), source_size, options.c_str(),
                platform_text(platform, CL_PLATFORM_NAME).c_str(), platform_text(platform, CL_PLATFORM_VERSION).c_str(),
                device_text(device, CL_DEVICE_NAME).c_str(), device_text(device, CL_DEVICE_VERSION).c_str(),
                device_text(device, CL_DRIVER_VERSION).c_str());
}

std::string cache_path(const std::string &directory, const std::string &program, const std::string &key) {
  return directory + "/" + program +
         format("-%016llx.bin", static_cast<unsigned long long>(hash_bytes(key.data(), key.size())));
}

Binary load_binary(const std::string &path, const std::string &key) noexcept {
  try {
    return read_binary(path, key);
  } catch (...) {
    return {};
  }
}

bool store_binary(const std::string &path, const std::string &key, const Binary &binary) noexcept {
  try {
    return write_binary(path, key, binary);
  } catch (...) {
    return false;
  }
}

} // namespace tyn
