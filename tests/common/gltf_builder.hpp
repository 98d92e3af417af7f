// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// glTF files made in memory, folders that clean up after themselves, and the loader called on both: no device needed.
#pragma once
#ifdef TYN_TEST_IO

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "io/gltf_scene.hpp"

namespace tyn_test {

// A folder in the system's temporary one, removed with what is in it.
class TemporaryFolder {
public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder &) = delete;
  TemporaryFolder &operator=(const TemporaryFolder &) = delete;

  std::string file(const std::string &name) const { return path + "/" + name; }
  void write(const std::string &name, const std::string &bytes) const;
  std::vector<std::string> names() const; // of what is in it, sorted

  std::string path;
};

std::string read_whole(const std::string &path);

// A model: `json` is edited directly, data goes into one buffer.
class Gltf {
public:
  // A closed tetrahedron with one material on one node.
  static Gltf tetrahedron();
  // Scenes, nodes and meshes for one primitive that has no attributes yet.
  static Gltf one_primitive();

  nlohmann::json json;
  std::string data; // of buffers[0]

  nlohmann::json &primitive(size_t index = 0) { return json["meshes"][0]["primitives"][index]; }
  nlohmann::json &material() { return json["materials"][0]; }
  nlohmann::json &material_extension(const char *name) { return json["materials"][0]["extensions"][name]; }

  // Each returns the index of what it adds.
  template <class T>
  int view(const std::vector<T> &values, int stride = 0) {
    return view_of_bytes(std::string(reinterpret_cast<const char *>(values.data()), values.size() * sizeof(T)), stride);
  }
  int view_of_bytes(const std::string &bytes, int stride = 0);
  int accessor(int buffer_view, int component_type, size_t count, const char *type);
  int floats(const std::vector<float> &values, const char *type); // VEC3, VEC2, SCALAR
  int indices(const std::vector<uint32_t> &values);

  std::string ascii() const; // with a data URI
  std::string glb() const;
};

std::string base64(const std::string &bytes);

// What loading gave.
struct Loading {
  TynStatus status = TYN_OK;
  std::string message; // of the failure
  std::vector<std::string> warnings;
  tyn::io::LoadedScene scene;

  bool warned(const std::string &part) const;
};

Loading load_file(const std::string &path, const TynGltfOptions &options = tyn_gltf_options());
Loading load_bytes(const std::string &bytes, const TynGltfOptions &options = tyn_gltf_options());
Loading load(const Gltf &model, const TynGltfOptions &options = tyn_gltf_options());

} // namespace tyn_test

#endif
