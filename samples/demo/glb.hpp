// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
//
// Writes a glTF 2.0 file in one binary piece (GLB).
#pragma once

#include "demo/mesh.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

namespace demo {

class GlbWriter {
public:
  using Json = nlohmann::ordered_json;

  explicit GlbWriter(const std::string &generator) {
    json_["asset"] = {{"version", "2.0"}, {"generator", generator}};
    json_["scene"] = 0;
    json_["scenes"] = Json::array({{{"nodes", Json::array()}}});
  }

  // What the file uses beyond glTF 2.0 itself.
  void use_extension(const std::string &name) { json_["extensionsUsed"].push_back(name); }

  size_t add_material(const Json &material) { return push(json_["materials"], material); }

  // Positions are written as `scale` times themselves.
  void add_mesh(const std::string &name, const Mesh &mesh, size_t material, float scale) {
    std::vector<Vec> positions = mesh.positions;
    for (Vec &position : positions)
      position = scale * position;
    const Json attributes = {{"POSITION", add_vectors(positions, true)}, {"NORMAL", add_vectors(mesh.normals, false)}};
    const Json primitive = {{"attributes", attributes}, {"indices", add_indices(mesh.indices)}, {"material", material}};
    const size_t index = push(json_["meshes"], {{"name", name}, {"primitives", Json::array({primitive})}});
    add_node({{"name", name}, {"mesh", index}});
  }

  void add_camera(const std::string &name, const Frame &frame, float yfov, float aspect_ratio) {
    const Json lens = {{"yfov", yfov}, {"aspectRatio", aspect_ratio}, {"znear", 0.01}};
    const size_t index = push(json_["cameras"], {{"name", name}, {"type", "perspective"}, {"perspective", lens}});
    add_node({{"name", name}, {"camera", index}, {"matrix", matrix(frame)}});
  }

  // `light` as in KHR_lights_punctual.
  void add_light(const std::string &name, const Frame &frame, const Json &light) {
    const size_t index = push(json_["extensions"]["KHR_lights_punctual"]["lights"], light);
    const Json extensions = {{"KHR_lights_punctual", {{"light", index}}}};
    add_node({{"name", name}, {"matrix", matrix(frame)}, {"extensions", extensions}});
  }

  // Throws if the file cannot be written; then there is none under that name that was not there before.
  void write(const std::string &path) {
    json_["buffers"] = Json::array({{{"byteLength", binary_.size()}}});
    std::string text = json_.dump();
    text.append(padding(text.size()), ' ');
    binary_.resize(binary_.size() + padding(binary_.size()));

    std::vector<unsigned char> file;
    append_words(file, {0x46546c67u, 2u, static_cast<uint32_t>(28 + text.size() + binary_.size())});
    append_words(file, {static_cast<uint32_t>(text.size()), 0x4e4f534au});
    file.insert(file.end(), text.begin(), text.end());
    append_words(file, {static_cast<uint32_t>(binary_.size()), 0x004e4942u});
    file.insert(file.end(), binary_.begin(), binary_.end());
    save(file, path);
  }

private:
  static size_t push(Json &array, const Json &value) {
    array.push_back(value);
    return array.size() - 1;
  }

  static size_t padding(size_t size) { return (4 - size % 4) % 4; }

  static Json matrix(const Frame &f) { // column by column
    return {f.x.x, f.x.y, f.x.z, 0, f.y.x,      f.y.y,      f.y.z,      0,
            f.z.x, f.z.y, f.z.z, 0, f.origin.x, f.origin.y, f.origin.z, 1};
  }

  static void append_words(std::vector<unsigned char> &file, std::initializer_list<uint32_t> words) {
    for (uint32_t word : words) // little-endian, as GLB asks
      for (int shift = 0; shift < 32; shift += 8)
        file.push_back(static_cast<unsigned char>(word >> shift));
  }

  static void save(const std::vector<unsigned char> &file, const std::string &path) {
    const std::string partial = path + ".part";
    std::FILE *out = std::fopen(partial.c_str(), "wb");
    if (!out)
      throw std::runtime_error(path + " cannot be written: " + std::strerror(errno));
    const bool written = std::fwrite(file.data(), 1, file.size(), out) == file.size();
    const bool closed = std::fclose(out) == 0;
    if (written && closed && std::rename(partial.c_str(), path.c_str()) == 0)
      return;
    const std::string reason = std::strerror(errno);
    std::remove(partial.c_str());
    throw std::runtime_error(path + " cannot be written: " + reason);
  }

  size_t add_view(const void *data, size_t size, int target) {
    const size_t offset = binary_.size();
    const unsigned char *bytes = static_cast<const unsigned char *>(data);
    binary_.insert(binary_.end(), bytes, bytes + size);
    return push(json_["bufferViews"],
                {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", size}, {"target", target}});
  }

  size_t add_vectors(const std::vector<Vec> &vectors, bool bounds) {
    static_assert(sizeof(Vec) == 12, "written as it lies in memory");
    Json accessor = {{"bufferView", add_view(vectors.data(), 12 * vectors.size(), 34962)},
                     {"componentType", 5126},
                     {"count", vectors.size()},
                     {"type", "VEC3"}};
    if (bounds) {
      Vec lower = vectors[0], upper = vectors[0];
      for (const Vec &v : vectors) {
        lower = {std::min(lower.x, v.x), std::min(lower.y, v.y), std::min(lower.z, v.z)};
        upper = {std::max(upper.x, v.x), std::max(upper.y, v.y), std::max(upper.z, v.z)};
      }
      accessor["min"] = {lower.x, lower.y, lower.z};
      accessor["max"] = {upper.x, upper.y, upper.z};
    }
    return push(json_["accessors"], accessor);
  }

  size_t add_indices(const std::vector<uint32_t> &indices) {
    return push(json_["accessors"], {{"bufferView", add_view(indices.data(), 4 * indices.size(), 34963)},
                                     {"componentType", 5125},
                                     {"count", indices.size()},
                                     {"type", "SCALAR"}});
  }

  void add_node(const Json &node) {
    const size_t index = push(json_["nodes"], node);
    json_["scenes"][0]["nodes"].push_back(index);
  }

  Json json_;
  std::vector<unsigned char> binary_;
};

} // namespace demo
