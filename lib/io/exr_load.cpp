// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStandardAttributes.h>

#include "io/exr_load.hpp"
#include "io/input_file.hpp"

namespace tyn::io {
namespace {

constexpr int64_t LARGEST_SIDE = 32768;           // of a TynImage
constexpr int64_t MOST_PIXELS = int64_t(1) << 27; // 2 GiB of floats

// The channels that hold R, G and B: these, or Y three times.
std::array<std::string, 3> find_channels(const Imf::Header &header) {
  const Imf::ChannelList &channels = header.channels();
  if (channels.findChannel("R") && channels.findChannel("G") && channels.findChannel("B"))
    return {"R", "G", "B"};
  const bool luminance_only = channels.findChannel("Y") && !channels.findChannel("RY") && !channels.findChannel("BY");
  if (luminance_only)
    return {"Y", "Y", "Y"};
  std::string names;
  for (auto channel = channels.begin(); channel != channels.end(); ++channel)
    names += (names.empty() ? "" : " ") + std::string(channel.name());
  fail(TYN_ERROR_FORMAT, "has no channels R G B in its first part; it has %s", printable(names).c_str());
}

void check_header(const Imf::Header &header) {
  if (header.hasType() && (header.type() == Imf::DEEPSCANLINE || header.type() == Imf::DEEPTILE))
    fail(TYN_ERROR_FORMAT, "holds deep pixels, which are not supported");
  const Imath::Box2i window = header.dataWindow();
  const int64_t width = int64_t(window.max.x) - window.min.x + 1, height = int64_t(window.max.y) - window.min.y + 1;
  if (width < 1 || height < 1 || width > LARGEST_SIDE || height > LARGEST_SIDE || width * height > MOST_PIXELS)
    fail(TYN_ERROR_FORMAT, "has %lld x %lld pixels; at most %lld a side and %lld in all are read", (long long)width,
         (long long)height, (long long)LARGEST_SIDE, (long long)MOST_PIXELS);
  for (const std::string &name : find_channels(header)) {
    const Imf::Channel &channel = *header.channels().findChannel(name);
    if (channel.xSampling != 1 || channel.ySampling != 1)
      fail(TYN_ERROR_FORMAT, "has a subsampled channel %s, which is not supported", name.c_str());
  }
}

void read_pixels(Imf::InputPart &part, ExrImage &image) {
  const Imath::Box2i window = part.header().dataWindow();
  const std::array<std::string, 3> channels = find_channels(part.header());
  const size_t pixel = 4 * sizeof(float), row = pixel * image.width;
  image.pixels.assign(size_t(image.width) * image.height * 4, 1.0f);
  // OpenEXR addresses pixels by their coordinates, which begin at the data window.
  char *origin = reinterpret_cast<char *>(image.pixels.data()) - window.min.x * std::ptrdiff_t(pixel) -
                 window.min.y * std::ptrdiff_t(row);
  Imf::FrameBuffer buffer;
  for (size_t c = 0; c < 3; c++)
    buffer.insert(channels[c], Imf::Slice(Imf::FLOAT, origin + c * sizeof(float), pixel, row));
  part.setFrameBuffer(buffer);
  part.readPixels(window.min.y, window.max.y);
  if (channels[0] == channels[1]) // one channel can be read into one place
    for (size_t i = 0; i < image.pixels.size(); i += 4)
      image.pixels[i] = image.pixels[i + 1] = image.pixels[i + 2];
}

// Into Rec.709 primaries, if the file says that it has others.
void convert_primaries(const Imf::Header &header, ExrImage &image) {
  if (!Imf::hasChromaticities(header))
    return;
  const Imf::Chromaticities rec709, &given = Imf::chromaticities(header);
  if (given.red == rec709.red && given.green == rec709.green && given.blue == rec709.blue &&
      given.white == rec709.white)
    return;
  const Imath::M44f matrix = Imf::RGBtoXYZ(given, 1) * Imf::XYZtoRGB(rec709, 1);
  for (size_t i = 0; i < image.pixels.size(); i += 4) {
    float *p = &image.pixels[i];
    const Imath::V3f converted = Imath::V3f(p[0], p[1], p[2]) * matrix;
    std::copy(&converted.x, &converted.x + 3, p);
  }
}

// A radiance is a finite number that is not negative; what a file holds besides becomes one.
void clean(ExrImage &image) {
  constexpr float BRIGHTEST = 1e30f;
  for (float &value : image.pixels)
    value = std::isnan(value) ? 0.0f : std::min(std::max(value, 0.0f), BRIGHTEST);
}

} // namespace

ExrImage read_exr(const std::string &path) {
  require_readable(path); // with a message of its own; OpenEXR's differ from version to version
  try {
    Imf::MultiPartInputFile file(path.c_str());
    check_header(file.header(0));
    Imf::InputPart part(file, 0);
    const Imath::Box2i window = part.header().dataWindow();
    ExrImage image;
    image.width = uint32_t(window.max.x - window.min.x + 1);
    image.height = uint32_t(window.max.y - window.min.y + 1);
    read_pixels(part, image);
    convert_primaries(part.header(), image);
    clean(image);
    return image;
  } catch (const Failure &failure) {
    throw Failure(failure.status, printable(path) + " " + failure.what());
  } catch (const std::bad_alloc &) {
    throw;
  } catch (const std::exception &error) {
    fail(TYN_ERROR_FORMAT, "cannot read %s: %s", printable(path).c_str(), printable(error.what()).c_str());
  }
}

} // namespace tyn::io

TynStatus tyn_exr_load(TynScene *scene, const char *path, uint32_t *image) {
  using namespace tyn::io;
  return guarded(tyn_scene_context(scene), [&] {
    if (!path || !image)
      fail(TYN_ERROR_INVALID_ARGUMENT, "%s is NULL", path ? "image" : "path");
    const ExrImage loaded = read_exr(path);
    TynImage added = tyn_image();
    added.name = path;
    added.width = loaded.width;
    added.height = loaded.height;
    added.format = TYN_IMAGE_RGBA32F;
    added.pixels = loaded.pixels.data();
    require_ok(tyn_scene_context(scene), tyn_scene_add_image(scene, &added, image));
  });
}
