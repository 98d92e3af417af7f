// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#ifdef TYN_TEST_IO
#include "common/gltf_builder.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace tyn_test {

TemporaryFolder::TemporaryFolder() {
  std::string pattern = (std::filesystem::temp_directory_path() / "tyndall-test-XXXXXX").string();
  path = mkdtemp(&pattern[0]) ? pattern : std::string();
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  if (!path.empty())
    std::filesystem::remove_all(path, ignored);
}

void TemporaryFolder::write(const std::string &name, const std::string &bytes) const {
  std::ofstream(file(name), std::ios::binary) << bytes;
}

std::vector<std::string> TemporaryFolder::names() const {
  std::vector<std::string> result;
  for (const auto &entry : std::filesystem::directory_iterator(path))
    result.push_back(entry.path().filename().string());
  std::sort(result.begin(), result.end());
  return result;
}

std::string read_whole(const std::string &path) {
  std::ostringstream bytes;
  bytes << std::ifstream(path, std::ios::binary).rdbuf();
  return bytes.str();
}

Gltf Gltf::one_primitive() {
  Gltf model;
  model.json = nlohmann::json::parse(R"({
    "asset": {"version": "2.0"},
    "scene": 0,
    "scenes": [{"nodes": [0]}],
    "nodes": [{"mesh": 0, "name": "node"}],
    "meshes": [{"name": "mesh", "primitives": [{"attributes": {}}]}],
    "materials": [{"name": "stuff", "pbrMetallicRoughness": {"metallicFactor": 0}}]
  })");
  model.primitive()["material"] = 0;
  return model;
}

Gltf Gltf::tetrahedron() {
  Gltf model = one_primitive();
  model.primitive()["attributes"]["POSITION"] = model.floats({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, "VEC3");
  model.primitive()["indices"] = model.indices({0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3});
  return model;
}

int Gltf::view_of_bytes(const std::string &bytes, int stride) {
  nlohmann::json entry = {{"buffer", 0}, {"byteOffset", data.size()}, {"byteLength", bytes.size()}};
  if (stride)
    entry["byteStride"] = stride;
  json["bufferViews"].push_back(entry);
  data += bytes;
  data.resize((data.size() + 3) / 4 * 4);
  return int(json["bufferViews"].size()) - 1;
}

int Gltf::accessor(int buffer_view, int component_type, size_t count, const char *type) {
  nlohmann::json entry = {{"componentType", component_type}, {"count", count}, {"type", type}};
  if (buffer_view >= 0)
    entry["bufferView"] = buffer_view;
  json["accessors"].push_back(entry);
  return int(json["accessors"].size()) - 1;
}

int Gltf::floats(const std::vector<float> &values, const char *type) {
  const size_t components = std::string(type) == "SCALAR" ? 1 : size_t(type[3] - '0');
  return accessor(view(values), 5126, values.size() / components, type);
}

int Gltf::indices(const std::vector<uint32_t> &values) { return accessor(view(values), 5125, values.size(), "SCALAR"); }

std::string Gltf::ascii() const {
  nlohmann::json copy = json;
  if (!data.empty() && !copy.contains("buffers"))
    copy["buffers"] = {{{"byteLength", data.size()}, {"uri", "data:application/octet-stream;base64," + base64(data)}}};
  return copy.dump();
}

static std::string little_endian(size_t value) {
  return {char(value & 255), char(value >> 8 & 255), char(value >> 16 & 255), char(value >> 24 & 255)};
}

std::string Gltf::glb() const {
  nlohmann::json copy = json;
  if (!data.empty() && !copy.contains("buffers"))
    copy["buffers"] = {{{"byteLength", data.size()}}};
  std::string text = copy.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  std::string chunks = little_endian(text.size()) + "JSON" + text;
  if (!data.empty())
    chunks += little_endian(data.size()) + std::string("BIN\0", 4) + data;
  return "glTF" + little_endian(2) + little_endian(12 + chunks.size()) + chunks;
}

std::string base64(const std::string &bytes) {
  static const char DIGITS[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string result;
  for (size_t i = 0; i < bytes.size(); i += 3) {
    uint32_t group = 0;
    for (size_t k = 0; k < 3; k++)
      group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (size_t k = 0; k < 4; k++)
      result += i + k > bytes.size() ? '=' : DIGITS[group >> (18 - 6 * k) & 63];
  }
  return result;
}

bool Loading::warned(const std::string &part) const {
  return std::any_of(warnings.begin(), warnings.end(),
                     [&](const std::string &line) { return line.find(part) != std::string::npos; });
}

Loading load_file(const std::string &path, const TynGltfOptions &options) {
  Loading result;
  const auto collect = [](void *user, const char *line) {
    static_cast<std::vector<std::string> *>(user)->push_back(line);
  };
  tyn::io::Warnings warnings(collect, &result.warnings);
  try {
    result.scene = tyn::io::read_gltf(path, options, warnings);
  } catch (const tyn::Failure &failure) {
    result.status = failure.status;
    result.message = failure.what();
  }
  return result;
}

Loading load_bytes(const std::string &bytes, const TynGltfOptions &options) {
  const TemporaryFolder folder;
  folder.write("model", bytes);
  return load_file(folder.file("model"), options);
}

Loading load(const Gltf &model, const TynGltfOptions &options) { return load_bytes(model.ascii(), options); }

} // namespace tyn_test

#endif
