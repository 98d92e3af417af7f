// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// From a file to a LoadedScene.
#include "io/gltf_light_camera.hpp"
#include "io/gltf_mesh.hpp"
#include "io/gltf_scene.hpp"

namespace tyn::io {

LoadedScene read_gltf(const std::string &path, const TynGltfOptions &options, Warnings &warnings) {
  LoadedScene scene;
  GltfDocument document(path, options, warnings);
  GltfMeshes meshes(document, options, warnings, scene);
  for (const PlacedNode &node : place_nodes(document.model)) {
    if (document.model.nodes[size_t(node.index)].mesh >= 0)
      meshes.add(node);
    if (!options.skip_lights)
      add_light(document.model, node, scene, warnings);
    add_camera(document.model, node, scene);
  }
  if (scene.meshes.empty())
    warnings.add("the scene has no triangles");
  return scene;
}

} // namespace tyn::io
