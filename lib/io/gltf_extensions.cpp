// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <string>
#include <vector>

#include "io/failure.hpp"
#include "io/gltf_json.hpp"

namespace tyn::io {
namespace {

// What the loader understands, or knows to be harmless to ignore (then it warns where the extension is used).
const char *const SUPPORTED[] = {
    "EXT_mesh_manifold",
    "EXT_meshopt_compression",
    "KHR_lights_punctual",
    "KHR_materials_diffuse_transmission",
    "KHR_materials_emissive_strength",
    "KHR_materials_ior",
    "KHR_materials_scatter",
    "KHR_materials_transmission",
    "KHR_materials_unlit",
    "KHR_materials_volume",
    "KHR_materials_volume_scatter",
    "KHR_mesh_quantization",
    "KHR_meshopt_compression",
    "KHR_texture_transform",
};

bool is_supported(const std::string &name) {
  return std::any_of(std::begin(SUPPORTED), std::end(SUPPORTED), [&](const char *known) { return name == known; });
}

void check_version(const Json &root) {
  const auto asset = root.find("asset");
  if (asset == root.end() || !asset->is_object() || !asset->contains("version"))
    fail(TYN_ERROR_FORMAT, "asset.version is missing: not a glTF 2.0 file");
  for (const char *key : {"version", "minVersion"}) {
    if (!asset->contains(key))
      continue;
    const Json &version = (*asset)[key];
    if (!version.is_string() || version.get_ref<const std::string &>().rfind("2.", 0) != 0)
      fail(TYN_ERROR_FORMAT, "asset.%s is %s; only glTF 2.x is supported", key, printable(version.dump()).c_str());
  }
}

std::vector<std::string> names(const Json &root, const char *key) {
  std::vector<std::string> result;
  const auto list = root.find(key);
  if (list == root.end())
    return result;
  for (const Json &name : *list) {
    if (!name.is_string())
      fail(TYN_ERROR_FORMAT, "%s[%zu] is not a string", key, result.size());
    result.push_back(name.get<std::string>());
  }
  return result;
}

} // namespace

std::vector<std::string> check_extensions(const Json &root) {
  check_version(root);
  for (const std::string &name : names(root, "extensionsRequired")) {
    if (name == "KHR_draco_mesh_compression")
      fail(TYN_ERROR_FORMAT, "the model requires KHR_draco_mesh_compression, which is not supported: save it without "
                             "compression or with EXT_meshopt_compression");
    if (!is_supported(name))
      fail(TYN_ERROR_FORMAT, "the model requires the extension %s, which is not supported", printable(name).c_str());
  }
  std::vector<std::string> ignored;
  for (const std::string &name : names(root, "extensionsUsed"))
    if (!is_supported(name))
      ignored.push_back(printable(name));
  return ignored;
}

} // namespace tyn::io
