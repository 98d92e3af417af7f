// SPDX-License-Identifier: Apache-2.0
// Camera rays: the beginning of every path of a pass.
#include "render_random.clh"

// The pixel filter is a tent of two pixels' width (bilinear reconstruction). Samples are drawn from it, so that each has the
// same weight. Difference of two uniform numbers: offset from the pixel's centre.
static float camera_tent(float u) { return u < 0.5f ? sqrt(2.0f * u) - 1.0f : 1.0f - sqrt(2.0f - 2.0f * u); }

static float3 camera_to_world(const TynCameraRecord *camera, float3 v) {
  const float *m = camera->world_from_camera;
  return tyn_vec3(m[0] * v.x + m[1] * v.y + m[2] * v.z, m[4] * v.x + m[5] * v.y + m[6] * v.z,
                  m[8] * v.x + m[9] * v.y + m[10] * v.z);
}

kernel void camera_rays(global TynPathState *paths, global TynPathResult *results, global uint *queue,
                        TynRenderParameters parameters, TynCameraRecord camera) {
  uint index = (uint)get_global_id(0);
  if (index >= parameters.pixel_count * parameters.sample_count)
    return;
  Draws draws = draws_of(&parameters, index, 0);
  float4 u = draws_uniform(draws, TYN_DRAW_CAMERA, 0);
  uint column = draws.path.y % parameters.width, row = draws.path.y / parameters.width;
  float x = (2.0f * (column + 0.5f + camera_tent(u.x)) / parameters.width - 1.0f) * camera.half_width;
  float y = (1.0f - 2.0f * (row + 0.5f + camera_tent(u.y)) / parameters.height) * camera.half_height;

  int perspective = camera.type == TYN_CAMERA_PERSPECTIVE;
  float3 view = perspective ? tyn_vec3(x, y, -1.0f) : tyn_vec3(0.0f, 0.0f, -1.0f);
  float length = sqrt(tyn_dot(view, view)); // per unit of depth
  float3 origin = tyn_vec3(camera.world_from_camera[3], camera.world_from_camera[7], camera.world_from_camera[11]);
  if (!perspective)
    origin = origin + camera_to_world(&camera, tyn_vec3(x, y, 0.0f));

  TynPathState path;
  float3 direction = tyn_normalize(camera_to_world(&camera, view));
  path.origin[0] = origin.x;
  path.origin[1] = origin.y;
  path.origin[2] = origin.z;
  path.direction[0] = direction.x;
  path.direction[1] = direction.y;
  path.direction[2] = direction.z;
  path.t_min = camera.znear * length;
  path.pdf = 0.0f;
  path.throughput[0] = path.throughput[1] = path.throughput[2] = 1.0f;
  path.bounces = 0;
  path.event = TYN_EVENT_NONE;
  path.t = 0.0f;
  path.u = path.v = 0.0f;
  path.triangle = TYN_NONE;
  path.cos_axis = 1.0f / length;
  path.reserved[0] = path.reserved[1] = 0;
  paths[index] = path;

  TynPathResult result;
  for (uint event = 0; event < TYN_EVENT_COUNT; ++event)
    result.light[event][0] = result.light[event][1] = result.light[event][2] = 0.0f;
  result.albedo[0] = result.albedo[1] = result.albedo[2] = 0.0f;
  result.normal[0] = result.normal[1] = result.normal[2] = 0.0f;
  result.depth = INFINITY;
  result.reserved = 0;
  results[index] = result;
  queue[index] = index;
}
