// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// What a scene holds, told to the caller.
#include <algorithm>

#include "core/input.hpp"
#include "media/media.hpp"
#include "scene/scene.hpp"

namespace tyn {
namespace {

template <class Body>
TynStatus read_from(const TynScene *scene, Body body) {
  return scene ? guarded(&scene->context, body) : TYN_ERROR_INVALID_ARGUMENT;
}

bool emits(const TynScene &scene, uint32_t material) {
  if (material == TYN_NONE)
    return false;
  const float *emission = scene.materials[material].value.emission;
  return emission[0] > 0 || emission[1] > 0 || emission[2] > 0;
}

TynSceneInfo describe(const TynScene &scene) {
  TynSceneInfo info{};
  info.mesh_count = uint32_t(scene.meshes.size());
  info.medium_count = uint32_t(scene.media.size());
  info.material_count = uint32_t(scene.materials.size()) - (scene.default_material != TYN_NONE);
  info.image_count = uint32_t(scene.images.size());
  info.light_count = uint32_t(scene.lights.size());
  info.camera_count = uint32_t(scene.cameras.size());
  info.metres_per_unit = scene.metres_per_unit;
  const float *radiance = scene.environment.radiance;
  info.has_environment = radiance[0] > 0 || radiance[1] > 0 || radiance[2] > 0;
  std::fill_n(info.lower, 3, INFINITY);
  std::fill_n(info.upper, 3, -INFINITY);
  for (const Mesh &mesh : scene.meshes) {
    info.triangle_count += mesh.info.triangle_count;
    for (uint32_t material : mesh.materials)
      info.emissive_triangle_count += emits(scene, material);
    for (int k = 0; k < 3; k++) {
      info.lower[k] = std::min(info.lower[k], mesh.info.lower[k]);
      info.upper[k] = std::max(info.upper[k], mesh.info.upper[k]);
    }
  }
  return info;
}

} // namespace
} // namespace tyn

using namespace tyn;

extern "C" {

TynStatus tyn_scene_info(const TynScene *scene, TynSceneInfo *info) {
  return read_from(scene, [&] { write_struct("TynSceneInfo", info, describe(*scene)); });
}

TynStatus tyn_scene_mesh_info(const TynScene *scene, uint32_t mesh, TynMeshInfo *info) {
  return read_from(scene, [&] {
    require_index("mesh", mesh, scene->meshes.size(), "meshes");
    TynMeshInfo result = scene->meshes[mesh].info;
    result.name = scene->meshes[mesh].name.c_str();
    write_struct("TynMeshInfo", info, result);
  });
}

TynStatus tyn_scene_medium(const TynScene *scene, uint32_t index, TynMedium *medium) {
  return read_from(scene, [&] {
    require_index("index", index, scene->media.size(), "media");
    TynMedium result = scene->media[index].value;
    result.name = scene->media[index].name.c_str();
    write_struct("TynMedium", medium, result, first_medium_size);
  });
}

TynStatus tyn_scene_camera(const TynScene *scene, uint32_t index, TynCamera *camera) {
  return read_from(scene, [&] {
    require_index("index", index, scene->cameras.size(), "cameras");
    TynCamera result = scene->cameras[index].value;
    result.name = scene->cameras[index].name.c_str();
    write_struct("TynCamera", camera, result);
  });
}

} // extern "C"
