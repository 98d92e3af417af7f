// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// A view of the whole scene, for when there is no camera.
#include <algorithm>
#include <cmath>

#include "core/argument.hpp"
#include "scene/scene.hpp"
#include "scene/vector.hpp"

namespace tyn {
namespace {

constexpr double FIELD_OF_VIEW = 0.52359877559829887; // 30 degrees, vertical
constexpr double ELEVATION = 0.20943951023931954;     // 12 degrees above the horizon
constexpr double MARGIN = 1.06;                       // empty border

struct Bounds {
  Double3 lower, upper;
};

Bounds bounds_of(const TynScene &scene) {
  if (scene.meshes.empty())
    fail(TYN_ERROR_INVALID_OPERATION, "the scene has no mesh to look at");
  Bounds b{{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
  for (const Mesh &mesh : scene.meshes) {
    const float *l = mesh.info.lower, *u = mesh.info.upper;
    b.lower = {std::min(b.lower.x, double(l[0])), std::min(b.lower.y, double(l[1])), std::min(b.lower.z, double(l[2]))};
    b.upper = {std::max(b.upper.x, double(u[0])), std::max(b.upper.y, double(u[1])), std::max(b.upper.z, double(u[2]))};
  }
  return b;
}

// The camera's axes in world space: it looks along -back.
struct Axes {
  Double3 right, up, back;
};

// How far from the centre the camera must be for all eight corners to be inside its frustum.
double distance_to_fit(const Bounds &b, const Double3 &centre, const Axes &axes, double aspect_ratio) {
  const double tan_y = std::tan(FIELD_OF_VIEW / 2), tan_x = tan_y * aspect_ratio;
  double distance = 0;
  for (int corner = 0; corner < 8; corner++) {
    const Double3 p = Double3{corner & 1 ? b.upper.x : b.lower.x, corner & 2 ? b.upper.y : b.lower.y,
                              corner & 4 ? b.upper.z : b.lower.z} -
                      centre;
    const double side = std::max(std::abs(dot(p, axes.right)) / tan_x, std::abs(dot(p, axes.up)) / tan_y);
    distance = std::max(distance, dot(p, axes.back) + MARGIN * side);
  }
  return distance > 0 ? distance : 1; // all in one point
}

TynCamera frame(const TynScene &scene, double aspect_ratio) {
  const Bounds b = bounds_of(scene);
  const Double3 centre{(b.lower.x + b.upper.x) / 2, (b.lower.y + b.upper.y) / 2, (b.lower.z + b.upper.z) / 2};
  const double s = std::sin(ELEVATION), c = std::cos(ELEVATION);
  const Axes axes{{1, 0, 0}, {0, c, -s}, {0, s, c}};
  const double distance = distance_to_fit(b, centre, axes, aspect_ratio);
  const double m[12] = {axes.right.x, axes.up.x, axes.back.x, centre.x + distance * axes.back.x,
                        axes.right.y, axes.up.y, axes.back.y, centre.y + distance * axes.back.y,
                        axes.right.z, axes.up.z, axes.back.z, centre.z + distance * axes.back.z};
  TynCamera camera = tyn_camera();
  for (int i = 0; i < 12; i++)
    camera.world_from_camera[i] = float(m[i]);
  camera.yfov = float(FIELD_OF_VIEW);
  camera.aspect_ratio = float(aspect_ratio);
  return camera;
}

} // namespace
} // namespace tyn

extern "C" TynStatus tyn_scene_frame(const TynScene *scene, float aspect_ratio, TynCamera *camera) {
  if (!scene)
    return TYN_ERROR_INVALID_ARGUMENT;
  return tyn::guarded(&scene->context, [&] {
    tyn::require_pointer("camera", camera);
    tyn::require_positive("aspect_ratio", aspect_ratio);
    *camera = tyn::frame(*scene, aspect_ratio);
  });
}
