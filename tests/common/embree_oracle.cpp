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

EmbreeOracle::EmbreeOracle(const std::vector<tyn::Mesh> &meshes_) : meshes(meshes_), handles(new Handles) {
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

namespace {

double dot(const double (&a)[3], const double (&b)[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// From a point, taken as the origin, to the segment between `a` and `b`, squared.
double squared_to_segment(const double (&a)[3], const double (&b)[3]) {
  const double e[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
  const double t = dot(e, e) > 0 ? std::fmin(1.0, std::fmax(0.0, -dot(a, e) / dot(e, e))) : 0;
  const double d[3] = {a[0] + t * e[0], a[1] + t * e[1], a[2] + t * e[2]};
  return dot(d, d);
}

// To a triangle: its plane if the foot of the perpendicular is in it, else the nearest edge.
double squared_to_triangle(const double (&p)[3][3]) {
  const double e[3] = {p[1][0] - p[0][0], p[1][1] - p[0][1], p[1][2] - p[0][2]};
  const double f[3] = {p[2][0] - p[0][0], p[2][1] - p[0][1], p[2][2] - p[0][2]};
  const double ee = dot(e, e), ef = dot(e, f), ff = dot(f, f), ae = -dot(p[0], e), af = -dot(p[0], f);
  const double area = ee * ff - ef * ef, u = ff * ae - ef * af, v = ee * af - ef * ae;
  if (area > 0 && u >= 0 && v >= 0 && u + v <= area) {
    double foot[3];
    for (int k = 0; k < 3; k++)
      foot[k] = p[0][k] + u / area * e[k] + v / area * f[k];
    return dot(foot, foot);
  }
  return std::fmin(squared_to_segment(p[0], p[1]),
                   std::fmin(squared_to_segment(p[1], p[2]), squared_to_segment(p[2], p[0])));
}

// Embree finds the triangles that may be nearest; how near they are is computed here.
bool try_triangle(RTCPointQueryFunctionArguments *arguments) {
  const tyn::Mesh &mesh = *static_cast<const tyn::Mesh *>(arguments->userPtr);
  RTCPointQuery &query = *arguments->query;
  double p[3][3];
  for (int i = 0; i < 3; i++) {
    const tyn::Vec3 &v = mesh.positions[mesh.indices[3 * arguments->primID + unsigned(i)]];
    p[i][0] = double(v.x) - double(query.x);
    p[i][1] = double(v.y) - double(query.y);
    p[i][2] = double(v.z) - double(query.z);
  }
  const float distance = float(std::sqrt(squared_to_triangle(p)));
  if (distance >= query.radius)
    return false;
  query.radius = distance;
  return true;
}

} // namespace

float EmbreeOracle::distance(const float (&point)[3]) const {
  RTCPointQuery query{};
  query.x = point[0], query.y = point[1], query.z = point[2];
  query.radius = INFINITY;
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  rtcPointQuery(handles->scene, &query, &context, try_triangle, const_cast<tyn::Mesh *>(&meshes[0]));
  return query.radius;
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
