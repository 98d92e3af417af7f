// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The batch ray calls, on host pointers and on the caller's buffers.
#include <algorithm>

#include "core/batch.hpp"
#include "core/buffer_argument.hpp"
#include "scene/scene.hpp"

namespace tyn {
namespace {

constexpr size_t MAX_BATCH = size_t(1) << 20; // rays in flight: enough to fill a device, 64 MiB of them and their hits

void check_ray(const TynRay &ray, size_t index) {
  auto reject = [&](const char *field, double value, const char *allowed) {
    fail(TYN_ERROR_INVALID_ARGUMENT, "rays[%zu].%s is %g; it must be %s", index, field, value, allowed);
  };
  static const char *const origin[] = {"origin[0]", "origin[1]", "origin[2]"};
  static const char *const direction[] = {"direction[0]", "direction[1]", "direction[2]"};
  double squared = 0;
  for (int k = 0; k < 3; k++) {
    if (!std::isfinite(ray.origin[k]))
      reject(origin[k], ray.origin[k], "finite");
    if (!std::isfinite(ray.direction[k]))
      reject(direction[k], ray.direction[k], "finite");
    squared += double(ray.direction[k]) * ray.direction[k];
  }
  if (!(std::abs(std::sqrt(squared) - 1) <= 1e-3))
    reject("direction's length", std::sqrt(squared), "1, within 1e-3");
  if (!(ray.t_min >= 0 && std::isfinite(ray.t_min)))
    reject("t_min", ray.t_min, "finite and >= 0");
  if (!(ray.t_max > ray.t_min))
    reject("t_max", ray.t_max, "greater than t_min");
}

void check_call(const TynScene &scene, uint32_t mesh, const void *rays, const void *results, size_t count) {
  scene.require_committed();
  scene.require_mesh(mesh);
  if (count == 0)
    return;
  require_pointer("rays", rays);
  require_pointer("the array of results", results);
}

void launch_intersect(TynScene &scene, uint32_t mesh, cl_mem rays, size_t count, cl_mem hits) {
  const SceneBuffers &b = scene.buffers;
  scene.context.launch("intersect", "intersect", count, 0, b.nodes, b.blocks, b.triangles, b.positions, b.meshes,
                       b.turned, scene.root(mesh), rays, cl_ulong(count), hits);
}

void launch_occluded(TynScene &scene, uint32_t mesh, cl_mem rays, size_t count, cl_mem occluded) {
  const SceneBuffers &b = scene.buffers;
  scene.context.launch("intersect", "occluded", count, 0, b.nodes, b.blocks, scene.root(mesh), rays, cl_ulong(count),
                       occluded);
}

// Batch by batch: to the device, through `launch`, and back.
template <class Result, class Launch>
void run_batches(TynScene &scene, uint32_t mesh, const TynRay *rays, size_t count, Result *results, Launch launch) {
  check_call(scene, mesh, rays, results, count);
  for (size_t i = 0; i < count; i++)
    check_ray(rays[i], i);
  if (count == 0)
    return;
  TynContext &context = scene.context;
  const size_t batch = batch_size(context, count, MAX_BATCH, sizeof(TynRay) + sizeof(Result),
                                  std::max(sizeof(TynRay), sizeof(Result)), "ray");
  Buffer ray_buffer(context, batch * sizeof(TynRay), CL_MEM_READ_ONLY);
  Buffer result_buffer(context, batch * sizeof(Result), CL_MEM_WRITE_ONLY);
  for (size_t first = 0; first < count; first += batch) {
    const size_t size = std::min(batch, count - first);
    context.write(ray_buffer, rays + first, size * sizeof(TynRay));
    launch(scene, mesh, ray_buffer.get(), size, result_buffer.get());
    context.read(result_buffer, results + first, size * sizeof(Result));
  }
}

template <class Result, class Launch>
void run_on_buffers(TynScene &scene, uint32_t mesh, cl_mem rays, size_t count, const char *name, cl_mem results,
                    Launch launch) {
  check_call(scene, mesh, rays, results, count);
  if (count == 0)
    return;
  require_buffer(scene.context, "rays", rays, count, sizeof(TynRay));
  require_buffer(scene.context, name, results, count, sizeof(Result));
  launch(scene, mesh, rays, count, results);
  scene.context.flush();
}

} // namespace
} // namespace tyn

using namespace tyn;

extern "C" {

TynStatus tyn_intersect(TynScene *scene, uint32_t mesh, const TynRay *rays, size_t count, TynHit *hits) {
  if (!scene)
    return TYN_ERROR_INVALID_ARGUMENT;
  return guarded(&scene->context, [&] { run_batches(*scene, mesh, rays, count, hits, launch_intersect); });
}

TynStatus tyn_occluded(TynScene *scene, uint32_t mesh, const TynRay *rays, size_t count, uint32_t *occluded) {
  if (!scene)
    return TYN_ERROR_INVALID_ARGUMENT;
  return guarded(&scene->context, [&] { run_batches(*scene, mesh, rays, count, occluded, launch_occluded); });
}

TynStatus tyn_intersect_cl(TynScene *scene, uint32_t mesh, cl_mem rays, size_t count, cl_mem hits) {
  if (!scene)
    return TYN_ERROR_INVALID_ARGUMENT;
  return guarded(&scene->context,
                 [&] { run_on_buffers<TynHit>(*scene, mesh, rays, count, "hits", hits, launch_intersect); });
}

TynStatus tyn_occluded_cl(TynScene *scene, uint32_t mesh, cl_mem rays, size_t count, cl_mem occluded) {
  if (!scene)
    return TYN_ERROR_INVALID_ARGUMENT;
  return guarded(&scene->context,
                 [&] { run_on_buffers<uint32_t>(*scene, mesh, rays, count, "occluded", occluded, launch_occluded); });
}

} // extern "C"
