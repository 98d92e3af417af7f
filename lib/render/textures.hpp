// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Images on the device: one buffer for 8-bit pixels, one for floats.
#pragma once

#include <vector>

#include "kernels/shared_render.h"
#include "scene/scene.hpp"

namespace tyn {

struct ImageBuffers {
  Buffer records; // TynImageRecord, one for each image of the scene
  Buffer bytes;   // 4 bytes a pixel
  Buffer floats;  // 4 floats a pixel
  Buffer decode;  // the sRGB curve of 0 .. 255
};

// Uploads the images that materials or the environment use.
ImageBuffers upload_images(TynScene &scene);

// The textures of all materials.
class TextureTable {
public:
  uint32_t add(const TynTexture &texture); // place of a new record, or TYN_NONE for no texture
  const std::vector<TynTextureRecord> &records() const { return list; }

private:
  std::vector<TynTextureRecord> list;
};

} // namespace tyn
