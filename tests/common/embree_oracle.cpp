// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "common/embree_oracle.hpp"

#include <cmath>
#include <cstring>

#ifndef TYN_EMBREE_MAJOR
#define TYN_EMBREE_MAJOR 3
#endif
#if TYN_EMBREE_MAJOR >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace tyn_test {

struct EmbreeOracle::Handles {
  RTCDevice device;
  RTCScene scene;
};

EmbreeOracle::EmbreeOracle(const std::vector<tyn::Mesh> &meshes) : handles(new Handles) {
  handles->device = rtcNewDevice("verbose=0");
  handles->scene = rtcNewScene(handles->device);
  rtcSetSceneFlags(handles->scene, RTC_SCENE_FLAG_ROBUST);
  for (unsigned i = 0; i < meshes.size(); i++) {
    const tyn::Mesh &mesh = meshes[i];
    RTCGeometry geometry = rtcNewGeometry(handles->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    void *vertices =
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, mesh.positions.size());
    std::memcpy(vertices, mesh.positions.data(), mesh.positions.size() * 12);
    void *indices =
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, mesh.indices.size() / 3);
    std::memcpy(indices, mesh.indices.data(), mesh.indices.size() * 4);
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(handles->scene, geometry, i);
    rtcReleaseGeometry(geometry);
  }
  rtcCommitScene(handles->scene);
}

EmbreeOracle::~EmbreeOracle() {
  rtcReleaseScene(handles->scene);
  rtcReleaseDevice(handles->device);
  delete handles;
}

static RTCRay to_embree(const TynRay &ray) {
  RTCRay result{};
  result.org_x = ray.origin[0], result.org_y = ray.origin[1], result.org_z = ray.origin[2];
  result.dir_x = ray.direction[0], result.dir_y = ray.direction[1], result.dir_z = ray.direction[2];
  result.tnear = ray.t_min;
  result.tfar = ray.t_max;
  result.mask = ~0u;
  return result;
}

TynHit EmbreeOracle::intersect(const TynRay &ray) const {
  RTCRayHit query{};
  query.ray = to_embree(ray);
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
#if TYN_EMBREE_MAJOR >= 4
  rtcIntersect1(handles->scene, &query);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(handles->scene, &context, &query);
#endif
  TynHit hit{};
  const bool found = query.hit.geomID != RTC_INVALID_GEOMETRY_ID;
  hit.t = found ? query.ray.tfar : INFINITY;
  hit.mesh = found ? query.hit.geomID : TYN_NONE;
  hit.triangle = found ? query.hit.primID : TYN_NONE;
  return hit;
}

bool EmbreeOracle::occluded(const TynRay &ray) const {
  RTCRay query = to_embree(ray);
#if TYN_EMBREE_MAJOR >= 4
  rtcOccluded1(handles->scene, &query);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(handles->scene, &context, &query);
#endif
  return query.tfar < 0;
}

} // namespace tyn_test
