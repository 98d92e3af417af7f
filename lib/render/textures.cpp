// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "render/textures.hpp"

#include <algorithm>
#include <cmath>

#include "render/upload.hpp"

namespace tyn {
namespace {

void mark(std::vector<bool> &used, uint32_t image) {
  if (image < used.size())
    used[image] = true;
}

std::vector<bool> used_images(const TynScene &scene) {
  std::vector<bool> used(scene.images.size());
  mark(used, scene.environment.image);
  for (const Named<TynMaterial> &material : scene.materials) {
    const TynMaterial &m = material.value;
    for (const TynTexture *texture :
         {&m.base_color_texture, &m.metallic_roughness_texture, &m.normal_texture, &m.emission_texture,
          &m.transmission_texture, &m.multiscatter_color_texture, &m.scatter_strength_texture})
      mark(used, texture->image);
  }
  return used;
}

// IEC 61966-2-1.
std::vector<float> srgb_curve() {
  std::vector<float> curve(256);
  for (int i = 0; i < 256; i++) {
    const double c = i / 255.0;
    curve[size_t(i)] = float(c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
  }
  return curve;
}

} // namespace

ImageBuffers upload_images(TynScene &scene) {
  const std::vector<bool> used = used_images(scene);
  std::vector<TynImageRecord> records;
  uint64_t pixels[2] = {0, 0}; // bytes, floats
  for (size_t i = 0; i < scene.images.size(); i++) {
    const Image &image = scene.images[i];
    const bool is_float = image.format == TYN_IMAGE_RGBA32F;
    records.push_back({image.width, image.height, image.format, uint32_t(pixels[is_float])});
    if (used[i])
      pixels[is_float] += uint64_t(image.width) * image.height;
  }
  if (std::max(pixels[0], pixels[1]) > UINT32_MAX)
    fail(TYN_ERROR_OUT_OF_MEMORY, "the images have %llu pixels; at most 2^32 can be used",
         static_cast<unsigned long long>(std::max(pixels[0], pixels[1])));

  ImageBuffers buffers;
  buffers.records = upload(scene.context, records);
  buffers.bytes = Buffer(scene.context, size_t(pixels[0]) * 4, CL_MEM_READ_ONLY);
  buffers.floats = Buffer(scene.context, size_t(pixels[1]) * 16, CL_MEM_READ_ONLY);
  buffers.decode = upload(scene.context, srgb_curve());
  for (size_t i = 0; i < scene.images.size(); i++) {
    if (!used[i])
      continue;
    const Image &image = scene.images[i];
    const bool is_float = image.format == TYN_IMAGE_RGBA32F;
    scene.context.write(is_float ? buffers.floats : buffers.bytes, image.pixels.data(), image.pixels.size(),
                        size_t(records[i].first) * (is_float ? 16 : 4));
  }
  return buffers;
}

uint32_t TextureTable::add(const TynTexture &texture) {
  if (texture.image == TYN_NONE)
    return TYN_NONE;
  TynTextureRecord record{};
  record.image = texture.image;
  record.wrap_u = texture.wrap_u;
  record.wrap_v = texture.wrap_v;
  record.filter = texture.filter;
  std::copy(std::begin(texture.transform), std::end(texture.transform), record.transform);
  list.push_back(record);
  return uint32_t(list.size() - 1);
}

} // namespace tyn
