// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The walk of tyn_walk in one grey medium, written plainly: one walk after the other, Embree's single ray for every flight. What
// the kernel's speed and results are compared with.
#pragma once

#include <cstdint>
#include <vector>

#include "common/embree_oracle.hpp"
#include "common/meshes.hpp"
#include "tyndall/tyndall.h"

namespace tyn_test {

// What walks add up to.
struct WalkSums {
  double walks = 0, scatterings = 0, rays = 0;
  double weight = 0, squares = 0; // of the escaped weights of single walks

  WalkSums &operator+=(const WalkSums &other);
  double mean() const { return weight / walks; }
  double variance() const; // of one walk's escaped weight
  double standard_error() const;
};

struct PlainMedium {
  float sigma_t, albedo, g, ior;
};

class PlainWalk {
public:
  // A closed mesh, wound outwards, and the rays in it. The oracle must outlive this.
  PlainWalk(const MeshData &mesh, const EmbreeOracle &oracle);

  // Walks from entries of kind COSINE and weight 1, on so many threads. An interface with an index of refraction other than 1
  // is smooth. `first_path`, the number of the first walk, sets the random numbers, which are the walks' own up to 2^32.
  WalkSums run(const PlainMedium &medium, const std::vector<TynWalkEntry> &entries, uint64_t first_path,
               unsigned threads) const;

private:
  class Random;
  struct Plane {
    float normal[3], offset; // into the mesh
  };
  void begin(const TynWalkEntry &entry, TynRay &ray, Random &random) const;
  bool stays_inside(const PlainMedium &medium, const TynHit &hit, TynRay &ray, Random &random) const;
  void walk(const PlainMedium &medium, const TynWalkEntry &entry, Random random, WalkSums &sums) const;

  const EmbreeOracle &oracle;
  std::vector<Plane> planes; // of the triangles
  float step = 0;            // from a triangle into the mesh, so that a ray does not meet it again
};

} // namespace tyn_test
