// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/mesh_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/components.hpp"
#include "scene/edges.hpp"
#include "scene/parity_sets.hpp"
#include "scene/vector.hpp"
#include "scene/weld.hpp"

namespace tyn {
namespace {

uint32_t triangle_count(const Mesh &mesh) { return uint32_t(mesh.indices.size() / 3); }

void turn(Mesh &mesh, uint32_t triangle) {
  std::swap(mesh.indices[3 * size_t(triangle) + 1], mesh.indices[3 * size_t(triangle) + 2]);
  mesh.turned[triangle] ^= 1;
}

void measure_bounds(Mesh &mesh) {
  float *lower = mesh.info.lower, *upper = mesh.info.upper;
  for (int k = 0; k < 3; k++)
    lower[k] = INFINITY, upper[k] = -INFINITY;
  // Only what triangles use: a vertex that none uses is not part of the surface.
  for (uint32_t index : mesh.indices) {
    const float *p = &mesh.positions[index].x;
    for (int k = 0; k < 3; k++)
      lower[k] = std::min(lower[k], p[k]), upper[k] = std::max(upper[k], p[k]);
  }
}

// Area, and volume by the divergence theorem. The origin is moved into the mesh: far away, the terms would cancel.
void measure_size(Mesh &mesh) {
  const TynMeshInfo &info = mesh.info;
  const Double3 centre{0.5 * (double(info.lower[0]) + info.upper[0]), 0.5 * (double(info.lower[1]) + info.upper[1]),
                       0.5 * (double(info.lower[2]) + info.upper[2])};
  double area = 0, volume = 0;
  for (uint32_t i = 0; i < triangle_count(mesh); i++) {
    const Double3 n = area_vector(mesh, i);
    area += 0.5 * length(n);
    volume += dot(n, to_double(mesh.positions[mesh.indices[3 * size_t(i)]]) - centre) / 6;
  }
  mesh.info.area = area;
  mesh.info.volume = volume;
}

void count_degenerate(Mesh &mesh, const std::vector<uint32_t> &corners) {
  mesh.info.degenerate_triangles = 0;
  for (uint32_t i = 0; i < triangle_count(mesh); i++)
    if (!distinct(&corners[3 * size_t(i)]) || length(area_vector(mesh, i)) == 0)
      mesh.info.degenerate_triangles++;
}

// Triangles with the same three positions as an earlier one, whatever their winding.
void count_duplicates(Mesh &mesh, const std::vector<uint32_t> &corners) {
  std::vector<std::array<uint32_t, 3>> keys;
  for (size_t i = 0; i < corners.size(); i += 3) {
    std::array<uint32_t, 3> key{corners[i], corners[i + 1], corners[i + 2]};
    std::sort(key.begin(), key.end());
    if (distinct(key.data()))
      keys.push_back(key);
  }
  std::sort(keys.begin(), keys.end());
  mesh.info.duplicate_triangles = 0;
  for (size_t i = 1; i < keys.size(); i++)
    mesh.info.duplicate_triangles += keys[i] == keys[i - 1];
}

void count_edges(Mesh &mesh, const std::vector<EdgeSide> &sides) {
  mesh.info.boundary_edges = mesh.info.nonmanifold_edges = 0;
  for_each_edge(sides, [&](const EdgeSide *first, const EdgeSide *last) {
    mesh.info.boundary_edges += last - first == 1;
    mesh.info.nonmanifold_edges += last - first > 2;
  });
  mesh.info.closed = !sides.empty() && mesh.info.boundary_edges == 0 && mesh.info.nonmanifold_edges == 0;
}

// Makes neighbours agree over edges with two triangles; in each patch the majority wins, and the lowest triangle at a
// tie. A patch that cannot be oriented (a Moebius strip) stays as it is.
void make_consistent(Mesh &mesh, const std::vector<EdgeSide> &sides) {
  ParitySets sets(triangle_count(mesh));
  for_each_edge(sides, [&](const EdgeSide *first, const EdgeSide *last) {
    // Two triangles agree where they run along their common edge in opposite directions.
    if (last - first == 2)
      sets.join(first[0].triangle, first[1].triangle, first[0].forward == first[1].forward);
  });
  std::vector<int64_t> balance(triangle_count(mesh), 0); // at the root: triangles like it, minus opposite ones
  for (uint32_t i = 0; i < triangle_count(mesh); i++) {
    const ParitySets::Place place = sets.find(i);
    balance[place.root] += place.parity ? -1 : 1;
  }
  for (uint32_t i = 0; i < triangle_count(mesh); i++) {
    const ParitySets::Place place = sets.find(i);
    const uint32_t wrong = balance[place.root] >= 0 ? 1 : 0;
    if (sets.contradictory(place.root) || place.parity != wrong)
      continue;
    turn(mesh, i);
    mesh.info.turned_triangles++;
  }
}

// Normals should be on the side that the triangles around them face. Only normals of the given triangles change.
void turn_inward_normals(Mesh &mesh, const std::vector<uint32_t> &triangles) {
  std::vector<int32_t> votes(mesh.normals.size(), 0);
  for (size_t i = 0; i < triangles.size() && !votes.empty(); i++) {
    const Double3 n = area_vector(mesh, triangles[i]);
    for (size_t k = 0; k < 3; k++) {
      const uint32_t vertex = mesh.indices[3 * size_t(triangles[i]) + k];
      const double agreement = dot(n, to_double(mesh.normals[vertex]));
      votes[vertex] += (agreement > 0) - (agreement < 0);
    }
  }
  for (size_t i = 0; i < votes.size(); i++)
    if (votes[i] < 0)
      mesh.normals[i] = {-mesh.normals[i].x, -mesh.normals[i].y, -mesh.normals[i].z};
}

// A closed component is inside out if its volume is negative and nothing is around it: inside another, it is a cavity.
// What lies inside one that is turned then alternates: a cavity faces inwards, an island in it outwards.
void make_outward(Mesh &mesh, std::vector<Component> &components) {
  auto inverted = [](const Component &component) { return component.closed && component.volume < 0; };
  if (std::none_of(components.begin(), components.end(), inverted))
    return;
  const std::vector<Nesting> nesting = find_nesting(mesh, components);
  std::vector<uint32_t> triangles;
  std::vector<Component *> turned;
  for (size_t i = 0; i < components.size(); i++) {
    const bool outwards = nesting[i].depth % 2 == 0;
    if (!inverted(components[nesting[i].outermost]) || inverted(components[i]) != outwards)
      continue;
    triangles.insert(triangles.end(), components[i].triangles.begin(), components[i].triangles.end());
    turned.push_back(&components[i]);
    mesh.info.inverted_components++;
  }
  for (Component *component : turned)
    component->volume = -component->volume;
  for (uint32_t triangle : triangles)
    turn(mesh, triangle);
  turn_inward_normals(mesh, triangles);
}

} // namespace

void check_mesh(Mesh &mesh) {
  const Welded welded = weld(mesh.positions);
  std::vector<uint32_t> corners(mesh.indices.size());
  for (size_t i = 0; i < corners.size(); i++)
    corners[i] = welded.vertex[mesh.indices[i]];
  const std::vector<EdgeSide> sides = sorted_edge_sides(corners);

  mesh.turned.assign(triangle_count(mesh), 0);
  mesh.info = TynMeshInfo{};
  mesh.info.size = sizeof mesh.info;
  mesh.info.vertex_count = uint32_t(mesh.positions.size());
  mesh.info.triangle_count = triangle_count(mesh);
  mesh.info.welded_vertex_count = welded.count;
  count_degenerate(mesh, corners);
  count_duplicates(mesh, corners);
  count_edges(mesh, sides);
  // Where nothing is inside, the caller's winding says which side is the front: a room faces inwards.
  const bool filled = mesh.medium != TYN_NONE;
  if (filled)
    make_consistent(mesh, sides);
  std::vector<Component> components = find_components(mesh, corners, sides);
  mesh.info.components = uint32_t(components.size());
  if (filled) {
    make_outward(mesh, components);
    if (mesh.info.closed)
      mesh.info.overlapping_components = count_overlapping(mesh, components);
  }
  measure_bounds(mesh);
  measure_size(mesh);
  if (!filled)
    mesh.info.volume = std::abs(mesh.info.volume);
}

} // namespace tyn
