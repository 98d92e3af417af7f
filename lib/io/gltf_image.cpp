// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "io/gltf_image.hpp"

#include <algorithm>
#include <cinttypes>
#include <climits>
#include <cmath>
#include <cstring>

#include "io/image_header.hpp"

namespace tyn::io {
namespace {

constexpr uint32_t LARGEST_SIDE = 32768; // of a TynImage

void check_size(const Bytes &encoded, uint64_t max_pixels, const std::string &where) {
  const ImageSize size = image_size(encoded);
  if (size.width == 0 || size.height == 0)
    fail(TYN_ERROR_FORMAT, "%s is neither a PNG nor a JPEG image, or it is cut off", where.c_str());
  // The decoder counts bytes in int: 4 channels of 16 bits.
  const uint64_t limit = std::min<uint64_t>(max_pixels, INT_MAX / 8);
  if (size.width > LARGEST_SIDE || size.height > LARGEST_SIDE || uint64_t(size.width) * size.height > limit)
    fail(TYN_ERROR_FORMAT, "%s has %u x %u pixels; at most %u a side and %" PRIu64 " in all are read", where.c_str(),
         size.width, size.height, LARGEST_SIDE, limit);
}

float decode_srgb(float value) {
  return value <= 0.04045f ? value / 12.92f : std::pow((value + 0.055f) / 1.055f, 2.4f);
}

// 16 bits a channel do not fit into the API's 8-bit formats: floats, with the curve undone.
Bytes to_floats(const Bytes &pixels, ColorSpace space) {
  const size_t count = pixels.size() / 2;
  Bytes result(count * sizeof(float));
  for (size_t i = 0; i < count; i++) {
    uint16_t raw;
    std::memcpy(&raw, &pixels[2 * i], sizeof raw);
    float value = raw / 65535.0f;
    if (space == ColorSpace::Srgb && i % 4 != 3)
      value = decode_srgb(value);
    std::memcpy(&result[i * sizeof value], &value, sizeof value);
  }
  return result;
}

LoadedImage decode(const Bytes &encoded, ColorSpace space, const std::string &where) {
  tinygltf::Image image;
  std::string error, warning;
  if (!tinygltf::LoadImageData(&image, 0, &error, &warning, 0, 0, encoded.data(), int(encoded.size()), nullptr) ||
      image.component != 4)
    fail(TYN_ERROR_FORMAT, "%s cannot be decoded: it is damaged or of an unusual kind", where.c_str());
  LoadedImage result;
  result.width = uint32_t(image.width);
  result.height = uint32_t(image.height);
  result.format = image.bits == 16            ? TYN_IMAGE_RGBA32F
                  : space == ColorSpace::Srgb ? TYN_IMAGE_RGBA8_SRGB
                                              : TYN_IMAGE_RGBA8_LINEAR;
  result.pixels = image.bits == 16 ? to_floats(image.image, space) : std::move(image.image);
  return result;
}

} // namespace

Bytes GltfImages::encoded(int index, const std::string &where) {
  const GltfImage &image = document.images[size_t(index)];
  if (image.buffer_view >= 0) {
    const Span view = document.view(image.buffer_view);
    return Bytes(view.data, view.data + view.size);
  }
  if (image.uri.empty())
    fail(TYN_ERROR_FORMAT, "%s has neither a uri nor a bufferView", where.c_str());
  return document.read_uri(image.uri, document.max_file_bytes, where + ".uri");
}

uint32_t GltfImages::load(int index, ColorSpace space) {
  const auto known = loaded.find({index, space});
  if (known != loaded.end())
    return known->second;
  const std::string where = text("images[%d]", index);
  const Bytes bytes = encoded(index, where);
  check_size(bytes, max_pixels, where);
  if (bytes.size() > INT_MAX)
    fail(TYN_ERROR_FORMAT, "%s has %zu bytes; at most %d are read", where.c_str(), bytes.size(), INT_MAX);
  LoadedImage image = decode(bytes, space, where);
  image.name = document.images[size_t(index)].name;
  images.push_back(std::move(image));
  return loaded[{index, space}] = uint32_t(images.size() - 1);
}

} // namespace tyn::io
