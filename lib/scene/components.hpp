// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The connected parts of a mesh, and which lie inside which.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/edges.hpp"
#include "scene/scene.hpp"

namespace tyn {

// Triangles that share an edge, of any kind. Triangles without edges belong to none.
struct Component {
  std::vector<uint32_t> triangles; // ascending
  bool closed = true;              // each edge has two triangles, and they are wound alike
  float lower[3], upper[3];
  double volume = 0; // signed: negative where the triangles face inwards
};

// By the lowest triangle. `corners` are three welded vertices a triangle, `sides` their edges before triangles were
// turned.
std::vector<Component> find_components(const Mesh &mesh, const std::vector<uint32_t> &corners,
                                       const std::vector<EdgeSide> &sides);

// How deep a component lies inside others. Open ones lie nowhere, and nothing lies inside them.
struct Nesting {
  uint32_t outermost; // the component that all others around it lie in; itself if there is none
  uint32_t depth;     // how many it lies in
};

std::vector<Nesting> find_nesting(const Mesh &mesh, const std::vector<Component> &components);

// How many components of a closed mesh, wound outwards and cavities inwards, reach into others or touch them: what is around a
// place on an outward one is nothing, and around a cavity one solid. A few places of each are looked at, and fewer in meshes
// of many components and triangles: what overlaps little may be missed.
uint32_t count_overlapping(const Mesh &mesh, const std::vector<Component> &components);

} // namespace tyn
