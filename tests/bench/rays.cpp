// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Incoherent rays from inside a mesh: tyn_intersect against Embree's rtcIntersect1 on one core, in one run. Counters:
// rays/s of each, `ratio` = kernel on all cores / Embree on one.
#include <benchmark/benchmark.h>

#if TYN_EMBREE_MAJOR == 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <chrono>
#include <cmath>
#include <random>
#include <vector>

#include "common/meshes.hpp"
#include "tyndall/tyndall.hpp"

namespace {

std::vector<TynRay> random_rays(size_t count) {
  std::mt19937 engine(1);
  std::normal_distribution<float> normal;
  std::vector<TynRay> rays(count);
  for (TynRay &ray : rays) {
    float d[3], length = 0;
    for (float &x : d) {
      x = normal(engine);
      length += x * x;
    }
    for (int i = 0; i < 3; ++i) {
      ray.origin[i] = 0.2f * normal(engine);
      ray.direction[i] = d[i] / std::sqrt(length);
    }
    ray.t_min = 0;
    ray.t_max = INFINITY;
  }
  return rays;
}

class EmbreeMesh {
public:
  explicit EmbreeMesh(const tyn_test::MeshData &mesh) : device(rtcNewDevice(nullptr)), scene(rtcNewScene(device)) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    void *positions =
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, mesh.vertex_count());
    memcpy(positions, mesh.positions.data(), mesh.positions.size() * sizeof(float));
    void *indices =
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, mesh.triangle_count());
    memcpy(indices, mesh.indices.data(), mesh.indices.size() * sizeof(uint32_t));
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    rtcCommitScene(scene);
  }
  ~EmbreeMesh() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }

  float intersect(const TynRay &ray) const {
    RTCRayHit hit{};
    hit.ray.org_x = ray.origin[0];
    hit.ray.org_y = ray.origin[1];
    hit.ray.org_z = ray.origin[2];
    hit.ray.dir_x = ray.direction[0];
    hit.ray.dir_y = ray.direction[1];
    hit.ray.dir_z = ray.direction[2];
    hit.ray.tnear = ray.t_min;
    hit.ray.tfar = ray.t_max;
    hit.ray.mask = ~0u;
    hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
#if TYN_EMBREE_MAJOR == 4
    rtcIntersect1(scene, &hit);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene, &context, &hit);
#endif
    return hit.ray.tfar;
  }

private:
  RTCDevice device;
  RTCScene scene;
};

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void incoherent_rays(benchmark::State &state) {
  tyn_test::MeshData mesh = tyn_test::icosphere(uint32_t(state.range(0)));
  EmbreeMesh embree(mesh);
  tyndall::Context context;
  tyndall::Scene scene(context);
  TynMesh view = mesh.view();
  context.check(tyn_scene_add_mesh(scene.get(), &view, nullptr));
  context.check(tyn_scene_commit(scene.get()));
  std::vector<TynRay> rays = random_rays(1 << 18);
  std::vector<TynHit> hits(rays.size());
  context.check(tyn_intersect(scene.get(), TYN_NONE, rays.data(), rays.size(), hits.data())); // warm
  double ours = 0, theirs = 0;
  for (auto _ : state) {
    auto start = std::chrono::steady_clock::now();
    context.check(tyn_intersect(scene.get(), TYN_NONE, rays.data(), rays.size(), hits.data()));
    ours += seconds_since(start);
    start = std::chrono::steady_clock::now();
    float sum = 0;
    for (const TynRay &ray : rays)
      sum += embree.intersect(ray);
    benchmark::DoNotOptimize(sum);
    theirs += seconds_since(start);
  }
  double count = double(rays.size()) * double(state.iterations());
  state.counters["kernel_rays/s"] = count / ours;
  state.counters["embree_rays/s"] = count / theirs;
  state.counters["ratio"] = theirs / ours;
}

BENCHMARK(incoherent_rays)->Arg(4)->Arg(6)->Iterations(4)->Unit(benchmark::kMillisecond);

} // namespace

BENCHMARK_MAIN();
