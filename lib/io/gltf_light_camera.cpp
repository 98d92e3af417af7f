// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "io/gltf_light_camera.hpp"

#include <algorithm>

#include "io/gltf_medium.hpp"
#include "io/gltf_value.hpp"

namespace tyn::io {
namespace {

constexpr double PI = 3.14159265358979323846;

void set(float (&to)[3], const Vector &from, const std::string &what) {
  for (size_t i = 0; i < 3; i++) {
    to[i] = float(from[i]);
    if (!std::isfinite(to[i]))
      fail(TYN_ERROR_FORMAT, "%s is %g %g %g, which is too large for single precision", what.c_str(), from[0], from[1],
           from[2]);
  }
}

Vector unit(const Vector &v, const std::string &what) {
  const double size = length(v);
  if (!(size > 0) || !std::isfinite(size))
    fail(TYN_ERROR_FORMAT, "%s has no direction: its transform has a scale of 0", what.c_str());
  return v * (1 / size);
}

uint32_t light_type(const std::string &type) {
  return type == "point" ? TYN_LIGHT_POINT : type == "spot" ? TYN_LIGHT_SPOT : TYN_LIGHT_DIRECTIONAL;
}

void set_cone(const tinygltf::SpotLight &spot, TynLight &light, const std::string &where, Warnings &warnings) {
  const double outer = limited(spot.outerConeAngle, 1e-3, PI / 2, where + ".spot.outerConeAngle", warnings);
  const double inner = limited(spot.innerConeAngle, 0, outer, where + ".spot.innerConeAngle", warnings);
  light.outer_cone = float(outer);
  // The API wants a falloff of some width; a sharp edge is as narrow as floats allow.
  light.inner_cone = std::min(float(inner), std::nextafter(light.outer_cone, 0.0f));
}

// A rotation and a position: a camera's scale means nothing, and its axes need not be perpendicular.
void set_pose(const Affine &world, TynCamera &camera, const std::string &where) {
  const Vector z = unit(world.z, where), x = unit(cross(world.y, z), where), y = cross(z, x);
  const Vector columns[4] = {x, y, z, world.origin};
  for (size_t row = 0; row < 3; row++)
    for (size_t column = 0; column < 4; column++)
      camera.world_from_camera[4 * row + column] = float(columns[column][row]);
  float position[3];
  set(position, world.origin, where + ": its position");
}

void require_in(double value, double low, double high, const std::string &where, const char *allowed) {
  if (!(value > low && value < high))
    fail(TYN_ERROR_FORMAT, "%s is %g; it must be %s", where.c_str(), value, allowed);
}

void set_perspective(const tinygltf::PerspectiveCamera &source, TynCamera &camera, const std::string &where) {
  require_in(source.yfov, 1e-6, 3.1415, where + ".yfov", "between 0 and pi");
  camera.type = TYN_CAMERA_PERSPECTIVE;
  camera.yfov = float(source.yfov);
  if (source.aspectRatio != 0) // 0: absent
    require_in(source.aspectRatio, 1e-6, 1e6, where + ".aspectRatio", "> 0");
  camera.aspect_ratio = float(source.aspectRatio);
  require_in(source.znear, -1e-30, 1e30, where + ".znear", ">= 0");
  camera.znear = float(std::max(source.znear, 0.0));
}

void set_orthographic(const tinygltf::OrthographicCamera &source, TynCamera &camera, const std::string &where) {
  const double xmag = std::abs(source.xmag),
               ymag = std::abs(source.ymag); // negative ones are allowed, but mean nothing
  require_in(xmag, 1e-30, 1e30, where + ".xmag", "not 0");
  require_in(ymag, 1e-30, 1e30, where + ".ymag", "not 0");
  require_in(xmag / ymag, 1e-6, 1e6, where + ": xmag / ymag", "> 0");
  require_in(source.znear, -1e-30, 1e30, where + ".znear", ">= 0");
  camera.type = TYN_CAMERA_ORTHOGRAPHIC;
  camera.ymag = float(ymag);
  camera.aspect_ratio = float(xmag / ymag);
  camera.znear = float(std::max(source.znear, 0.0));
}

} // namespace

void add_light(const tinygltf::Model &model, const PlacedNode &node, LoadedScene &scene, Warnings &warnings) {
  const tinygltf::Node &carrier = model.nodes[size_t(node.index)];
  const tinygltf::Value *reference = extension(carrier.extensions, "KHR_lights_punctual");
  if (!reference)
    return;
  const int index = int(number(*reference, "light", 0));
  const tinygltf::Light &source = model.lights[size_t(index)];
  const std::string where = text("extensions.KHR_lights_punctual.lights[%d]", index);
  TynLight light = tyn_light();
  light.type = light_type(source.type);
  for (size_t i = 0; i < 3; i++) {
    const double color = source.color.size() == 3 ? source.color[i] : 1;
    light.intensity[i] = limited(color * source.intensity, 0, 1e30, where + ": color x intensity", warnings);
  }
  if (light.type != TYN_LIGHT_DIRECTIONAL)
    set(light.position, node.world.origin, text("nodes[%d]: the light's position", node.index));
  if (light.type != TYN_LIGHT_POINT)
    set(light.direction, unit(node.world.z, text("nodes[%d]: the light", node.index)) * -1, where);
  if (light.type == TYN_LIGHT_SPOT)
    set_cone(source.spot, light, where, warnings);
  if (source.range > 0)
    warnings.add("%s.range is ignored: light falls off with the square of the distance, without end", where.c_str());
  scene.lights.push_back({carrier.name.empty() ? source.name : carrier.name, light});
}

void add_camera(const tinygltf::Model &model, const PlacedNode &node, LoadedScene &scene) {
  const tinygltf::Node &carrier = model.nodes[size_t(node.index)];
  if (carrier.camera < 0)
    return;
  const tinygltf::Camera &source = model.cameras[size_t(carrier.camera)];
  const std::string where = text("cameras[%d]", carrier.camera);
  TynCamera camera = tyn_camera();
  if (source.type == "perspective")
    set_perspective(source.perspective, camera, where + ".perspective");
  else
    set_orthographic(source.orthographic, camera, where + ".orthographic");
  set_pose(node.world, camera, text("nodes[%d]: the camera", node.index));
  scene.cameras.push_back({carrier.name.empty() ? source.name : carrier.name, camera});
}

} // namespace tyn::io
