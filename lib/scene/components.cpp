// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/components.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

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

Double3 middle(const Mesh &mesh, uint32_t triangle) {
  const Double3 sum = corner(mesh, triangle, 0) + corner(mesh, triangle, 1) + corner(mesh, triangle, 2);
  return {sum.x / 3, sum.y / 3, sum.z / 3};
}

// Components that do not cross: one point of the inner one tells. What is inside a surface is strictly inside its box.
bool lies_inside(const Mesh &mesh, const Component &inner, const Component &outer) {
  for (int k = 0; k < 3; k++)
    if (!(outer.lower[k] < inner.lower[k] && inner.upper[k] < outer.upper[k]))
      return false;
  // The middle of a triangle: more often than a vertex, it keeps off a surface that the two touch in.
  return std::abs(winding_number(mesh, outer, middle(mesh, inner.triangles[0]))) > 0.5;
}

// How often the border of a triangle goes around the line through a point along x, on the side of the point where x is
// larger; 0 or +-1. Sums over closed surfaces are winding numbers: an edge gives the same numbers to both of its triangles.
int crossing(const Double3 (&p)[3], const Double3 &point) {
  int around = 0;
  for (int k = 0; k < 3; k++) {
    const Double3 &a = p[k], &b = p[(k + 1) % 3];
    if ((a.y > point.y) == (b.y > point.y))
      continue;
    const Double3 &low = a.y < b.y ? a : b, &high = a.y < b.y ? b : a;
    const double z = low.z + (point.y - low.y) / (high.y - low.y) * (high.z - low.z);
    if (z > point.z)
      around += a.y < b.y ? 1 : -1;
  }
  if (around == 0)
    return 0;
  const Double3 n = cross(p[1] - p[0], p[2] - p[0]);
  return n.x != 0 && dot(n, p[0] - point) / n.x > 0 ? (n.x > 0 ? 1 : -1) : 0;
}

int winding_by_crossings(const Mesh &mesh, const Component &component, const Double3 &point) {
  int sum = 0;
  for (uint32_t i : component.triangles) {
    const Double3 p[3] = {corner(mesh, i, 0), corner(mesh, i, 1), corner(mesh, i, 2)};
    if (std::max({p[0].x, p[1].x, p[2].x}) >= point.x)
      sum += crossing(p, point);
  }
  return sum;
}

bool contains(const Component &component, const Double3 &p) {
  const float *low = component.lower, *high = component.upper;
  return p.x >= double(low[0]) && p.x <= double(high[0]) && p.y >= double(low[1]) && p.y <= double(high[1]) &&
         p.z >= double(low[2]) && p.z <= double(high[2]);
}

// A sweep along x: calls visit(i, open) for each component in `order`, by where it begins, with those that began before it and have
// not ended there, until visit returns false.
template <class F>
void sweep(const std::vector<Component> &components, std::vector<uint32_t> order, F &&visit) {
  std::stable_sort(order.begin(), order.end(),
                   [&](uint32_t a, uint32_t b) { return components[a].lower[0] < components[b].lower[0]; });
  std::vector<uint32_t> open;
  for (uint32_t i : order) {
    const float begin = components[i].lower[0];
    open.erase(
        std::remove_if(open.begin(), open.end(), [&](uint32_t other) { return components[other].upper[0] < begin; }),
        open.end());
    if (!visit(i, open))
      return;
    open.push_back(i);
  }
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

// Whatever a component lies in begins before it and has not ended.
std::vector<Nesting> find_nesting(const Mesh &mesh, const std::vector<Component> &components) {
  std::vector<Nesting> nesting(components.size());
  std::vector<uint32_t> order;
  for (uint32_t i = 0; i < nesting.size(); i++) {
    nesting[i] = {i, 0};
    if (components[i].closed)
      order.push_back(i);
  }
  sweep(components, std::move(order), [&](uint32_t i, const std::vector<uint32_t> &open) {
    for (uint32_t other : open)
      if (lies_inside(mesh, components[i], components[other]) && nesting[i].depth++ == 0)
        nesting[i].outermost = nesting[other].outermost;
    return true;
  });
  return nesting;
}

namespace {

bool boxes_meet(const Component &a, const Component &b) {
  for (int k = 0; k < 3; k++)
    if (a.upper[k] < b.lower[k] || b.upper[k] < a.lower[k])
      return false;
  return true;
}

// Of each component, the others whose boxes meet its own; empty if that takes more than `left` comparisons.
std::vector<std::vector<uint32_t>> find_neighbours(const std::vector<Component> &components, uint64_t left) {
  std::vector<std::vector<uint32_t>> neighbours(components.size());
  std::vector<uint32_t> order(components.size());
  std::iota(order.begin(), order.end(), 0u);
  bool few = true;
  sweep(components, std::move(order), [&](uint32_t i, const std::vector<uint32_t> &open) {
    few = open.size() <= left;
    if (!few)
      return false;
    left -= open.size();
    for (uint32_t other : open)
      if (boxes_meet(components[i], components[other])) {
        neighbours[i].push_back(other);
        neighbours[other].push_back(i);
      }
    return true;
  });
  if (!few)
    neighbours.clear();
  return neighbours;
}

// One of `count` places on a component, spread over its triangles and within them by Roberts' R2 sequence (2018).
Double3 place_on(const Mesh &mesh, const Component &component, size_t place, size_t count) {
  const size_t triangles = component.triangles.size();
  const uint32_t triangle = component.triangles[triangles > count ? place * triangles / count : place % triangles];
  double u = 0.5 + double(place) * 0.7548776662466927, v = 0.5 + double(place) * 0.5698402909980532;
  u -= std::floor(u), v -= std::floor(v);
  if (u + v > 1)
    u = 1 - u, v = 1 - v;
  const Double3 a = corner(mesh, triangle, 0), b = corner(mesh, triangle, 1) - a, c = corner(mesh, triangle, 2) - a;
  return {a.x + u * b.x + v * c.x, a.y + u * b.y + v * c.y, a.z + u * b.z + v * c.z};
}

} // namespace

uint32_t count_overlapping(const Mesh &mesh, const std::vector<Component> &components) {
  constexpr size_t PLACES = 64;                    // of a component
  constexpr uint64_t LEAST = 1u << 16, TIMES = 16; // that many triangles are looked at, or each that often on average
  uint64_t left = std::max<uint64_t>(LEAST, TIMES * (mesh.indices.size() / 3));
  const std::vector<std::vector<uint32_t>> neighbours = find_neighbours(components, left);
  uint32_t count = 0;
  for (size_t i = 0; i < neighbours.size(); i++) {
    const int expected = components[i].volume < 0 ? 1 : 0; // around a cavity is a solid
    bool overlaps = false;
    for (size_t place = 0; place < PLACES && !overlaps; place++) {
      const Double3 point = place_on(mesh, components[i], place, PLACES);
      int around = 0;
      for (uint32_t other : neighbours[i]) {
        if (!contains(components[other], point))
          continue;
        if (left < components[other].triangles.size())
          return count;
        left -= components[other].triangles.size();
        around += winding_by_crossings(mesh, components[other], point);
      }
      overlaps = around != expected;
    }
    count += overlaps;
  }
  return count;
}

} // namespace tyn
