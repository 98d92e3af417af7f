// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// A linear function takes its least value over a triangle at a corner; so a plane that has the corners of all triangles that
// reach into a ball on its far side has the surface in the ball there. Whether one reaches is asked of a ball around it, for
// which long triangles are cut. Lengths are in cells.
#include "scene/surface_planes.hpp"

#include <algorithm>
#include <cmath>

#include "scene/octahedral_normal.hpp"
#include "scene/point_bins.hpp"
#include "scene/vector.hpp"

namespace tyn {
namespace {

constexpr float LARGEST = 0.9f; // radius of a piece of a triangle
constexpr float NEAR = 2;       // cells whose centre is farther away from the surface get no plane
constexpr float OUTSIDE = -1; // nor those that are all outside: about so far from the surface, half a diagonal is 0.87
constexpr float GIVEN_UP = 0.05f; // of a plane's distance for each cell that the ball's radius grows
constexpr float BLUR = 2.5f;      // radius of the ball whose surface gives a plane's normal
constexpr int BRICK = 2;          // cells along the side of those that are looked at together
// of a piece of surface: its middle, its normal times twice its area, its radius, and its corners from the middle
constexpr size_t PIECE = 16;
constexpr float FAR = 1e30f;

struct Limits {
  float front[TYN_CLEAR_REACHES]; // least of n p over the surface in each ball
};

class Planes {
public:
  Planes(const Mesh &mesh_, const TynMeshRecord &record_, const std::vector<float> &squared_, double margin_)
      : mesh(mesh_), record(record_), squared(squared_), margin(float(margin_)) {
    for (int k = 0; k < 3; k++) {
      size[k] = int(record.grid_size[k]);
      extent[k] = float((double(record.upper[k]) - double(record.lower[k])) / double(record.grid_cell));
    }
  }

  std::vector<uint32_t> codes() {
    cut_triangles();
    PointBins<6> patches(mean_patches(), size);
    PointBins<PIECE> surface(pieces, size);
    for (int i = 0; i < TYN_CLEAR_REACHES; i++) {
      const float r = TYN_CLEAR_REACH_STEP * float(i + 1) * 1.002f + margin; // directions' lengths are 1 within 1e-3
      reach[i] = r;
    }
    std::vector<uint32_t> result(squared.size(), 0);
    for (int z = 0; z < size[2]; z += BRICK)
      for (int y = 0; y < size[1]; y += BRICK)
        for (int x = 0; x < size[0]; x += BRICK)
          add_brick(x, y, z, surface, patches, result);
    return result;
  }

private:
  size_t index(int x, int y, int z) const {
    return (size_t(z) * size_t(size[1]) + size_t(y)) * size_t(size[0]) + size_t(x);
  }

  Double3 in_cells(const Vec3 &position) const {
    const double scale = 1 / double(record.grid_cell);
    return {(double(position.x) - double(record.lower[0])) * scale,
            (double(position.y) - double(record.lower[1])) * scale,
            (double(position.z) - double(record.lower[2])) * scale};
  }

  void cut_triangles() {
    for (size_t i = 0; i < mesh.indices.size() / 3; i++)
      add_piece(in_cells(mesh.positions[mesh.indices[3 * i]]), in_cells(mesh.positions[mesh.indices[3 * i + 1]]),
                in_cells(mesh.positions[mesh.indices[3 * i + 2]]));
  }

  // Halves the longest edge as long as the triangle is too large.
  void add_piece(const Double3 &a, const Double3 &b, const Double3 &c) {
    const double third = 1.0 / 3;
    const Double3 m{(a.x + b.x + c.x) * third, (a.y + b.y + c.y) * third, (a.z + b.z + c.z) * third};
    const Double3 from[3] = {a - m, b - m, c - m};
    const double radius = std::sqrt(std::max({dot(from[0], from[0]), dot(from[1], from[1]), dot(from[2], from[2])}));
    if (radius > double(LARGEST)) {
      const double ab = length(b - a), bc = length(c - b), ca = length(a - c), longest = std::max({ab, bc, ca});
      if (ab < longest)
        return bc < longest ? add_piece(c, a, b) : add_piece(b, c, a);
      const Double3 middle{(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2};
      add_piece(a, middle, c);
      return add_piece(middle, b, c);
    }
    const Double3 n = cross(b - a, c - a);
    pieces.add({float(m.x), float(m.y), float(m.z), float(n.x), float(n.y), float(n.z), float(radius), float(from[0].x),
                float(from[0].y), float(from[0].z), float(from[1].x), float(from[1].y), float(from[1].z),
                float(from[2].x), float(from[2].y), float(from[2].z)});
    largest = std::max(largest, float(radius));
  }

  // The pieces of each cell together, for there may be many: where they are on average, and the sum of their normals.
  PointCloud<6> mean_patches() {
    std::vector<uint32_t> patch_of(squared.size(), TYN_NONE);
    PointCloud<6> patches;
    std::vector<float> count;
    for (size_t i = 0; i < pieces.count; i++) {
      int at[3];
      for (size_t k = 0; k < 3; k++)
        at[k] = std::clamp(int(pieces.of[k][i]), 0, size[k] - 1);
      uint32_t &patch = patch_of[index(at[0], at[1], at[2])];
      if (patch == TYN_NONE) {
        patch = uint32_t(patches.count);
        patches.add({0, 0, 0, 0, 0, 0});
        count.push_back(0);
      }
      for (size_t k = 0; k < 6; k++)
        patches.of[k][patch] += pieces.of[k][i];
      count[patch]++;
    }
    for (size_t k = 0; k < 3; k++)
      for (size_t i = 0; i < patches.count; i++)
        patches.of[k][i] /= count[i];
    return patches;
  }

  void add_brick(int x, int y, int z, PointBins<PIECE> &surface, PointBins<6> &patches, std::vector<uint32_t> &result) {
    const int end[3] = {std::min(x + BRICK, size[0]), std::min(y + BRICK, size[1]), std::min(z + BRICK, size[2])};
    bool gathered = false, has_pieces = false;
    const float c[3] = {float(x) + 0.5f * BRICK, float(y) + 0.5f * BRICK, float(z) + 0.5f * BRICK};
    const float half_diagonal = 0.8661f * float(BRICK - 1);
    for (int k = z; k < end[2]; k++)
      for (int j = y; j < end[1]; j++)
        for (int i = x; i < end[0]; i++) {
          if (squared[index(i, j, k)] > NEAR * NEAR)
            continue;
          if (!gathered)
            patches.gather(c, BLUR + half_diagonal, near_patches);
          gathered = true;
          const float from[3] = {float(i) + 0.5f - c[0], float(j) + 0.5f - c[1], float(k) + 0.5f - c[2]};
          Double3 mean;
          if (!find_normal(from, mean))
            continue;
          if (!has_pieces)
            surface.gather(c, reach[TYN_CLEAR_REACHES - 1] + largest + half_diagonal, near_pieces);
          has_pieces = true;
          result[index(i, j, k)] = code(i, j, k, from, OctahedralNormal(mean));
        }
  }

  // The mean of the surface's normal around a cell's centre, less the farther away; false where all is outside.
  bool find_normal(const float (&c)[3], Double3 &mean) const {
    const float *of[6];
    for (size_t k = 0; k < 6; k++)
      of[k] = near_patches.of[k].data();
    Float4 nx{}, ny{}, nz{}, height{};
    for (size_t i = 0; i < near_patches.count; i += POINT_LANES) {
      const Float4 px = load_float4(of[0] + i) - c[0], py = load_float4(of[1] + i) - c[1],
                   pz = load_float4(of[2] + i) - c[2];
      const Float4 rest = 1.0f - (px * px + py * py + pz * pz) * (1 / (BLUR * BLUR)),
                   kept = rest > 0.0f ? rest : Float4{};
      const Float4 weight = kept * kept;
      const Float4 x = weight * load_float4(of[3] + i), y = weight * load_float4(of[4] + i),
                   z = weight * load_float4(of[5] + i);
      nx += x, ny += y, nz += z;
      height += x * px + y * py + z * pz;
    }
    mean = {double(lane_sum(nx)), double(lane_sum(ny)), double(lane_sum(nz))};
    const float size_of_mean = float(length(mean));
    return size_of_mean > 0 && lane_sum(height) >= OUTSIDE * size_of_mean;
  }

  uint32_t code(int x, int y, int z, const float (&from)[3], const OctahedralNormal &normal) const {
    const Float3 n = normal.decoded();
    Limits limits = surface_limits(from, n);
    limit_to_bounds(x, y, z, n, limits);
    int best = -1;
    float most = -1;
    for (int i = 0; i < TYN_CLEAR_REACHES; i++) {
      // of a ball without surface the whole is clear
      const float worth = std::min(limits.front[i], reach[i]) + GIVEN_UP * TYN_CLEAR_REACH_STEP * float(i);
      if (limits.front[i] > -0.5f && worth > most) {
        most = worth;
        best = i;
      }
    }
    if (best < 0)
      return 0;
    const float steps = (limits.front[best] - margin + 1) / TYN_CLEAR_PLANE_STEP;
    const uint32_t offset = uint32_t(std::clamp(std::floor(steps), 0.0f, 255.0f));
    return offset == 0 ? 0
                       : offset << 8 | (uint32_t(normal.u) & 127u) << 16 | (uint32_t(normal.v) & 127u) << 23 |
                             uint32_t(best) << 30;
  }

  Limits surface_limits(const float (&c)[3], const Float3 &n) const {
    const float *of[PIECE];
    for (size_t k = 0; k < PIECE; k++)
      of[k] = near_pieces.of[k].data();
    Float4 least[TYN_CLEAR_REACHES];
    const Float4 far = Float4{} + FAR;
    for (Float4 &lanes : least)
      lanes = far;
    for (size_t i = 0; i < near_pieces.count; i += POINT_LANES) {
      const Float4 px = load_float4(of[0] + i) - c[0], py = load_float4(of[1] + i) - c[1],
                   pz = load_float4(of[2] + i) - c[2];
      const Float4 distance = px * px + py * py + pz * pz, radius = load_float4(of[6] + i);
      auto corner = [&](size_t k) {
        return n.x * load_float4(of[k] + i) + n.y * load_float4(of[k + 1] + i) + n.z * load_float4(of[k + 2] + i);
      };
      const Float4 along =
          n.x * px + n.y * py + n.z * pz + lane_minimum(corner(7), lane_minimum(corner(10), corner(13)));
      for (int k = 0; k < TYN_CLEAR_REACHES; k++) {
        const Float4 touches = radius + reach[k];
        least[k] = lane_minimum(least[k], distance <= touches * touches ? along : far);
      }
    }
    Limits limits;
    for (int k = 0; k < TYN_CLEAR_REACHES; k++)
      limits.front[k] = std::min(std::min(least[k][0], least[k][1]), std::min(least[k][2], least[k][3]));
    return limits;
  }

  // A walk that leaves the bounds has to be noticed: what is beyond them counts as surface.
  void limit_to_bounds(int x, int y, int z, const Float3 &n, Limits &limits) const {
    const float c[3] = {float(x) + 0.5f, float(y) + 0.5f, float(z) + 0.5f}, normal[3] = {n.x, n.y, n.z};
    const float squared_length = n.x * n.x + n.y * n.y + n.z * n.z;
    for (int axis = 0; axis < 3; axis++)
      for (const bool upper : {false, true}) {
        const float height = upper ? extent[axis] - c[axis] : c[axis];
        const float outward = upper ? normal[axis] : -normal[axis];
        for (int i = 0; i < TYN_CLEAR_REACHES; i++) {
          const float radius = reach[i];
          if (height >= radius)
            continue;
          if (height < 0 || -outward * radius > height * std::sqrt(squared_length)) {
            limits.front[i] = -FAR;
            continue;
          }
          const float across = std::sqrt(std::max(0.0f, squared_length - outward * outward));
          limits.front[i] =
              std::min(limits.front[i], outward * height - across * std::sqrt(radius * radius - height * height));
        }
      }
  }

  const Mesh &mesh;
  const TynMeshRecord &record;
  const std::vector<float> &squared;
  const float margin;
  int size[3];
  float extent[3]; // of the bounds; the last cells may reach beyond
  float reach[TYN_CLEAR_REACHES];
  float largest = 0; // radius of a piece
  PointCloud<PIECE> pieces;
  PointCloud<PIECE> near_pieces;
  PointCloud<6> near_patches;
};

} // namespace

std::vector<uint32_t> surface_planes(const Mesh &mesh, const TynMeshRecord &record, const std::vector<float> &squared,
                                     double margin) {
  if (margin >= 3) // far from the origin: no plane near a cell would be left
    return std::vector<uint32_t>(squared.size(), 0);
  return Planes(mesh, record, squared, margin).codes();
}

} // namespace tyn
