// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "render/camera.hpp"

#include <cmath>
#include <cstring>

namespace tyn {

TynCameraRecord camera_record(const TynCamera &camera, uint32_t width, uint32_t height) {
  TynCameraRecord record{};
  std::memcpy(record.world_from_camera, camera.world_from_camera, sizeof record.world_from_camera);
  const double film_aspect = double(width) / double(height);
  const double made_for = camera.aspect_ratio > 0 ? double(camera.aspect_ratio) : film_aspect;
  double half_height =
      camera.type == TYN_CAMERA_PERSPECTIVE ? std::tan(0.5 * double(camera.yfov)) : double(camera.ymag);
  // A narrower film than the camera was made for keeps the width of the view and shows more above and below.
  if (film_aspect < made_for)
    half_height *= made_for / film_aspect;
  record.half_height = float(half_height);
  record.half_width = float(half_height * film_aspect);
  record.znear = camera.znear;
  record.type = camera.type;
  return record;
}

} // namespace tyn
