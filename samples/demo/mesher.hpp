// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
//
// A closed, smooth triangle mesh of a signed distance function: dual marching cubes (Nielson 2004) on a grid of which
// only the blocks near the surface are looked at. Every sheet of the surface that passes through a cell has a vertex of
// its own there, so that sheets that come close stay apart.
#pragma once

#include "demo/mesh.hpp"

#include <array>

namespace demo {

template <typename Field>
class Mesher {
public:
  // `field` takes a Vec; its zero set must lie inside the box from `lower` to `upper`.
  Mesher(const Field &field, Vec lower, Vec upper, float cell) : field_(field), origin_(lower), cell_(cell) {
    const Vec size = upper - lower;
    for (int axis = 0; axis < 3; ++axis) {
      const float extent = axis == 0 ? size.x : axis == 1 ? size.y : size.z;
      blocks_[axis] = static_cast<int>(std::ceil(extent / (cell * kBlock))) + 1;
    }
  }

  Mesh run() {
    find_blocks();
    for (Block &block : active_)
      add_vertices(block);
    for (const Block &block : active_)
      add_quads(block);
    for (Vec &position : mesh_.positions)
      settle(position);
    for (const Vec &position : mesh_.positions)
      mesh_.normals.push_back(normalize(gradient(position, 0.5f * cell_)));
    return std::move(mesh_);
  }

private:
  static constexpr int kBlock = 8; // cells along the edge of a block
  static constexpr int kCorners = kBlock + 1;
  static constexpr uint32_t kNone = 0xffffffffu;

  struct Cell {
    uint32_t first_vertex = kNone;
    std::array<uint8_t, 12> sheet; // of each edge that the surface crosses: added to first_vertex
  };

  struct Block {
    std::array<int, 3> first; // cell
    std::array<float, kCorners * kCorners * kCorners> values;
    std::array<Cell, kBlock * kBlock * kBlock> cells;
  };

  Vec corner(int i, int j, int k) const {
    return origin_ + cell_ * Vec{static_cast<float>(i), static_cast<float>(j), static_cast<float>(k)};
  }

  static int value_index(int i, int j, int k) { return (k * kCorners + j) * kCorners + i; }
  static int cell_index(int i, int j, int k) { return (k * kBlock + j) * kBlock + i; }

  // Twice the distance to a block's corner leaves room for functions that are only bounds.
  void find_blocks() {
    const float reach = 2.0f * 0.8660254f * kBlock * cell_;
    block_at_.assign(static_cast<size_t>(blocks_[0]) * blocks_[1] * blocks_[2], kNone);
    for (int z = 0; z < blocks_[2]; ++z)
      for (int y = 0; y < blocks_[1]; ++y)
        for (int x = 0; x < blocks_[0]; ++x) {
          const Vec half = 0.5f * kBlock * cell_ * Vec{1, 1, 1};
          const Vec centre = corner(x * kBlock, y * kBlock, z * kBlock) + half;
          if (std::fabs(field_(centre)) > reach)
            continue;
          block_at_[block_index(x, y, z)] = static_cast<uint32_t>(active_.size());
          active_.emplace_back();
          sample(active_.back(), x, y, z);
        }
  }

  size_t block_index(int x, int y, int z) const { return (static_cast<size_t>(z) * blocks_[1] + y) * blocks_[0] + x; }

  void sample(Block &block, int x, int y, int z) const {
    block.first = {x * kBlock, y * kBlock, z * kBlock};
    for (int k = 0; k < kCorners; ++k)
      for (int j = 0; j < kCorners; ++j)
        for (int i = 0; i < kCorners; ++i)
          block.values[value_index(i, j, k)] =
              field_(corner(block.first[0] + i, block.first[1] + j, block.first[2] + k));
  }

  // Edge `side` (two bits: where it lies on the other two axes) along `axis` of a cell, and its corners (three bits).
  static int edge_index(int axis, int side) { return 4 * axis + side; }
  static int edge_corner(int edge, int end) {
    const int axis = edge / 4, side = edge % 4;
    return (side & 1) << (axis + 1) % 3 | (side >> 1) << (axis + 2) % 3 | end << axis;
  }

  // A vertex for each sheet: the mean of the points where it crosses the cell's edges.
  void add_vertices(Block &block) {
    for (int k = 0; k < kBlock; ++k)
      for (int j = 0; j < kBlock; ++j)
        for (int i = 0; i < kBlock; ++i) {
          float values[8];
          for (int c = 0; c < 8; ++c)
            values[c] = block.values[value_index(i + (c & 1), j + (c >> 1 & 1), k + (c >> 2))];
          const Vec base = corner(block.first[0] + i, block.first[1] + j, block.first[2] + k);
          add_vertices(block.cells[cell_index(i, j, k)], base, values);
        }
  }

  void add_vertices(Cell &cell, Vec base, const float (&values)[8]) {
    int inside = 0;
    for (int c = 0; c < 8; ++c)
      inside |= (values[c] < 0) << c;
    if (inside == 0 || inside == 255)
      return;
    const std::array<int, 12> roots = connect_edges(inside);
    cell.first_vertex = static_cast<uint32_t>(mesh_.positions.size());
    uint8_t sheets = 0;
    for (int root = 0; root < 12; ++root) {
      Vec sum = {0, 0, 0};
      int crossings = 0;
      for (int edge = 0; edge < 12; ++edge) {
        if (roots[edge] != root)
          continue;
        sum = sum + crossing(edge, values);
        cell.sheet[edge] = sheets;
        ++crossings;
      }
      if (!crossings)
        continue;
      mesh_.positions.push_back(base + cell_ / crossings * sum);
      ++sheets;
    }
  }

  static Vec crossing(int edge, const float (&values)[8]) {
    const int a = edge_corner(edge, 0), b = edge_corner(edge, 1);
    const auto position = [](int c) { return Vec{float(c & 1), float(c >> 1 & 1), float(c >> 2)}; };
    return mix(position(a), position(b), values[a] / (values[a] - values[b]));
  }

  // Which of a cell's edges belong to one sheet: a representative for each edge, -1 where there is no crossing. On each
  // face the crossings are connected around the corners that are inside, so that both cells of a face agree.
  static std::array<int, 12> connect_edges(int inside) {
    std::array<int, 12> root;
    for (int edge = 0; edge < 12; ++edge) {
      const bool crossed = (inside >> edge_corner(edge, 0) & 1) != (inside >> edge_corner(edge, 1) & 1);
      root[edge] = crossed ? edge : -1;
    }
    for (int axis = 0; axis < 3; ++axis)
      for (int face = 0; face < 2; ++face)
        connect_face(axis, face, inside, root);
    return root;
  }

  static void connect_face(int axis, int face, int inside, std::array<int, 12> &root) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    // Along u at v = 0, 1, then along v at u = 0, 1. The other two axes of u are v and axis, those of v axis and u.
    const int edges[4] = {edge_index(u, 0 | face << 1), edge_index(u, 1 | face << 1), edge_index(v, face | 0 << 1),
                          edge_index(v, face | 1 << 1)};
    int crossed[4], count = 0;
    for (int edge : edges)
      if (root[edge] >= 0)
        crossed[count++] = edge;
    if (count == 2)
      merge(root, crossed[0], crossed[1]);
    if (count < 4)
      return;
    for (int c = 0; c < 4; ++c) { // two corners inside, diagonally opposite
      const int at_u = c & 1, at_v = c >> 1;
      if (inside >> (face << axis | at_u << u | at_v << v) & 1)
        merge(root, edges[at_v], edges[2 + at_u]);
    }
  }

  static void merge(std::array<int, 12> &root, int a, int b) {
    const int from = root[a], to = root[b];
    for (int &each : root)
      if (each == from)
        each = to;
  }

  uint32_t vertex_of(const int (&cell)[3], int edge) const {
    const size_t at = block_index(cell[0] / kBlock, cell[1] / kBlock, cell[2] / kBlock);
    const Block &block = active_.at(block_at_.at(at)); // throws if the surface leaves the box
    const Cell &c = block.cells[cell_index(cell[0] % kBlock, cell[1] % kBlock, cell[2] % kBlock)];
    return c.first_vertex + c.sheet[edge];
  }

  // One quad for each grid edge that the surface crosses, between the four cells around it.
  void add_quads(const Block &block) {
    for (int k = 0; k < kBlock; ++k)
      for (int j = 0; j < kBlock; ++j)
        for (int i = 0; i < kBlock; ++i)
          for (int axis = 0; axis < 3; ++axis) {
            const int step[3] = {axis == 0, axis == 1, axis == 2};
            const bool inside = block.values[value_index(i, j, k)] < 0;
            if (inside != (block.values[value_index(i + step[0], j + step[1], k + step[2])] < 0))
              add_quad(block.first[0] + i, block.first[1] + j, block.first[2] + k, axis, inside);
          }
  }

  void add_quad(int i, int j, int k, int axis, bool along_axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    uint32_t corners[4];
    for (int n = 0; n < 4; ++n) {
      const int at_u = n == 0 || n == 3, at_v = n == 0 || n == 1; // where the edge lies in this cell
      int cell[3] = {i, j, k};
      cell[u] -= at_u;
      cell[v] -= at_v;
      corners[n] = vertex_of(cell, edge_index(axis, at_u | at_v << 1));
    }
    if (!along_axis)
      std::swap(corners[1], corners[3]);
    const auto square = [&](int a, int b) {
      const Vec d = mesh_.positions[corners[a]] - mesh_.positions[corners[b]];
      return dot(d, d);
    };
    const int first = square(0, 2) <= square(1, 3) ? 0 : 1; // split along the shorter diagonal
    const auto at = [&](int n) { return corners[(first + n) % 4]; };
    mesh_.triangle(at(0), at(1), at(2));
    mesh_.triangle(at(0), at(2), at(3));
  }

  Vec gradient(Vec p, float h) const {
    return (0.5f / h) * Vec{field_(p + Vec{h, 0, 0}) - field_(p - Vec{h, 0, 0}),
                            field_(p + Vec{0, h, 0}) - field_(p - Vec{0, h, 0}),
                            field_(p + Vec{0, 0, h}) - field_(p - Vec{0, 0, h})};
  }

  // A step of Newton's method towards the surface, within the cell.
  void settle(Vec &p) const {
    const Vec slope = gradient(p, 0.1f * cell_);
    const float distance = field_(p) / std::max(length(slope), 0.2f);
    const float limit = 0.3f * cell_;
    p = p - std::clamp(distance, -limit, limit) * normalize(slope);
  }

  const Field &field_;
  Vec origin_;
  float cell_;
  int blocks_[3];
  std::vector<Block> active_;
  std::vector<uint32_t> block_at_;
  Mesh mesh_;
};

template <typename Field>
Mesh polygonize(const Field &field, Vec lower, Vec upper, float cell) {
  return Mesher<Field>(field, lower, upper, cell).run();
}

} // namespace demo
