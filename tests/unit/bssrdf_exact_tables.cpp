// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The tables of the exact model: kept on disk, made anew where that is damaged, cancelled while they are made.
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "common/bssrdf_model.hpp"

namespace fs = std::filesystem;

namespace {

using namespace tyn_test;

class ExactTables : public testing::Test {
protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "tyndall-exact-XXXXXX").string();
    ASSERT_NE(mkdtemp(&pattern[0]), nullptr);
    folder = pattern;
    TynContextOptions context_options = tyn_context_options();
    context_options.cache_directory = pattern.c_str();
    ASSERT_EQ(tyn_context_create(&context_options, &context), TYN_OK);
    options.model = TYN_BSSRDF_EXACT;
    options.exact_events = 1000000;
    options.user = this;
    options.progress = [](void *user, double fraction) {
      auto *self = static_cast<ExactTables *>(user);
      self->fractions.push_back(fraction);
      return int32_t(self->cancelling);
    };
  }
  void TearDown() override {
    tyn_context_release(context);
    fs::permissions(folder, fs::perms::owner_all);
    fs::remove_all(folder);
  }

  std::vector<float> profile() {
    fractions.clear();
    return BssrdfModel(slab.view(), options, context).profile({0.01f, 0.1f, 1, 3, 10});
  }
  bool made() const { return !fractions.empty(); } // progress is of making only

  fs::path file() const {
    for (const fs::directory_entry &entry : fs::directory_iterator(folder))
      if (entry.path().filename().string().rfind("exact-", 0) == 0)
        return entry.path();
    return {};
  }

  fs::path folder;
  TynContext *context = nullptr;
  TynBssrdfOptions options = tyn_bssrdf_options();
  ExactSlab slab{{{0.1, 0.9, 0.3, 1.2, INFINITY}}};
  std::vector<double> fractions;
  bool cancelling = false;
};

// Also where no folder is named, on PoCL, too, whose compiled kernels need none.
TEST_F(ExactTables, AreKeptInTheUsersCacheByDefault) {
  setenv("XDG_CACHE_HOME", folder.c_str(), 1);
  unsetenv("TYNDALL_CACHE_DIR");
  tyn_context_release(context);
  ASSERT_EQ(tyn_context_create(nullptr, &context), TYN_OK);
  const std::vector<float> first = profile();
  EXPECT_TRUE(made());
  EXPECT_TRUE(fs::exists(folder / "tyndall"));
  EXPECT_EQ(profile(), first);
  EXPECT_FALSE(made());
}

TEST_F(ExactTables, AreMadeOnceAndReadAgain) {
  const std::vector<float> first = profile();
  EXPECT_TRUE(made());
  EXPECT_EQ(fractions.back(), 1.0);
  EXPECT_TRUE(fs::exists(file()));
  EXPECT_EQ(profile(), first);
  EXPECT_FALSE(made());
}

TEST_F(ExactTables, ServeEveryAlbedoAndScale) {
  profile();
  ExactSlab other({{20, 50, 0.3, 1.2, INFINITY}});
  fractions.clear();
  BssrdfModel(other.view(), options, context);
  EXPECT_FALSE(made());
  ExactSlab anisotropic({{20, 50, 0.4, 1.2, INFINITY}});
  BssrdfModel(anisotropic.view(), options, context);
  EXPECT_TRUE(made());
}

TEST_F(ExactTables, AreMadeAnewWhereTheFileIsDamaged) {
  const std::vector<float> first = profile();
  const auto size = fs::file_size(file());
  for (const uintmax_t at : {uintmax_t(0), uintmax_t(20), size / 2, size - 1}) {
    std::fstream stream(file(), std::ios::in | std::ios::out | std::ios::binary);
    stream.seekg(std::streamoff(at));
    const int byte = stream.get();
    stream.seekp(std::streamoff(at));
    stream.put(char(byte ^ 0x55));
    stream.close();
    EXPECT_EQ(profile(), first) << at;
    EXPECT_TRUE(made()) << at;
  }
  for (const uintmax_t length : {uintmax_t(0), uintmax_t(100), size - 8}) {
    fs::resize_file(file(), length);
    EXPECT_EQ(profile(), first) << length;
    EXPECT_TRUE(made()) << length;
  }
  EXPECT_EQ(profile(), first);
  EXPECT_FALSE(made());
}

TEST_F(ExactTables, AreNotKeptWhenCancelled) {
  cancelling = true;
  TynBssrdf *made_bssrdf = nullptr;
  EXPECT_EQ(tyn_bssrdf_create(context, &slab.view(), &options, &made_bssrdf), TYN_ERROR_CANCELLED);
  EXPECT_EQ(made_bssrdf, nullptr);
  EXPECT_TRUE(file().empty());
  cancelling = false;
  EXPECT_GT(profile()[0], 0);
}

// More walks, a smaller error: one tenth of it with a hundred times the events.
TEST_F(ExactTables, SayTheirErrors) {
  const BssrdfModel few(slab.view(), options, context);
  options.exact_events *= 100;
  const BssrdfModel many(slab.view(), options, context);
  const std::vector<float> radii = {1, 2, 4};
  const std::vector<float> rough = few.profile_error(radii), fine = many.profile_error(radii), r = few.profile(radii);
  for (size_t i = 0; i < radii.size(); ++i) {
    EXPECT_GT(rough[i], 0);
    EXPECT_LT(rough[i], 0.05f * r[i]);
    EXPECT_LT(fine[i], 0.6f * rough[i]); // rings are joined until they are known to 1 %
  }
}

TEST_F(ExactTables, AreExactForOtherModels) {
  for (float error : half_space_model(TYN_BSSRDF_BETTER_DIPOLE, 0.9).profile_error({0.1f, 1, 10}))
    EXPECT_EQ(error, 0);
}

} // namespace
