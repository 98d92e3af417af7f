// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Images that cannot be written or read: status FILE or FORMAT, one line, and nothing left behind.
#ifdef TYN_TEST_IO
#include <csignal>
#include <functional>

#include <gtest/gtest.h>
#include <sys/resource.h>

#include "common/gltf_builder.hpp"
#include "io/exr_load.hpp"
#include "io/film.hpp"

using tyn_test::TemporaryFolder;

namespace {

struct Outcome {
  TynStatus status = TYN_OK;
  std::string message;
};

Outcome outcome_of(const std::function<void()> &action) {
  Outcome outcome;
  try {
    action();
  } catch (const tyn::Failure &failure) {
    outcome = {failure.status, failure.what()};
  }
  return outcome;
}

void expect(const Outcome &outcome, TynStatus status, const std::string &part) {
  EXPECT_EQ(outcome.status, status) << outcome.message;
  EXPECT_NE(outcome.message.find(part), std::string::npos) << outcome.message;
  EXPECT_EQ(outcome.message.find('\n'), std::string::npos) << outcome.message;
}

// Noise, which does not compress: half a megabyte.
tyn::io::Film noisy_film() {
  tyn::io::Film film;
  film.width = film.height = 180;
  tyn::io::FilmLayer layer;
  layer.index = TYN_LAYER_BEAUTY;
  layer.name = "beauty";
  layer.channels = 4;
  uint32_t state = 1;
  for (size_t i = 0; i < size_t(180) * 180 * 4; i++) {
    state = state * 1664525u + 1013904223u;
    layer.pixels.push_back(float(state >> 8) * 0x1p-24f);
  }
  film.layers.push_back(layer);
  return film;
}

void write_exr(const std::string &path) { tyn::io::write_exr(noisy_film(), path); }

void write_png(const std::string &path) {
  const tyn::io::Film film = noisy_film();
  tyn::io::write_png(film.layers[0], film.width, film.height, tyn_png_options(), path);
}

// Lets no file of this process grow beyond some bytes, as a full disk would.
class SizeLimit {
public:
  explicit SizeLimit(rlim_t bytes) {
    handler = std::signal(SIGXFSZ, SIG_IGN); // otherwise the process would be killed
    getrlimit(RLIMIT_FSIZE, &before);
    const rlimit limit = {bytes, before.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~SizeLimit() {
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
  }

private:
  rlimit before;
  void (*handler)(int);
};

using Writer = void (*)(const std::string &path);

} // namespace

class BadImage : public testing::TestWithParam<Writer> {};

TEST_P(BadImage, FolderThatDoesNotExistIsAFileError) {
  const TemporaryFolder folder;
  const std::string path = folder.file("none/image");
  expect(outcome_of([&] { GetParam()(path); }), TYN_ERROR_FILE, "cannot write " + path + ": No such file");
}

TEST_P(BadImage, FolderInPlaceOfTheFileIsAFileError) {
  const TemporaryFolder folder;
  expect(outcome_of([&] { GetParam()(folder.path); }), TYN_ERROR_FILE, "Is a directory");
  expect(outcome_of([&] { GetParam()(""); }), TYN_ERROR_FILE, "name is empty");
  EXPECT_TRUE(folder.names().empty());
}

TEST_P(BadImage, FullDiskAtAnyPointLeavesNothingBehind) {
  for (const rlim_t bytes : {0, 1, 300, 4096, 30000, 60000}) {
    const TemporaryFolder folder;
    Outcome outcome;
    {
      const SizeLimit limit(bytes);
      outcome = outcome_of([&] { GetParam()(folder.file("image")); });
    }
    expect(outcome, TYN_ERROR_FILE, "cannot write " + folder.file("image") + ": File too large");
    EXPECT_TRUE(folder.names().empty()) << bytes;
  }
}

TEST_P(BadImage, FullDiskKeepsTheOlderFile) {
  const TemporaryFolder folder;
  folder.write("image", "the picture of yesterday");
  {
    const SizeLimit limit(1000);
    EXPECT_EQ(outcome_of([&] { GetParam()(folder.file("image")); }).status, TYN_ERROR_FILE);
  }
  EXPECT_EQ(folder.names(), std::vector<std::string>({"image"}));
  EXPECT_EQ(tyn_test::read_whole(folder.file("image")), "the picture of yesterday");
}

TEST_P(BadImage, DeviceWithoutSpaceIsAFileError) {
  expect(outcome_of([&] { GetParam()("/dev/full"); }), TYN_ERROR_FILE, "cannot write /dev/full: No space left");
}

INSTANTIATE_TEST_SUITE_P(Formats, BadImage, testing::Values(&write_exr, &write_png),
                         [](const testing::TestParamInfo<Writer> &suite) { return suite.index == 0 ? "exr" : "png"; });

TEST(BadExr, AttributeThatTheHeaderHasAlreadyIsAnInvalidArgument) {
  const TemporaryFolder folder;
  for (const char *name : {"channels", "compression", "chromaticities", "dataWindow"}) {
    tyn::io::Film film = noisy_film();
    film.attributes = {{name, "x"}};
    expect(outcome_of([&] { tyn::io::write_exr(film, folder.file("a.exr")); }), TYN_ERROR_INVALID_ARGUMENT, name);
  }
  EXPECT_TRUE(folder.names().empty());
}

TEST(BadExr, MissingFileIsAFileError) {
  const TemporaryFolder folder;
  expect(outcome_of([&] { tyn::io::read_exr(folder.file("none.exr")); }), TYN_ERROR_FILE, "none.exr: No such file");
  expect(outcome_of([&] { tyn::io::read_exr(folder.path); }), TYN_ERROR_FILE, "it is a folder");
}

TEST(BadExr, DamagedFileIsAFormatErrorOrStillAnImage) {
  const TemporaryFolder folder;
  tyn::io::Film film = noisy_film();
  film.width = film.height = 8;
  film.layers[0].pixels.resize(8 * 8 * 4);
  tyn::io::write_exr(film, folder.file("a.exr"));
  const std::string whole = tyn_test::read_whole(folder.file("a.exr"));
  for (size_t length = 0; length < whole.size(); length += 7) {
    folder.write("b.exr", whole.substr(0, length));
    const Outcome outcome = outcome_of([&] { tyn::io::read_exr(folder.file("b.exr")); });
    EXPECT_TRUE(outcome.status == TYN_ERROR_FORMAT || (outcome.status == TYN_OK && length > 400)) << length;
    EXPECT_EQ(outcome.message.find('\n'), std::string::npos) << outcome.message;
  }
  folder.write("b.exr", "not an image");
  expect(outcome_of([&] { tyn::io::read_exr(folder.file("b.exr")); }), TYN_ERROR_FORMAT, "b.exr");
}

TEST(BadExr, FileWithoutColoursIsAFormatErrorThatListsWhatItHas) {
  const TemporaryFolder folder;
  tyn::io::Film film = noisy_film();
  film.layers[0].index = TYN_LAYER_NORMAL;
  film.layers[0].channels = 3;
  film.layers[0].name = "normal";
  tyn::io::write_exr(film, folder.file("a.exr"));
  expect(outcome_of([&] { tyn::io::read_exr(folder.file("a.exr")); }), TYN_ERROR_FORMAT, "it has normal.X normal.Y");
}
#endif
