// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// OpenEXR and PNG out, OpenEXR in: files are read back with OpenEXR and libpng themselves.
#ifdef TYN_TEST_IO
#include <cmath>
#include <cstring>
#include <filesystem>

#include <sys/stat.h>
#include <unistd.h>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <gtest/gtest.h>
#include <png.h>

#include "common/gltf_builder.hpp"
#include "io/exr_load.hpp"
#include "io/film.hpp"
#include "io/output_file.hpp"

using tyn::io::Film;
using tyn::io::FilmLayer;
using tyn_test::TemporaryFolder;

namespace {

FilmLayer make_layer(uint32_t index, const char *name, uint32_t channels, size_t pixels) {
  FilmLayer layer;
  layer.index = index;
  layer.name = name;
  layer.channels = channels;
  for (size_t i = 0; i < pixels * channels; i++)
    layer.pixels.push_back(float(index) + 0.001f * float(i));
  return layer;
}

// Three by two pixels with every layer.
Film small_film() {
  Film film;
  film.width = 3;
  film.height = 2;
  const char *const names[] = {"beauty", "subsurface", "specular", "diffuse", "emission",
                               "albedo", "normal",     "depth",    "samples", "variance"};
  const uint32_t channels[] = {4, 3, 3, 3, 3, 3, 3, 1, 1, 3};
  for (uint32_t i = 0; i < TYN_LAYER_COUNT; i++)
    film.layers.push_back(make_layer(i, names[i], channels[i], 6));
  film.layers[TYN_LAYER_DEPTH].pixels[0] = INFINITY;
  film.attributes = {{"software", "test"}, {"tyndall:seed", "18446744073709551615"}, {"artist", "me"}};
  return film;
}

std::vector<float> read_channel(Imf::InputFile &file, const char *name) {
  const Imath::Box2i window = file.header().dataWindow();
  const int width = window.max.x + 1, height = window.max.y + 1;
  std::vector<float> pixels(size_t(width) * size_t(height));
  Imf::FrameBuffer buffer;
  buffer.insert(name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char *>(pixels.data()), sizeof(float),
                                 sizeof(float) * size_t(width)));
  file.setFrameBuffer(buffer);
  file.readPixels(window.min.y, window.max.y);
  return pixels;
}

struct Png {
  png_image image;
  std::vector<unsigned char> pixels;
};

Png read_png(const std::string &path, uint32_t format) {
  Png png;
  std::memset(&png.image, 0, sizeof png.image);
  png.image.version = PNG_IMAGE_VERSION;
  EXPECT_TRUE(png_image_begin_read_from_file(&png.image, path.c_str())) << png.image.message;
  png.image.format = format;
  png.pixels.resize(PNG_IMAGE_SIZE(png.image));
  EXPECT_TRUE(png_image_finish_read(&png.image, nullptr, png.pixels.data(), 0, nullptr)) << png.image.message;
  return png;
}

FilmLayer beauty(const std::vector<float> &pixels) {
  FilmLayer layer;
  layer.index = TYN_LAYER_BEAUTY;
  layer.name = "beauty";
  layer.channels = 4;
  layer.pixels = pixels;
  return layer;
}

// Writes one row of pixels and reads it back.
std::vector<unsigned char> through_png(const FilmLayer &layer, const TynPngOptions &options, uint32_t format) {
  const TemporaryFolder folder;
  const uint32_t width = uint32_t(layer.pixels.size() / layer.channels);
  tyn::io::write_png(layer, width, 1, options, folder.file("a.png"));
  return read_png(folder.file("a.png"), format).pixels;
}

// Writes R G B, or other channels, as half or float.
void write_simple_exr(const std::string &path, const std::vector<std::string> &names, const std::vector<float> &values,
                      Imath::Box2i window, const Imf::Chromaticities *chromaticities = nullptr) {
  Imf::Header header(window, window);
  if (chromaticities)
    Imf::addChromaticities(header, *chromaticities);
  Imf::FrameBuffer buffer;
  std::vector<float> pixels = values;
  const int width = window.max.x - window.min.x + 1;
  const size_t count = names.size();
  for (size_t c = 0; c < count; c++) {
    header.channels().insert(names[c], Imf::Channel(Imf::FLOAT));
    char *base = reinterpret_cast<char *>(&pixels[c]) -
                 (window.min.x + window.min.y * width) * std::ptrdiff_t(count * sizeof(float));
    buffer.insert(names[c], Imf::Slice(Imf::FLOAT, base, count * sizeof(float), count * sizeof(float) * size_t(width)));
  }
  Imf::OutputFile file(path.c_str(), header);
  file.setFrameBuffer(buffer);
  file.writePixels(window.max.y - window.min.y + 1);
}

} // namespace

TEST(Exr, HoldsEveryLayerUnderItsName) {
  const TemporaryFolder folder;
  const Film film = small_film();
  tyn::io::write_exr(film, folder.file("film.exr"));
  EXPECT_EQ(folder.names(), std::vector<std::string>({"film.exr"}));
  Imf::InputFile file(folder.file("film.exr").c_str());
  std::vector<std::string> names;
  for (auto channel = file.header().channels().begin(); channel != file.header().channels().end(); ++channel) {
    names.push_back(channel.name());
    EXPECT_EQ(channel.channel().type, Imf::FLOAT);
  }
  EXPECT_EQ(names, std::vector<std::string>({"A",
                                             "B",
                                             "G",
                                             "R",
                                             "albedo.B",
                                             "albedo.G",
                                             "albedo.R",
                                             "depth.Z",
                                             "diffuse.B",
                                             "diffuse.G",
                                             "diffuse.R",
                                             "emission.B",
                                             "emission.G",
                                             "emission.R",
                                             "normal.X",
                                             "normal.Y",
                                             "normal.Z",
                                             "samples.Y",
                                             "specular.B",
                                             "specular.G",
                                             "specular.R",
                                             "subsurface.B",
                                             "subsurface.G",
                                             "subsurface.R",
                                             "variance.B",
                                             "variance.G",
                                             "variance.R"}));
  EXPECT_EQ(file.header().compression(), Imf::ZIP_COMPRESSION);
  for (size_t i = 0; i < 6; i++) {
    EXPECT_EQ(read_channel(file, "A")[i], film.layers[TYN_LAYER_BEAUTY].pixels[4 * i + 3]);
    EXPECT_EQ(read_channel(file, "subsurface.G")[i], film.layers[TYN_LAYER_SUBSURFACE].pixels[3 * i + 1]);
    EXPECT_EQ(read_channel(file, "depth.Z")[i], film.layers[TYN_LAYER_DEPTH].pixels[i]);
  }
}

TEST(Exr, SaysHowItCameAbout) {
  const TemporaryFolder folder;
  tyn::io::write_exr(small_film(), folder.file("film.exr"));
  const Imf::InputFile file(folder.file("film.exr").c_str());
  EXPECT_EQ(file.header().typedAttribute<Imf::StringAttribute>("software").value(), "test");
  EXPECT_EQ(file.header().typedAttribute<Imf::StringAttribute>("tyndall:seed").value(), "18446744073709551615");
  EXPECT_EQ(file.header().typedAttribute<Imf::StringAttribute>("artist").value(), "me");
  ASSERT_TRUE(Imf::hasChromaticities(file.header()));
  EXPECT_FLOAT_EQ(Imf::chromaticities(file.header()).red.x, 0.64f);
  EXPECT_FLOAT_EQ(Imf::chromaticities(file.header()).white.y, 0.329f);
}

TEST(Exr, SameFilmGivesTheSameBytes) {
  const TemporaryFolder folder;
  tyn::io::write_exr(small_film(), folder.file("a.exr"));
  tyn::io::write_exr(small_film(), folder.file("b.exr"));
  EXPECT_EQ(tyn_test::read_whole(folder.file("a.exr")), tyn_test::read_whole(folder.file("b.exr")));
}

TEST(Exr, ReplacesAnOlderFileAndNoOther) {
  const TemporaryFolder folder;
  folder.write("film.exr", "old");
  folder.write("film.exr.part", "the user's");
  tyn::io::write_exr(small_film(), folder.file("film.exr"));
  EXPECT_EQ(folder.names(), std::vector<std::string>({"film.exr", "film.exr.part"}));
  EXPECT_GT(tyn_test::read_whole(folder.file("film.exr")).size(), 500u);
  EXPECT_EQ(tyn_test::read_whole(folder.file("film.exr.part")), "the user's");
}

TEST(OutputFile, TwoWritersOfOneNameDoNotMix) {
  const TemporaryFolder folder;
  {
    tyn::io::OutputFile first(folder.file("out")), second(folder.file("out")), third(folder.file("out"));
    first.write("first", 5);
    second.write("second", 6);
    third.write("third", 5); // never committed
    EXPECT_EQ(folder.names().size(), 3u);
    second.commit();
    EXPECT_EQ(tyn_test::read_whole(folder.file("out")), "second");
    first.commit();
  }
  EXPECT_EQ(tyn_test::read_whole(folder.file("out")), "first");
  EXPECT_EQ(folder.names(), std::vector<std::string>({"out"}));
}

TEST(OutputFile, TakesItsModeFromTheUmaskAndTheLongestName) {
  const TemporaryFolder folder;
  const std::string path = folder.file(std::string(255, 'x'));
  const mode_t before = umask(027);
  tyn::io::OutputFile(path).commit();
  umask(before);
  struct stat info;
  ASSERT_EQ(stat(path.c_str(), &info), 0);
  EXPECT_EQ(info.st_mode & 07777, 0640u);
}

TEST(Exr, GoesThroughASymbolicLinkAndToADevice) {
  const TemporaryFolder folder;
  folder.write("target.exr", "old");
  ASSERT_EQ(symlink("target.exr", folder.file("link.exr").c_str()), 0);
  tyn::io::write_exr(small_film(), folder.file("link.exr"));
  EXPECT_EQ(folder.names(), std::vector<std::string>({"link.exr", "target.exr"}));
  EXPECT_EQ(tyn::io::read_exr(folder.file("target.exr")).width, 3u);
  tyn::io::write_exr(small_film(), "/dev/null");
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST(Exr, LoadsItsOwnFiles) {
  const TemporaryFolder folder;
  const Film film = small_film();
  tyn::io::write_exr(film, folder.file("film.exr"));
  const tyn::io::ExrImage image = tyn::io::read_exr(folder.file("film.exr"));
  ASSERT_EQ(image.width, 3u);
  ASSERT_EQ(image.height, 2u);
  for (size_t i = 0; i < 6; i++) {
    EXPECT_EQ(image.pixels[4 * i], film.layers[0].pixels[4 * i]);
    EXPECT_EQ(image.pixels[4 * i + 2], film.layers[0].pixels[4 * i + 2]);
    EXPECT_EQ(image.pixels[4 * i + 3], 1);
  }
}

TEST(Exr, LoadsADataWindowThatDoesNotStartAtZero) {
  const TemporaryFolder folder;
  write_simple_exr(folder.file("a.exr"), {"R", "G", "B"}, {1, 2, 3, 4, 5, 6}, {{-7, 11}, {-6, 11}});
  const tyn::io::ExrImage image = tyn::io::read_exr(folder.file("a.exr"));
  EXPECT_EQ(image.pixels, std::vector<float>({1, 2, 3, 1, 4, 5, 6, 1}));
}

TEST(Exr, LoadsLuminanceAsGrey) {
  const TemporaryFolder folder;
  write_simple_exr(folder.file("a.exr"), {"Y"}, {0.5f, 2}, {{0, 0}, {1, 0}});
  EXPECT_EQ(tyn::io::read_exr(folder.file("a.exr")).pixels, std::vector<float>({0.5f, 0.5f, 0.5f, 1, 2, 2, 2, 1}));
}

TEST(Exr, LoadsOtherPrimariesAsRec709) {
  const TemporaryFolder folder;
  // Red and green exchanged: so are the channels then.
  const Imf::Chromaticities rec709;
  const Imf::Chromaticities exchanged(rec709.green, rec709.red, rec709.blue, rec709.white);
  write_simple_exr(folder.file("a.exr"), {"R", "G", "B"}, {1, 2, 3}, {{0, 0}, {0, 0}}, &exchanged);
  const tyn::io::ExrImage image = tyn::io::read_exr(folder.file("a.exr"));
  EXPECT_NEAR(image.pixels[0], 2, 1e-4);
  EXPECT_NEAR(image.pixels[1], 1, 1e-4);
  EXPECT_NEAR(image.pixels[2], 3, 1e-4);
}

TEST(Exr, LoadsOnlyFiniteRadiance) {
  const TemporaryFolder folder;
  write_simple_exr(folder.file("a.exr"), {"R", "G", "B"}, {NAN, -1, INFINITY}, {{0, 0}, {0, 0}});
  const tyn::io::ExrImage image = tyn::io::read_exr(folder.file("a.exr"));
  EXPECT_EQ(image.pixels[0], 0);
  EXPECT_EQ(image.pixels[1], 0);
  EXPECT_TRUE(std::isfinite(image.pixels[2]) && image.pixels[2] > 1e29f);
}

TEST(Png, AppliesTheSrgbCurveAndClamps) {
  const FilmLayer layer = beauty({0, 0.0025f, 0.18f, 1, 0.5f, 1, 100, 1, NAN, -1, INFINITY, 1});
  const std::vector<unsigned char> expected = {0, 8, 118, 188, 255, 255, 0, 0, 255}; // IEC 61966-2-1
  EXPECT_EQ(through_png(layer, tyn_png_options(), PNG_FORMAT_RGB), expected);
}

TEST(Png, ExposureIsInStops) {
  TynPngOptions options = tyn_png_options();
  options.exposure = 1;
  EXPECT_EQ(through_png(beauty({0.25f, 0.25f, 0.25f, 1}), options, PNG_FORMAT_RGB)[0], 188);
  options.exposure = -1;
  EXPECT_EQ(through_png(beauty({1, 1, 1, 1}), options, PNG_FORMAT_RGB)[0], 188);
}

TEST(Png, AcesCurveCompressesHighlights) {
  TynPngOptions options = tyn_png_options();
  options.tone = TYN_TONE_ACES;
  // x (2.51 x + 0.03) / (x (2.43 x + 0.59) + 0.14) at 1 is 2.54 / 3.16 = 0.8038, and 231.6 with the sRGB curve.
  const std::vector<unsigned char> bytes = through_png(beauty({1, 0, INFINITY, 1}), options, PNG_FORMAT_RGB);
  EXPECT_EQ(bytes, std::vector<unsigned char>({232, 0, 255}));
}

TEST(Png, TransparencyIsNotPremultiplied) {
  TynPngOptions options = tyn_png_options();
  options.transparent = 1;
  const std::vector<unsigned char> bytes =
      through_png(beauty({0.25f, 0.25f, 0.25f, 0.5f, 1, 1, 1, 0}), options, PNG_FORMAT_RGBA);
  EXPECT_EQ(bytes, std::vector<unsigned char>({188, 188, 188, 128, 0, 0, 0, 0}));
}

TEST(Png, DataLayersAreShownWithoutAToneCurve) {
  FilmLayer normal = beauty({0, 0, 1, -1, 1, 0});
  normal.index = TYN_LAYER_NORMAL;
  normal.channels = 3;
  EXPECT_EQ(through_png(normal, tyn_png_options(), PNG_FORMAT_RGB),
            std::vector<unsigned char>({128, 128, 255, 0, 255, 128}));
  FilmLayer depth = beauty({1, 2, 3, INFINITY});
  depth.index = TYN_LAYER_DEPTH;
  depth.channels = 1;
  EXPECT_EQ(through_png(depth, tyn_png_options(), PNG_FORMAT_GRAY), std::vector<unsigned char>({255, 128, 0, 0}));
  FilmLayer samples = beauty({0, 4, 8});
  samples.index = TYN_LAYER_SAMPLES;
  samples.channels = 1;
  EXPECT_EQ(through_png(samples, tyn_png_options(), PNG_FORMAT_GRAY), std::vector<unsigned char>({0, 128, 255}));
}

TEST(Png, NamesItsToneMappingAndIsMarkedAsSrgb) {
  const TemporaryFolder folder;
  TynPngOptions options = tyn_png_options();
  options.tone = TYN_TONE_ACES;
  options.exposure = 0.5f;
  tyn::io::write_png(beauty({1, 1, 1, 1}), 1, 1, options, folder.file("a.png"));
  EXPECT_EQ(folder.names(), std::vector<std::string>({"a.png"}));
  const std::string bytes = tyn_test::read_whole(folder.file("a.png"));
  EXPECT_NE(bytes.find("sRGB"), std::string::npos);
  const std::string end(1, '\0'); // of a keyword
  EXPECT_NE(bytes.find("Tone mapping" + end + "ACES (Narkowicz 2015) and sRGB, exposure +0.5 stops"),
            std::string::npos);
  EXPECT_NE(bytes.find("Software" + end + "Tyndall"), std::string::npos);
}
#endif
