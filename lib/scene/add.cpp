// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// What a scene is filled with. Everything is checked before anything changes.
#include <cstring>
#include <utility>

#include "core/input.hpp"
#include "scene/mesh_input.hpp"
#include "scene/validate.hpp"
#include "scene/vector.hpp"

namespace tyn {
namespace {

// Runs `add`, which appends to a scene that is still open and returns the new index.
template <class Add>
TynStatus add_to(TynScene *scene, uint32_t *index, Add add) {
  if (!scene)
    return TYN_ERROR_INVALID_ARGUMENT;
  return guarded(&scene->context, [&] {
    scene->require_open();
    const uint32_t added = add();
    if (index)
      *index = added;
  });
}

template <class T>
uint32_t append(std::vector<T> &list, T item) {
  if (list.size() >= TYN_NONE - 1)
    fail(TYN_ERROR_INVALID_ARGUMENT, "the scene has %zu of these already", list.size());
  list.push_back(std::move(item));
  return uint32_t(list.size() - 1);
}

// The name is owned by the list; the pointer is filled in again when the struct is handed out.
template <class T>
uint32_t append_named(std::vector<Named<T>> &list, T value) {
  Named<T> item;
  item.name = value.name ? value.name : "";
  value.name = nullptr;
  item.value = value;
  return append(list, std::move(item));
}

Medium copy_medium(const TynMedium &given) {
  Medium medium;
  medium.name = given.name ? given.name : "";
  medium.value = given;
  medium.value.name = nullptr;
  if (given.phase) {
    medium.phase = std::make_shared<const OwnedPhase>(read_struct("TynPhase", given.phase, tyn_phase()));
    medium.value.phase = &medium.phase->get();
  }
  return medium;
}

Image copy_image(const TynImage &given) {
  Image image;
  image.name = given.name ? given.name : "";
  image.width = given.width;
  image.height = given.height;
  image.format = given.format;
  const size_t row = given.width * bytes_per_pixel(given.format);
  const size_t stride = given.row_stride ? given.row_stride : row;
  image.pixels.resize(row * given.height);
  for (size_t y = 0; y < given.height; y++)
    std::memcpy(&image.pixels[y * row], static_cast<const char *>(given.pixels) + y * stride, row);
  return image;
}

// Within 1e-3 of unit length is allowed; from here on it is a unit vector.
void normalize(float (&v)[3]) {
  const double size = length({v[0], v[1], v[2]});
  for (float &component : v)
    component = float(component / size);
}

} // namespace
} // namespace tyn

using namespace tyn;

extern "C" {

TynStatus tyn_scene_add_image(TynScene *scene, const TynImage *image, uint32_t *index) {
  return add_to(scene, index, [&] {
    const TynImage given = read_struct("TynImage", image, tyn_image());
    validate(given);
    return append(scene->images, copy_image(given));
  });
}

TynStatus tyn_scene_add_medium(TynScene *scene, const TynMedium *medium, uint32_t *index) {
  return add_to(scene, index, [&] { return append(scene->media, copy_medium(read_medium(medium))); });
}

TynStatus tyn_scene_add_material(TynScene *scene, const TynMaterial *material, uint32_t *index) {
  return add_to(scene, index, [&] {
    const TynMaterial given = read_struct("TynMaterial", material, tyn_material());
    validate(given, scene->images.size());
    return append_named(scene->materials, given);
  });
}

TynStatus tyn_scene_add_mesh(TynScene *scene, const TynMesh *mesh, uint32_t *index) {
  return add_to(scene, index, [&] {
    const TynMesh given = read_struct("TynMesh", mesh, tyn_mesh());
    return append(scene->meshes, read_mesh(given, *scene));
  });
}

TynStatus tyn_scene_add_light(TynScene *scene, const TynLight *light, uint32_t *index) {
  return add_to(scene, index, [&] {
    TynLight given = read_struct("TynLight", light, tyn_light());
    validate(given);
    if (given.type != TYN_LIGHT_POINT)
      normalize(given.direction);
    return append_named(scene->lights, given);
  });
}

TynStatus tyn_scene_add_camera(TynScene *scene, const TynCamera *camera, uint32_t *index) {
  return add_to(scene, index, [&] {
    const TynCamera given = read_struct("TynCamera", camera, tyn_camera());
    validate(given);
    return append_named(scene->cameras, given);
  });
}

TynStatus tyn_scene_set_environment(TynScene *scene, const TynEnvironment *environment) {
  return add_to(scene, nullptr, [&] {
    const TynEnvironment given = read_struct("TynEnvironment", environment, tyn_environment());
    validate(given, scene->images);
    scene->environment = given;
    return 0u;
  });
}

TynStatus tyn_scene_clear_lights(TynScene *scene) {
  return add_to(scene, nullptr, [&] {
    scene->lights.clear();
    return 0u;
  });
}

} // extern "C"
