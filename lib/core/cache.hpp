// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The disk cache of compiled programs. A cache that is missing, damaged or read-only costs time and
// nothing else: no function here throws or reports an error.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tyndall/tyndall_cl.h"

namespace tyn {

using Binary = std::vector<unsigned char>;

// FNV-1a, 64 bits; `state` continues an earlier hash.
constexpr uint64_t hash_seed = 0xcbf29ce484222325u;
uint64_t hash_bytes(const void *data, size_t size, uint64_t state = hash_seed);

// The folder of the environment: TYNDALL_CACHE_DIR, $XDG_CACHE_HOME/tyndall, ~/.cache/tyndall. ""
// means none.
std::string environment_cache_directory();

// Everything that a compiled program depends on, as text.
std::string cache_key(cl_device_id device, uint64_t source_hash, size_t source_size, const std::string &options);

// The file that a program with this key is kept in.
std::string cache_path(const std::string &directory, const std::string &program, const std::string &key);

// Reads the binary kept under `key`; an empty one if there is none or it is damaged.
Binary load_binary(const std::string &path, const std::string &key) noexcept;

// Writes a temporary file and renames it, so that no other process ever sees half a file. Returns
// whether it worked.
bool store_binary(const std::string &path, const std::string &key, const Binary &binary) noexcept;

} // namespace tyn
