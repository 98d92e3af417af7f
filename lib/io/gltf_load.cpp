// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// tyn_gltf_load: everything is read and checked before the first thing is added.
#include <algorithm>
#include <cinttypes>
#include <cmath>

#include "io/gltf_scene.hpp"

namespace tyn::io {
namespace {

using Indices = std::vector<uint32_t>;

const char *name_or_null(const std::string &name) { return name.empty() ? nullptr : name.c_str(); }

Indices add_images(TynScene *scene, const std::vector<LoadedImage> &images) {
  Indices indices;
  for (const LoadedImage &loaded : images) {
    TynImage image = tyn_image();
    image.name = name_or_null(loaded.name);
    image.width = loaded.width;
    image.height = loaded.height;
    image.format = loaded.format;
    image.pixels = loaded.pixels.data();
    indices.push_back(0);
    require_ok(tyn_scene_context(scene), tyn_scene_add_image(scene, &image, &indices.back()));
  }
  return indices;
}

Indices add_media(TynScene *scene, const std::vector<Named<TynMedium>> &media) {
  Indices indices;
  for (const Named<TynMedium> &loaded : media) {
    TynMedium medium = loaded.value;
    medium.name = name_or_null(loaded.name);
    indices.push_back(0);
    require_ok(tyn_scene_context(scene), tyn_scene_add_medium(scene, &medium, &indices.back()));
  }
  return indices;
}

Indices add_materials(TynScene *scene, const std::vector<Named<TynMaterial>> &materials, const Indices &images) {
  Indices indices;
  for (const Named<TynMaterial> &loaded : materials) {
    TynMaterial material = loaded.value;
    material.name = name_or_null(loaded.name);
    for (TynTexture *texture : {&material.base_color_texture, &material.metallic_roughness_texture,
                                &material.normal_texture, &material.emission_texture, &material.transmission_texture,
                                &material.multiscatter_color_texture, &material.scatter_strength_texture})
      if (texture->image != TYN_NONE)
        texture->image = images[texture->image];
    indices.push_back(0);
    require_ok(tyn_scene_context(scene), tyn_scene_add_material(scene, &material, &indices.back()));
  }
  return indices;
}

// Below this fraction of a mesh's largest coordinate (of its diagonal, if that is larger), flights come near to what single
// precision resolves there.
constexpr double SHORT_FLIGHTS = 1e-5;

// Of the channel that goes least far, as such a fraction.
double shortest_mean_free_path(TynScene *scene, const TynMeshInfo &info) {
  TynMedium medium = tyn_medium();
  require_ok(tyn_scene_context(scene), tyn_scene_medium(scene, info.medium, &medium));
  double densest = 0, squared = 0, farthest = 0;
  for (int i = 0; i < 3; i++) {
    farthest = std::max({farthest, std::fabs(double(info.lower[i])), std::fabs(double(info.upper[i]))});
    const double side = double(info.upper[i]) - double(info.lower[i]);
    densest = std::max(densest, double(medium.sigma_a[i]) + double(medium.sigma_s[i]));
    squared += side * side;
  }
  return 1 / (densest * std::max(std::sqrt(squared), farthest));
}

void warn_if_unsound(TynScene *scene, uint32_t index, const LoadedMesh &loaded, Warnings &warnings) {
  TynMeshInfo info;
  info.size = sizeof info;
  if (loaded.medium == TYN_NONE || tyn_scene_mesh_info(scene, index, &info) != TYN_OK)
    return;
  const std::string name = printable(loaded.name);
  if (!info.closed)
    warnings.add(
        "mesh \"%s\" holds a medium, but is not closed: it has %u boundary edges and %u edges of more than two "
        "triangles; what leaks out is in the ledger",
        name.c_str(), info.boundary_edges, info.nonmanifold_edges);
  if (info.duplicate_triangles)
    warnings.add("mesh \"%s\" holds a medium, but has %u triangles more than once", name.c_str(),
                 info.duplicate_triangles);
  if (info.overlapping_components)
    warnings.add("mesh \"%s\" holds a medium, but of its %u parts at least %u reach into others or touch them; light "
                 "leaves at each surface",
                 name.c_str(), info.components, info.overlapping_components);
  const double fraction = shortest_mean_free_path(scene, info);
  if (fraction < SHORT_FLIGHTS)
    warnings.add(
        "mesh \"%s\": the mean free path of its medium is %.2g of its size or distance from the origin, too short for "
        "single precision (%g) and slow",
        name.c_str(), fraction, SHORT_FLIGHTS);
}

void add_mesh(TynScene *scene, LoadedMesh &loaded, const Indices &media, const Indices &materials, Warnings &warnings) {
  for (uint32_t &material : loaded.triangle_materials)
    material = materials[material];
  TynMesh mesh = tyn_mesh();
  mesh.name = name_or_null(loaded.name);
  mesh.positions = loaded.positions.data();
  mesh.vertex_count = uint32_t(loaded.positions.size() / 3);
  mesh.normals = loaded.normals.empty() ? nullptr : loaded.normals.data();
  mesh.uvs = loaded.uvs.empty() ? nullptr : loaded.uvs.data();
  mesh.indices = loaded.indices.data();
  mesh.triangle_count = uint32_t(loaded.indices.size() / 3);
  mesh.medium = loaded.medium == TYN_NONE ? TYN_NONE : media[loaded.medium];
  mesh.material = loaded.triangle_materials[0];
  mesh.triangle_materials = loaded.triangle_materials.data();
  uint32_t index = 0;
  require_ok(tyn_scene_context(scene), tyn_scene_add_mesh(scene, &mesh, &index));
  warn_if_unsound(scene, index, loaded, warnings);
  loaded = LoadedMesh(); // the scene has its copy
}

void add_all(TynScene *scene, LoadedScene &loaded, Warnings &warnings) {
  TynContext *context = tyn_scene_context(scene);
  const Indices images = add_images(scene, loaded.images);
  const Indices media = add_media(scene, loaded.media);
  const Indices materials = add_materials(scene, loaded.materials, images);
  for (LoadedMesh &mesh : loaded.meshes)
    add_mesh(scene, mesh, media, materials, warnings);
  for (Named<TynLight> &light : loaded.lights) {
    light.value.name = name_or_null(light.name);
    require_ok(context, tyn_scene_add_light(scene, &light.value, nullptr));
  }
  for (Named<TynCamera> &camera : loaded.cameras) {
    camera.value.name = name_or_null(camera.name);
    require_ok(context, tyn_scene_add_camera(scene, &camera.value, nullptr));
  }
}

// The scene's limits hold for everything in it: what it has already counts.
void check_counts(TynScene *scene, const LoadedScene &loaded) {
  constexpr uint64_t MOST_TRIANGLES = (1u << 27) - 2, MOST_VERTICES = 1u << 30; // as in scene/mesh_input.cpp
  TynSceneInfo info;
  info.size = sizeof info;
  require_ok(tyn_scene_context(scene), tyn_scene_info(scene, &info));
  uint64_t triangles = info.triangle_count, vertices = 0;
  for (uint32_t i = 0; i < info.mesh_count; i++) {
    TynMeshInfo mesh;
    mesh.size = sizeof mesh;
    require_ok(tyn_scene_context(scene), tyn_scene_mesh_info(scene, i, &mesh));
    vertices += mesh.vertex_count;
  }
  for (const LoadedMesh &mesh : loaded.meshes) {
    triangles += mesh.indices.size() / 3;
    vertices += mesh.positions.size() / 3;
  }
  if (triangles > MOST_TRIANGLES || vertices > MOST_VERTICES)
    fail(TYN_ERROR_FORMAT,
         "with its meshes the scene would have %" PRIu64 " triangles and %" PRIu64 " vertices; at most %" PRIu64
         " and %" PRIu64,
         triangles, vertices, MOST_TRIANGLES, MOST_VERTICES);
}

void check_scene(TynScene *scene) {
  TynSceneInfo info;
  info.size = sizeof info;
  require_ok(tyn_scene_context(scene), tyn_scene_info(scene, &info));
  if (info.metres_per_unit != 1)
    fail(TYN_ERROR_INVALID_ARGUMENT, "the scene's metres_per_unit is %g; glTF needs 1", info.metres_per_unit);
}

// Every message about a file names it once.
Failure naming(const char *path, TynStatus status, const std::string &message) {
  const bool named = message.find(printable(path)) != std::string::npos;
  return Failure(status, named ? message : printable(path) + ": " + message);
}

void load(TynScene *scene, const char *path, const TynGltfOptions *given) {
  if (!path)
    fail(TYN_ERROR_INVALID_ARGUMENT, "path is NULL");
  const TynGltfOptions options = copy_options("TynGltfOptions", given, tyn_gltf_options());
  check_scene(scene);
  Warnings warnings(options.warning, options.user);
  LoadedScene loaded;
  try {
    loaded = read_gltf(path, options, warnings);
    check_counts(scene, loaded);
  } catch (const Failure &failure) {
    if (failure.status == TYN_ERROR_INVALID_ARGUMENT) // is about the options
      throw;
    throw naming(path, failure.status, failure.what());
  }
  try {
    add_all(scene, loaded, warnings);
  } catch (const Failure &failure) {
    // The arguments come from the file, and so does what is wrong with them.
    if (failure.status != TYN_ERROR_INVALID_ARGUMENT)
      throw;
    throw naming(path, TYN_ERROR_FORMAT, failure.what());
  }
}

} // namespace
} // namespace tyn::io

TynStatus tyn_gltf_load(TynScene *scene, const char *path, const TynGltfOptions *options) {
  return tyn::io::guarded(tyn_scene_context(scene), [&] { tyn::io::load(scene, path, options); });
}
