// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Embree's own rays and point queries over the meshes of a scene: the independent answer to tyn_intersect.
#pragma once

#include "scene/scene.hpp"

namespace tyn_test {

class EmbreeOracle {
public:
  explicit EmbreeOracle(const std::vector<tyn::Mesh> &meshes);
  ~EmbreeOracle();
  EmbreeOracle(const EmbreeOracle &) = delete;
  EmbreeOracle &operator=(const EmbreeOracle &) = delete;

  // t, mesh and triangle of the nearest hit; u, v and normal stay 0.
  TynHit intersect(const TynRay &ray) const;
  bool occluded(const TynRay &ray) const;
  // From a point to the nearest triangle of mesh 0.
  float distance(const float (&point)[3]) const;

private:
  struct Handles;
  const std::vector<tyn::Mesh> meshes;
  Handles *handles;
};

} // namespace tyn_test
