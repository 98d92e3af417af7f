// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/components.hpp"

#include <algorithm>
#include <cmath>

#include "scene/parity_sets.hpp"
#include "scene/vector.hpp"

namespace tyn {
namespace {

constexpr double PI = 3.14159265358979323846;

Double3 corner(const Mesh &mesh, uint32_t triangle, size_t k) {
  return to_double(mesh.positions[mesh.indices[3 * size_t(triangle) + k]]);
}

// The divergence theorem, with the origin moved into the component: far away, the terms would cancel.
void measure(const Mesh &mesh, Component &component) {
  std::fill_n(component.lower, 3, INFINITY);
  std::fill_n(component.upper, 3, -INFINITY);
  for (uint32_t i : component.triangles)
    for (size_t j = 0; j < 3; j++) {
      const float *p = &mesh.positions[mesh.indices[3 * size_t(i) + j]].x;
      for (int k = 0; k < 3; k++) {
        component.lower[k] = std::min(component.lower[k], p[k]);
        component.upper[k] = std::max(component.upper[k], p[k]);
      }
    }
  const Double3 origin = corner(mesh, component.triangles[0], 0);
  for (uint32_t i : component.triangles)
    component.volume += dot(area_vector(mesh, i), corner(mesh, i, 0) - origin) / 6;
}

// How often a closed surface goes around a point: the solid angles that its triangles fill, over that of a sphere.
double winding_number(const Mesh &mesh, const Component &component, const Double3 &point) {
  double sum = 0;
  for (uint32_t i : component.triangles) {
    const Double3 a = corner(mesh, i, 0) - point, b = corner(mesh, i, 1) - point, c = corner(mesh, i, 2) - point;
    const double la = length(a), lb = length(b), lc = length(c);
    sum += 2 * std::atan2(dot(a, cross(b, c)), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
  }
  return sum / (4 * PI);
}

// Components that do not cross: one point of the inner one tells. What is inside a surface is strictly inside its box.
bool lies_inside(const Mesh &mesh, const Component &inner, const Component &outer) {
  for (int k = 0; k < 3; k++)
    if (!(outer.lower[k] < inner.lower[k] && inner.upper[k] < outer.upper[k]))
      return false;
  // The middle of a triangle: more often than a vertex, it keeps off a surface that the two touch in.
  const uint32_t i = inner.triangles[0];
  const Double3 sum = corner(mesh, i, 0) + corner(mesh, i, 1) + corner(mesh, i, 2);
  return std::abs(winding_number(mesh, outer, {sum.x / 3, sum.y / 3, sum.z / 3})) > 0.5;
}

} // namespace

std::vector<Component> find_components(const Mesh &mesh, const std::vector<uint32_t> &corners,
                                       const std::vector<EdgeSide> &sides) {
  const uint32_t count = uint32_t(corners.size() / 3);
  ParitySets sets(count);
  for_each_edge(sides, [&](const EdgeSide *first, const EdgeSide *last) {
    for (const EdgeSide *side = first + 1; side != last; ++side)
      sets.join(first->triangle, side->triangle, 0);
  });
  std::vector<Component> components;
  std::vector<uint32_t> number(count, TYN_NONE); // of the component of a triangle; the root comes first
  for (uint32_t i = 0; i < count; i++) {
    if (!distinct(&corners[3 * size_t(i)]))
      continue;
    const uint32_t root = sets.find(i).root;
    if (root == i) {
      number[i] = uint32_t(components.size());
      components.emplace_back();
    }
    number[i] = number[root];
    components[number[i]].triangles.push_back(i);
  }
  for_each_edge(sides, [&](const EdgeSide *first, const EdgeSide *last) {
    auto forward = [&](const EdgeSide &side) { return side.forward ^ mesh.turned[side.triangle]; };
    if (last - first != 2 || forward(first[0]) == forward(first[1]))
      components[number[first->triangle]].closed = false;
  });
  for (Component &component : components)
    measure(mesh, component);
  return components;
}

// A sweep along x: whatever a component lies in begins before it and has not ended.
std::vector<Nesting> find_nesting(const Mesh &mesh, const std::vector<Component> &components) {
  std::vector<Nesting> nesting(components.size());
  std::vector<uint32_t> order, open;
  for (uint32_t i = 0; i < nesting.size(); i++) {
    nesting[i] = {i, 0};
    if (components[i].closed)
      order.push_back(i);
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](uint32_t a, uint32_t b) { return components[a].lower[0] < components[b].lower[0]; });
  for (uint32_t i : order) {
    const float begin = components[i].lower[0];
    open.erase(
        std::remove_if(open.begin(), open.end(), [&](uint32_t other) { return components[other].upper[0] < begin; }),
        open.end());
    for (uint32_t other : open)
      if (lies_inside(mesh, components[i], components[other]) && nesting[i].depth++ == 0)
        nesting[i].outermost = nesting[other].outermost;
    open.push_back(i);
  }
  return nesting;
}

} // namespace tyn
