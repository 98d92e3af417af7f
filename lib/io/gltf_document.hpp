// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// A glTF file in memory: tinygltf's model of its JSON, and the bytes of its buffers and images.
//
// tinygltf is handed the JSON without buffers, images and what the loader never reads. It would fetch and decode them at once,
// trusting offsets and paths; here a path is confined to the model's folder, sizes are limited, and an image is decoded when
// something uses it. The JSON has passed check_schema(), so that every index in the model exists.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <tiny_gltf.h>

#include "io/failure.hpp"
#include "io/gltf_json.hpp"

namespace tyn::io {

// An image as it lies in the file: a uri, or a buffer view.
struct GltfImage {
  std::string name;
  std::string uri;
  int buffer_view = -1;
};

class GltfDocument {
public:
  // Reads `path` with everything its buffers need. Throws FILE and FORMAT.
  GltfDocument(const std::string &path, const TynGltfOptions &limits, Warnings &warnings);

  const std::string path;
  const uint64_t max_file_bytes;
  tinygltf::Model model; // its buffers and images are empty
  std::vector<GltfImage> images;

  // The bytes of a buffer view, decompressed if need be.
  Span view(int index);
  // What a uri refers to. `where`: the JSON path, for messages.
  Bytes read_uri(const std::string &uri, uint64_t limit, const std::string &where) const;

private:
  struct Source;
  static std::vector<Source> take_sources(Json &root);
  struct Buffer {
    Bytes owned;
    Span bytes;
    bool missing = false; // no uri: allowed where only compressed buffer views refer to it
  };
  void load_buffers(const std::vector<Source> &sources, const GltfContainer &container);
  Span part(int buffer, uint64_t offset, uint64_t length, const std::string &where) const;

  Bytes file;
  std::vector<Buffer> buffers;
  std::map<int, Bytes> decompressed; // by buffer view
};

} // namespace tyn::io
