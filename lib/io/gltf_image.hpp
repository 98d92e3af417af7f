// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Images and the textures that use them.
#pragma once

#include <map>

#include "io/gltf_document.hpp"
#include "io/gltf_scene.hpp"

namespace tyn::io {

// What an image's R, G and B mean to the texture that uses it.
enum class ColorSpace { Srgb, Linear };

class GltfImages {
public:
  GltfImages(GltfDocument &source, uint64_t most_pixels, std::vector<LoadedImage> &result)
      : document(source), max_pixels(most_pixels), images(result) {}

  // Decodes image `index` of the file unless that is done. Returns its index in the loaded scene. Throws FILE and FORMAT.
  uint32_t load(int index, ColorSpace space);

private:
  Bytes encoded(int index, const std::string &where);

  GltfDocument &document;
  uint64_t max_pixels;
  std::vector<LoadedImage> &images;
  std::map<std::pair<int, ColorSpace>, uint32_t> loaded;
};

} // namespace tyn::io
