// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <csetjmp>
#include <limits>

#include <png.h>

#include "io/film.hpp"
#include "io/output_file.hpp"

namespace tyn::io {
namespace {

using Row = std::vector<unsigned char>;

float srgb_curve(float v) { return v <= 0.0031308f ? 12.92f * v : 1.055f * std::pow(v, 1 / 2.4f) - 0.055f; }

// Narkowicz 2015, "ACES Filmic Tone Mapping Curve".
float aces_curve(float v) { return v * (2.51f * v + 0.03f) / (v * (2.43f * v + 0.59f) + 0.14f); }

unsigned char to_byte(float v) {
  return v > 0 ? static_cast<unsigned char>(std::min(v, 1.0f) * 255 + 0.5f) : 0; // a NaN is not > 0
}

bool is_color(const FilmLayer &layer) {
  return layer.index != TYN_LAYER_NORMAL && layer.index != TYN_LAYER_DEPTH && layer.index != TYN_LAYER_SAMPLES;
}

// Turns the pixels of one layer into bytes.
class Mapping {
public:
  Mapping(const FilmLayer &source, const TynPngOptions &given)
      : layer(source), options(given), alpha(given.transparent && source.channels == 4),
        gain(std::exp2(given.exposure)) {
    find_range();
  }

  bool has_alpha() const { return alpha; }

  // What the text chunk says.
  std::string name() const {
    if (layer.index == TYN_LAYER_NORMAL)
      return "none (0.5 + 0.5 n)";
    if (!is_color(layer))
      return text("none (linear, %g black to %g white)", layer.index == TYN_LAYER_DEPTH ? double(high) : 0.0,
                  layer.index == TYN_LAYER_DEPTH ? double(low) : double(high));
    return text("%s, exposure %+g stops", options.tone == TYN_TONE_ACES ? "ACES (Narkowicz 2015) and sRGB" : "sRGB",
                double(options.exposure));
  }

  void map(const float *pixel, unsigned char *bytes) const {
    if (!is_color(layer))
      return map_data(pixel, bytes);
    const float a = alpha ? std::min(std::max(pixel[3], 0.0f), 1.0f) : 1.0f;
    for (int c = 0; c < 3; c++) // PNG's alpha is not premultiplied
      bytes[c] = a > 0 ? to_byte(tone(pixel[c] / a * gain)) : 0;
    if (alpha)
      bytes[3] = to_byte(a);
  }

private:
  float tone(float v) const {
    if (!(v > 0))
      return 0;
    v = std::min(v, 1e6f); // far above white; keeps the rational curve finite
    return srgb_curve(std::min(options.tone == TYN_TONE_ACES ? aces_curve(v) : v, 1.0f));
  }

  void map_data(const float *pixel, unsigned char *bytes) const {
    for (uint32_t c = 0; c < 3; c++) {
      if (layer.index == TYN_LAYER_NORMAL)
        bytes[c] = to_byte(0.5f + 0.5f * pixel[c]);
      else if (layer.index == TYN_LAYER_DEPTH) // near is white, nothing is black
        bytes[c] = to_byte(high > low ? (high - pixel[0]) / (high - low) : 1.0f * std::isfinite(pixel[0]));
      else
        bytes[c] = to_byte(high > 0 ? pixel[0] / high : 0);
    }
  }

  void find_range() {
    if (layer.channels != 1)
      return;
    for (const float v : layer.pixels) {
      low = std::isfinite(v) ? std::min(low, v) : low;
      high = std::isfinite(v) ? std::max(high, v) : high;
    }
    if (low > high)
      low = high = 0;
  }

  const FilmLayer &layer;
  const TynPngOptions &options;
  bool alpha;
  float gain;
  float low = std::numeric_limits<float>::max(), high = std::numeric_limits<float>::lowest();
};

// What libpng's callbacks need. They are C: an exception must not pass through libpng, so it is kept here.
struct Sink {
  OutputFile *file;
  std::string message; // why writing failed
};

void on_write(png_structp png, png_bytep data, size_t size) {
  Sink &sink = *static_cast<Sink *>(png_get_io_ptr(png));
  bool failed = false;
  try {
    sink.file->write(data, size);
  } catch (const Failure &failure) {
    sink.message = failure.what();
    failed = true;
  }
  if (failed) // outside the handler: libpng leaves by longjmp
    png_error(png, "write error");
}

void on_flush(png_structp) {}

void on_error(png_structp png, png_const_charp message) {
  Sink &sink = *static_cast<Sink *>(png_get_error_ptr(png));
  if (sink.message.empty())
    sink.message = std::string("cannot write a PNG: ") + message;
  png_longjmp(png, 1);
}

void on_warning(png_structp, png_const_charp) {}

void add_texts(png_structp png, png_infop info, const char *software_name, const char *tone) {
  png_text texts[2] = {};
  const char *keys[2] = {"Software", "Tone mapping"}, *values[2] = {software_name, tone};
  for (int i = 0; i < 2; i++) {
    texts[i].compression = PNG_TEXT_COMPRESSION_NONE;
    texts[i].key = const_cast<char *>(keys[i]);
    texts[i].text = const_cast<char *>(values[i]);
  }
  png_set_text(png, info, texts, 2);
}

// Writes everything; false if libpng jumped out. Holds nothing that needs a destructor, which a longjmp would skip.
bool write_all(png_structp png, png_infop info, const Mapping &mapping, const FilmLayer &layer, uint32_t width,
               uint32_t height, const char *software_name, const char *tone, unsigned char *row) {
  if (setjmp(png_jmpbuf(png)))
    return false;
  const int channels = mapping.has_alpha() ? 4 : 3;
  png_set_IHDR(png, info, width, height, 8, channels == 4 ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB,
               PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
  add_texts(png, info, software_name, tone);
  png_write_info(png, info);
  for (uint32_t y = 0; y < height; y++) {
    for (uint32_t x = 0; x < width; x++)
      mapping.map(&layer.pixels[(size_t(y) * width + x) * layer.channels], row + size_t(x) * size_t(channels));
    png_write_row(png, row);
  }
  png_write_end(png, info);
  return true;
}

} // namespace

void write_png(const FilmLayer &layer, uint32_t width, uint32_t height, const TynPngOptions &options,
               const std::string &path) {
  OutputFile file(path);
  const Mapping mapping(layer, options);
  const std::string tone = mapping.name(), software_name = software();
  Row row(size_t(width) * 4);
  Sink sink{&file, ""};
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &sink, on_error, on_warning);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  if (!info) {
    png_destroy_write_struct(&png, nullptr);
    throw std::bad_alloc();
  }
  png_set_write_fn(png, &sink, on_write, on_flush);
  const bool written =
      write_all(png, info, mapping, layer, width, height, software_name.c_str(), tone.c_str(), row.data());
  png_destroy_write_struct(&png, &info);
  if (!written)
    throw Failure(TYN_ERROR_FILE, sink.message);
  file.commit();
}

} // namespace tyn::io
