// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// In the frame of a triangle T, z up into the mesh, a point q of another triangle is seen from a point p of T under an angle
// whose tangent is at most h(q) / s(q), where h is q's height and s its distance from a line that has T on one side and q on
// the other. Both are linear over a triangle beyond that line, so their ratio is largest at one of its corners; a corner that
// it shares with T, where both are 0, does not count. Of the lines along T's edges and of those that touch it at a corner,
// halfway between its edges, the one that gives the least bound is taken.
#include "scene/horizons.hpp"

#include <algorithm>
#include <cmath>

#include "scene/vector.hpp"

namespace tyn {
namespace {

constexpr double REACH_CELLS = 1;       // of the distance grid
constexpr double REACH_TRIANGLES = 1.5; // mean ones: where they are small, there would be very many within a cell
constexpr double MARGIN = 2e-3;         // of the sine: rounding of directions and normals
constexpr double THINNEST =
    1e-3; // sine between two edges, below which the kernels' normal is off by more than the margin
constexpr size_t MOST_NEIGHBOURS = 256; // a triangle with more has no horizon
constexpr size_t MOST_NEAR_LEAF = 4096; // nor has one in a leaf with more
constexpr size_t LANES = 8;

struct Corners {
  Double3 p[3];
};

Corners corners(const Mesh &mesh, size_t triangle) {
  const uint32_t *index = &mesh.indices[3 * triangle];
  return {
      {to_double(mesh.positions[index[0]]), to_double(mesh.positions[index[1]]), to_double(mesh.positions[index[2]])}};
}

Double3 scaled(const Double3 &v, double s) { return {v.x * s, v.y * s, v.z * s}; }
bool same(const Double3 &a, const Double3 &b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

class Frame {
public:
  Frame(const Corners &corners_, double slack_) : triangle(corners_), slack(slack_) {
    const Double3 n = cross(triangle.p[1] - triangle.p[0], triangle.p[2] - triangle.p[0]);
    const double area = length(n);
    flat = !(area > THINNEST * length(triangle.p[1] - triangle.p[0]) * length(triangle.p[2] - triangle.p[0]));
    up = flat ? n : scaled(n, -1 / area);
    for (size_t i = 0; i < 3; i++) {
      const Double3 side = cross(triangle.p[(i + 1) % 3] - triangle.p[i], up); // outwards: up points inwards
      const double size = length(side);
      flat = flat || !(size > 0);
      outwards[i] = flat ? side : scaled(side, -1 / size);
    }
    for (size_t i = 0; i < 3; i++) { // corner i is between the edges i and i - 1
      const Double3 sum = outwards[i] + outwards[(i + 2) % 3];
      const double size = length(sum);
      flat = flat || !(size > 0);
      outwards[3 + i] = flat ? sum : scaled(sum, 1 / size);
    }
    for (size_t i = 0; i < 6; i++) {
      across[0][i] = float(outwards[i].x), across[1][i] = float(outwards[i].y), across[2][i] = float(outwards[i].z);
      offset[i] = float(dot(outwards[i], triangle.p[i % 3] - triangle.p[0]));
    }
  }

  bool has_no_area() const { return flat; }

  const Double3 &inwards() const { return up; }

  // Tangent of the largest angle under which `other` is seen from the triangle; infinite if that is not known. The line that
  // `other` is farthest beyond is nearly always the best; the others are tried where it does not help.
  double tangent(const Corners &other) const {
    const bool own[3] = {is_own(other.p[0]), is_own(other.p[1]), is_own(other.p[2])};
    const Double3 middle = scaled(other.p[0] + other.p[1] + other.p[2], 1.0 / 3) - triangle.p[0];
    const float x = float(middle.x), y = float(middle.y), z = float(middle.z);
    float beyond[LANES];
    for (size_t i = 0; i < LANES; i++)
      beyond[i] = across[0][i] * x + across[1][i] * y + across[2][i] * z - offset[i];
    const size_t best = size_t(std::max_element(beyond, beyond + 6) - beyond);
    double least = tangent_beyond(best, other, own);
    for (size_t i = 0; i < 6 && !(least < 1); i++)
      least = std::min(least, tangent_beyond(i, other, own));
    return least;
  }

private:
  bool is_own(const Double3 &p) const {
    return same(p, triangle.p[0]) || same(p, triangle.p[1]) || same(p, triangle.p[2]);
  }

  double tangent_beyond(size_t line, const Corners &other, const bool (&own)[3]) const {
    double height[3], beyond[3], largest = 0;
    bool touches = false;
    for (int k = 0; k < 3; k++) {
      const Double3 from = other.p[k] - triangle.p[line % 3];
      height[k] = dot(up, from);
      beyond[k] = dot(outwards[line], from);
      touches = touches || own[k] || std::abs(beyond[k]) < 64 * slack;
    }
    for (int k = 0; k < 3; k++) {
      if (own[k]) {
        if (beyond[k] < -1e-12 * length(other.p[k] - triangle.p[line % 3]) - 1e-300)
          return INFINITY; // the corner across
        continue;
      }
      // where surfaces touch, one that falls away counts as well: a ray sees a little of what is behind it
      const double h = touches ? std::abs(height[k]) : height[k];
      if (!(beyond[k] > 4 * slack))
        return INFINITY;
      // a start may be a slack off its triangle: see walk_is_on_triangle
      largest = std::max(largest, (h + slack) / (beyond[k] - slack));
    }
    return largest;
  }

  const Corners triangle;
  const double slack;
  Double3 up, outwards[6];
  float across[3][LANES] = {}, offset[LANES] = {}; // of the lines, from the first corner, to choose one by
  bool flat;
};

// The horizons of one mesh, leaf by leaf of its tree: what is near one of a leaf's triangles is near the leaf.
class MeshHorizons {
public:
  MeshHorizons(const Mesh &mesh_, const Bvh &bvh_, const TynMeshRecord &record_, TynTriangleRecord *triangles_)
      : mesh(mesh_), bvh(bvh_), record(record_), triangles(triangles_),
        // what rounding may add to a flight, and how far behind its origin a hit counts
        reach(double(record_.horizon_reach) * 1.002 + 4 * double(record_.slack)) {}

  void find() {
    if (4 * double(record.slack) > double(record.horizon_reach))
      return; // far from the origin, where a whole mesh may be within the slack
    std::vector<uint32_t> inner(1, record.root);
    while (!inner.empty()) {
      const TynBvhNode &node = bvh.nodes[inner.back()];
      inner.pop_back();
      for (uint32_t i = 0; i < TYN_BVH_WIDTH; i++)
        if (node.child[i] == TYN_CHILD_EMPTY)
          continue;
        else if (node.child[i] & TYN_CHILD_LEAF)
          find_in_leaf(node, i);
        else
          inner.push_back(node.child[i]);
    }
  }

private:
  // A ball around each triangle, relative to the leaf.
  struct Balls {
    std::vector<float> x, y, z, radius;
  };

  template <class F>
  void for_leaf(uint32_t child, F &&f) const {
    const uint32_t first = (child & ~TYN_CHILD_LEAF) >> 4;
    for (uint32_t block = first; block < first + (child & 15u); block++)
      for (const uint32_t triangle : bvh.blocks[block].triangle)
        if (triangle != TYN_NONE)
          f(triangle - record.first_triangle);
  }

  void find_in_leaf(const TynBvhNode &node, uint32_t leaf) {
    float lower[3], upper[3];
    for (int k = 0; k < 3; k++) {
      lower[k] = float(double(node.bounds[k][leaf]) - reach * 1.001);
      upper[k] = float(double(node.bounds[k + 3][leaf]) + reach * 1.001);
    }
    if (!find_neighbours(lower, upper))
      return;
    const Double3 middle{0.5 * (double(lower[0]) + double(upper[0])), 0.5 * (double(lower[1]) + double(upper[1])),
                         0.5 * (double(lower[2]) + double(upper[2]))};
    find_balls(middle);
    for_leaf(node.child[leaf], [&](uint32_t triangle) { triangles[triangle].horizon = sine(triangle); });
  }

  // Those whose leaves come near; false if they are too many.
  bool find_neighbours(const float (&lower)[3], const float (&upper)[3]) {
    neighbours.clear();
    stack.assign(1, record.root);
    while (!stack.empty() && neighbours.size() <= MOST_NEAR_LEAF) {
      const TynBvhNode &node = bvh.nodes[stack.back()];
      stack.pop_back();
      uint32_t meets[TYN_BVH_WIDTH];
      for (uint32_t i = 0; i < TYN_BVH_WIDTH; i++)
        meets[i] = (node.bounds[0][i] <= upper[0]) & (node.bounds[1][i] <= upper[1]) & (node.bounds[2][i] <= upper[2]) &
                   (node.bounds[3][i] >= lower[0]) & (node.bounds[4][i] >= lower[1]) & (node.bounds[5][i] >= lower[2]);
      for (uint32_t i = 0; i < TYN_BVH_WIDTH; i++)
        if (meets[i] && node.child[i] != TYN_CHILD_EMPTY) {
          if (node.child[i] & TYN_CHILD_LEAF)
            for_leaf(node.child[i], [&](uint32_t triangle) { neighbours.push_back(triangle); });
          else
            stack.push_back(node.child[i]);
        }
    }
    return neighbours.size() <= MOST_NEAR_LEAF;
  }

  void find_balls(const Double3 &middle) {
    const size_t count = neighbours.size(), room = count + LANES;
    near.resize(count);
    for (std::vector<float> *values : {&balls.x, &balls.y, &balls.z, &balls.radius})
      values->resize(std::max(values->size(), room));
    for (size_t i = 0; i < count; i++) {
      near[i] = corners(mesh, neighbours[i]);
      const Double3 c = scaled(near[i].p[0] + near[i].p[1] + near[i].p[2], 1.0 / 3), from = c - middle;
      double squared = 0;
      for (const Double3 &p : near[i].p)
        squared = std::max(squared, dot(p - c, p - c));
      balls.x[i] = float(from.x), balls.y[i] = float(from.y), balls.z[i] = float(from.z);
      balls.radius[i] = float(std::sqrt(squared));
    }
    for (size_t i = count; i < room; i++) // near nothing
      balls.x[i] = balls.y[i] = balls.z[i] = INFINITY, balls.radius[i] = 0;
  }

  float sine(uint32_t triangle) {
    const size_t own = size_t(std::find(neighbours.begin(), neighbours.end(), triangle) - neighbours.begin());
    const Frame frame(near[own], double(record.slack));
    if (frame.has_no_area())
      return TYN_NO_HORIZON;
    find_near(own);
    if (close.size() > MOST_NEIGHBOURS)
      return TYN_NO_HORIZON;
    double tangent = 0;
    for (const uint32_t other : close)
      if (other != own && tangent < 1)
        tangent = std::max(tangent, frame.tangent(near[other]));
    if (!(tangent < 1))
      return TYN_NO_HORIZON;
    const double result = tangent / std::sqrt(1 + tangent * tangent) + MARGIN;
    return stays_within_bounds(near[own], frame.inwards(), result) ? float(result) : TYN_NO_HORIZON;
  }

  // The neighbours whose balls are within reach of the triangle's.
  void find_near(size_t own) {
    close.clear();
    const float x = balls.x[own], y = balls.y[own], z = balls.z[own];
    const float around = (balls.radius[own] + float(reach)) * 1.001f;
    for (size_t i = 0; i < neighbours.size(); i += LANES) {
      uint32_t meets[LANES], any = 0;
      for (size_t l = 0; l < LANES; l++) {
        const float dx = balls.x[i + l] - x, dy = balls.y[i + l] - y, dz = balls.z[i + l] - z;
        const float most = around + balls.radius[i + l] * 1.001f;
        meets[l] = dx * dx + dy * dy + dz * dz <= most * most;
        any |= meets[l];
      }
      for (size_t l = 0; any && l < LANES; l++)
        if (meets[l])
          close.push_back(uint32_t(i + l));
    }
  }

  // A walk that leaves the bounds, as it may through a hole, has to be noticed: no direction as steep as that gets there.
  bool stays_within_bounds(const Corners &own, const Double3 &inwards, double horizon) const {
    const double up[3] = {inwards.x, inwards.y, inwards.z};
    const double *p[3] = {&own.p[0].x, &own.p[1].x, &own.p[2].x};
    for (int k = 0; k < 3; k++)
      for (const bool upper : {false, true}) {
        const double outwards = upper ? up[k] : -up[k];
        // of the directions allowed, how fast the fastest goes outwards
        const double fastest = outwards >= horizon
                                   ? 1
                                   : outwards * horizon + std::sqrt(std::max(0.0, 1 - outwards * outwards)) *
                                                              std::sqrt(std::max(0.0, 1 - horizon * horizon));
        const double gap = upper ? double(record.upper[k]) - std::max({p[0][k], p[1][k], p[2][k]})
                                 : std::min({p[0][k], p[1][k], p[2][k]}) - double(record.lower[k]);
        if (fastest * reach > gap)
          return false;
      }
    return true;
  }

  const Mesh &mesh;
  const Bvh &bvh;
  const TynMeshRecord &record;
  TynTriangleRecord *const triangles; // of the mesh
  const double reach;
  std::vector<uint32_t> neighbours, stack;
  std::vector<Corners> near;   // of the neighbours
  Balls balls;                 // around them
  std::vector<uint32_t> close; // which of them are within reach of one triangle
};

double mean_size(const Mesh &mesh) {
  double area = 0;
  const size_t count = mesh.indices.size() / 3;
  for (size_t i = 0; i < count; i++)
    area += length(area_vector(mesh, i));
  return std::sqrt(area / double(std::max<size_t>(1, count)));
}

} // namespace

void find_horizons(const std::vector<Mesh> &meshes, const Bvh &bvh, std::vector<TynMeshRecord> &records,
                   std::vector<TynTriangleRecord> &triangles) {
  for (size_t i = 0; i < meshes.size(); i++) {
    TynMeshRecord &record = records[i];
    TynTriangleRecord *own = triangles.data() + record.first_triangle;
    for (uint32_t k = 0; k < record.triangle_count; k++)
      own[k].horizon = TYN_NO_HORIZON; // of those that are not in the tree, too
    record.horizon_reach =
        float(std::min(REACH_CELLS * double(record.grid_cell), REACH_TRIANGLES * mean_size(meshes[i])));
    if (record.horizon_reach > 0)
      MeshHorizons(meshes[i], bvh, record, own).find();
  }
}

} // namespace tyn
