// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "core/cache.hpp"
#include "core/context.hpp"
#include "core/kernels.hpp"

namespace fs = std::filesystem;

namespace {

const char *const square_text = "__kernel void square(__global int *values) {\n"
                                "  size_t i = get_global_id(0);\n"
                                "  values[i] *= values[i];\n"
                                "}\n";

tyn::KernelSource make_source(const char *text) {
  const size_t size = std::strlen(text);
  return {"square", text, size, tyn::hash_bytes(text, size)};
}

class CacheTest : public testing::Test {
protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "tyndall-cache-XXXXXX").string();
    ASSERT_NE(mkdtemp(&pattern[0]), nullptr);
    folder = pattern;
    path = (folder / "entry.bin").string();
  }
  void TearDown() override {
    fs::permissions(folder, fs::perms::owner_all);
    fs::remove_all(folder);
  }

  // A context over the folder squares 7; says whether its program came from the cache.
  bool run_from_cache(const char *text = square_text, uint32_t lanes = 0) {
    TynContextOptions options = tyn_context_options();
    const std::string directory = (folder / "kernels").string();
    options.cache_directory = directory.c_str();
    options.lane_width = lanes;
    TynContext *context = nullptr;
    EXPECT_EQ(tyn_context_create(&options, &context), TYN_OK);
    int value = 7;
    bool cached = false;
    {
      context->build(make_source(text));
      const tyn::Buffer buffer(*context, sizeof value, CL_MEM_READ_WRITE, &value);
      context->launch("square", "square", 1, 1, buffer);
      context->read(buffer, &value, sizeof value);
      cached = context->from_cache("square");
    }
    tyn_context_release(context);
    EXPECT_EQ(value, 49);
    return cached;
  }

  std::vector<fs::path> cached_files() const {
    std::vector<fs::path> files;
    for (const auto &entry : fs::directory_iterator(folder / "kernels"))
      files.push_back(entry.path());
    return files;
  }

  static void change_byte(const fs::path &file, size_t at) {
    std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
    stream.seekg(static_cast<std::streamoff>(at));
    const char byte = static_cast<char>(stream.get());
    stream.seekp(static_cast<std::streamoff>(at));
    stream.put(static_cast<char>(byte ^ 0x10));
  }

  fs::path folder;
  std::string path;
  const tyn::Binary binary = {1, 2, 3, 0, 255, 6, 7};
};

} // namespace

TEST_F(CacheTest, WhatWasStoredIsLoaded) {
  EXPECT_TRUE(tyn::store_binary(path, "key", binary));
  EXPECT_EQ(tyn::load_binary(path, "key"), binary);
}

TEST_F(CacheTest, StoringAgainReplaces) {
  EXPECT_TRUE(tyn::store_binary(path, "key", {9, 9}));
  EXPECT_TRUE(tyn::store_binary(path, "key", binary));
  EXPECT_EQ(tyn::load_binary(path, "key"), binary);
}

TEST_F(CacheTest, NoTemporaryFileIsLeft) {
  tyn::store_binary(path, "key", binary);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 1);
}

TEST_F(CacheTest, AMissingFileIsAMiss) { EXPECT_TRUE(tyn::load_binary(path, "key").empty()); }

TEST_F(CacheTest, AnotherKeyIsAMiss) {
  tyn::store_binary(path, "key", binary);
  EXPECT_TRUE(tyn::load_binary(path, "kez").empty());
  EXPECT_TRUE(tyn::load_binary(path, "longer key").empty());
}

TEST_F(CacheTest, EveryFlippedByteIsAMiss) {
  tyn::store_binary(path, "key", binary);
  const size_t size = fs::file_size(path);
  for (size_t at = 0; at < size; ++at) {
    change_byte(path, at);
    EXPECT_TRUE(tyn::load_binary(path, "key").empty()) << "byte " << at;
    change_byte(path, at);
  }
  EXPECT_EQ(tyn::load_binary(path, "key"), binary);
}

TEST_F(CacheTest, EveryTruncationAndAnExtensionAreMisses) {
  tyn::store_binary(path, "key", binary);
  const size_t size = fs::file_size(path);
  fs::resize_file(path, size + 1);
  EXPECT_TRUE(tyn::load_binary(path, "key").empty());
  for (size_t left = size; left-- > 0;) {
    fs::resize_file(path, left);
    EXPECT_TRUE(tyn::load_binary(path, "key").empty()) << left << " bytes left";
  }
}

TEST_F(CacheTest, AFolderInPlaceOfTheFileIsAMiss) {
  fs::create_directory(path);
  EXPECT_TRUE(tyn::load_binary(path, "key").empty());
  EXPECT_FALSE(tyn::store_binary(path, "key", binary));
}

TEST_F(CacheTest, AFileInPlaceOfTheFolderStopsNothing) {
  std::ofstream(folder / "kernels") << "not a folder";
  EXPECT_FALSE(run_from_cache());
  EXPECT_FALSE(run_from_cache());
}

TEST_F(CacheTest, AFolderThatCannotBeWrittenStopsNothing) {
  // root may write anywhere but not here
  EXPECT_FALSE(tyn::store_binary("/proc/tyndall/entry.bin", "key", binary));
  EXPECT_FALSE(tyn::store_binary("/dev/null/entry.bin", "key", binary));
}

TEST_F(CacheTest, TheSecondContextLoadsWhatTheFirstCompiled) {
  EXPECT_FALSE(run_from_cache());
  EXPECT_EQ(cached_files().size(), 1u);
  EXPECT_TRUE(run_from_cache());
  EXPECT_EQ(cached_files().size(), 1u);
}

TEST_F(CacheTest, AnUnchangedEntryIsNotWrittenAgain) {
  run_from_cache();
  const fs::path file = cached_files().at(0);
  const auto before = fs::last_write_time(file);
  EXPECT_TRUE(run_from_cache());
  EXPECT_EQ(fs::last_write_time(file), before);
}

TEST_F(CacheTest, AnotherSourceIsAMiss) {
  run_from_cache();
  const std::string other = std::string(square_text) + "// a remark\n";
  EXPECT_FALSE(run_from_cache(other.c_str()));
  EXPECT_EQ(cached_files().size(), 2u);
}

TEST_F(CacheTest, OtherOptionsAreAMiss) {
  run_from_cache(square_text, 4);
  EXPECT_FALSE(run_from_cache(square_text, 8));
  EXPECT_TRUE(run_from_cache(square_text, 4));
}

TEST_F(CacheTest, ADamagedEntryIsRebuiltAndReplaced) {
  run_from_cache();
  const fs::path file = cached_files().at(0);
  change_byte(file, fs::file_size(file) / 2);
  EXPECT_FALSE(run_from_cache());
  EXPECT_TRUE(run_from_cache());
  fs::resize_file(file, 100);
  EXPECT_FALSE(run_from_cache());
  EXPECT_TRUE(run_from_cache());
}

TEST_F(CacheTest, ABinaryThatTheDriverRefusesIsRebuilt) {
  run_from_cache();
  const fs::path file = cached_files().at(0);
  // A valid entry around nonsense, as after a driver that changed without changing its version.
  std::ifstream stream(file, std::ios::binary);
  const std::string content((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  uint64_t key_size = 0;
  std::memcpy(&key_size, content.data() + 8, sizeof key_size);
  const std::string key = content.substr(32, static_cast<size_t>(key_size));
  ASSERT_EQ(key.rfind("cache ", 0), 0u) << "the layout of the file has changed";
  ASSERT_TRUE(tyn::store_binary(file.string(), key, tyn::Binary(64, 'x')));
  EXPECT_FALSE(run_from_cache());
  EXPECT_TRUE(run_from_cache());
}

TEST_F(CacheTest, TheEnvironmentNamesTheFolder) {
  const char *names[] = {"TYNDALL_CACHE_DIR", "XDG_CACHE_HOME", "HOME"};
  std::vector<std::pair<bool, std::string>> saved;
  for (const char *name : names) {
    const char *value = std::getenv(name);
    saved.emplace_back(value != nullptr, value ? value : "");
  }
  setenv("TYNDALL_CACHE_DIR", "/a/b", 1);
  setenv("XDG_CACHE_HOME", "/x", 1);
  setenv("HOME", "/home/someone", 1);
  EXPECT_EQ(tyn::environment_cache_directory(), "/a/b");
  setenv("TYNDALL_CACHE_DIR", "", 1);
  EXPECT_EQ(tyn::environment_cache_directory(), "");
  unsetenv("TYNDALL_CACHE_DIR");
  EXPECT_EQ(tyn::environment_cache_directory(), "/x/tyndall");
  setenv("XDG_CACHE_HOME", "relative", 1);
  EXPECT_EQ(tyn::environment_cache_directory(), "/home/someone/.cache/tyndall");
  unsetenv("XDG_CACHE_HOME");
  unsetenv("HOME");
  EXPECT_EQ(tyn::environment_cache_directory(), "");
  for (size_t i = 0; i < 3; ++i) {
    if (saved[i].first)
      setenv(names[i], saved[i].second.c_str(), 1);
    else
      unsetenv(names[i]);
  }
}

TEST_F(CacheTest, TheHashIsFnv1a) {
  // Test vectors of draft-eastlake-fnv.
  EXPECT_EQ(tyn::hash_bytes("", 0), 0xcbf29ce484222325u);
  EXPECT_EQ(tyn::hash_bytes("a", 1), 0xaf63dc4c8601ec8cu);
  EXPECT_EQ(tyn::hash_bytes("foobar", 6), 0x85944171f73967e8u);
}
