// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// A renderer's film on the host, as the image writers take it.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "io/failure.hpp"

namespace tyn::io {

struct FilmLayer {
  uint32_t index = 0; // TYN_LAYER_*
  std::string name;
  uint32_t channels = 0;
  std::vector<float> pixels; // width x height x channels, rows from top to bottom
};

struct Film {
  uint32_t width = 0, height = 0;
  std::vector<FilmLayer> layers;
  std::vector<std::pair<std::string, std::string>> attributes;
};

// Reads one layer. Throws.
FilmLayer read_layer(TynRenderer *renderer, uint32_t layer, uint32_t width, uint32_t height);

// Reads all layers, with attributes that say how they came about. Throws.
Film read_film(TynRenderer *renderer);

// The name and version of this library, for file headers.
std::string software();

// Writes a film as a multi-layer OpenEXR file. Throws FILE; INVALID_ARGUMENT for an attribute whose name is taken.
void write_exr(const Film &film, const std::string &path);

// Writes a layer as a PNG image. `options` has been checked. Throws FILE.
void write_png(const FilmLayer &layer, uint32_t width, uint32_t height, const TynPngOptions &options,
               const std::string &path);

} // namespace tyn::io
