// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>

#include "io/film.hpp"
#include "io/output_file.hpp"

namespace tyn::io {
namespace {

// OpenEXR's stream over an OutputFile. Failures pass through OpenEXR as exceptions, and OpenEXR may replace them by its own;
// the first one is kept.
class Stream : public Imf::OStream {
public:
  Stream(OutputFile &output, const std::string &path) : OStream(path.c_str()), file(output) {}
  void write(const char data[], int size) override {
    keep([&] { file.write(data, size_t(size)); });
  }
  uint64_t tellp() override { return file.tell(); }
  void seekp(uint64_t position) override {
    keep([&] { file.seek(position); });
  }
  void rethrow() const {
    if (!message.empty())
      throw Failure(TYN_ERROR_FILE, message);
  }

private:
  template <class Action>
  void keep(Action action) {
    try {
      action();
    } catch (const Failure &failure) {
      if (message.empty())
        message = failure.what();
      throw;
    }
  }

  OutputFile &file;
  std::string message;
};

// The beauty layer has the plain names R G B A; the others are NAME.CHANNEL.
std::string channel_name(const FilmLayer &layer, uint32_t channel) {
  const char *letters = layer.index == TYN_LAYER_NORMAL    ? "XYZ"
                        : layer.index == TYN_LAYER_DEPTH   ? "Z"
                        : layer.index == TYN_LAYER_SAMPLES ? "Y"
                                                           : "RGBA";
  const std::string letter(1, letters[channel]);
  return layer.index == TYN_LAYER_BEAUTY ? letter : layer.name + "." + letter;
}

Imf::Header make_header(const Film &film) {
  Imf::Header header(int(film.width), int(film.height));
  header.compression() = Imf::ZIP_COMPRESSION;
  Imf::addChromaticities(header, Imf::Chromaticities()); // the default is Rec.709 with D65
  for (const auto &attribute : film.attributes) {
    if (header.find(attribute.first.c_str()) != header.end() && attribute.first.rfind("tyndall:", 0) != 0)
      fail(TYN_ERROR_INVALID_ARGUMENT, "the attribute \"%s\" is one that an OpenEXR file has already",
           printable(attribute.first).c_str());
    header.insert(attribute.first.c_str(), Imf::StringAttribute(attribute.second));
  }
  for (const FilmLayer &layer : film.layers)
    for (uint32_t c = 0; c < layer.channels; c++)
      header.channels().insert(channel_name(layer, c), Imf::Channel(Imf::FLOAT));
  return header;
}

Imf::FrameBuffer make_frame_buffer(const Film &film) {
  Imf::FrameBuffer buffer;
  for (const FilmLayer &layer : film.layers)
    for (uint32_t c = 0; c < layer.channels; c++) {
      char *base = reinterpret_cast<char *>(const_cast<float *>(layer.pixels.data() + c)); // it is only read
      const size_t pixel = layer.channels * sizeof(float);
      buffer.insert(channel_name(layer, c), Imf::Slice(Imf::FLOAT, base, pixel, pixel * film.width));
    }
  return buffer;
}

void write_pixels(const Film &film, Stream &stream) {
  Imf::OutputFile file(stream, make_header(film));
  file.setFrameBuffer(make_frame_buffer(film));
  file.writePixels(int(film.height));
} // the destructor writes the table of offsets, and swallows exceptions

} // namespace

void write_exr(const Film &film, const std::string &path) {
  OutputFile output(path);
  Stream stream(output, path);
  try {
    write_pixels(film, stream);
  } catch (const Failure &) {
    throw;
  } catch (const std::exception &error) {
    stream.rethrow();
    fail(TYN_ERROR_FILE, "cannot write %s: %s", printable(path).c_str(), printable(error.what()).c_str());
  }
  stream.rethrow();
  output.commit();
}

} // namespace tyn::io
