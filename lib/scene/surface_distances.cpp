// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Near the surface the distance from a cell's centre to the nearest triangle is exact. Farther away it is that to the nearest
// cell that may hold a piece of surface: a distance transform axis by axis (Felzenszwalb & Huttenlocher 2012, "Distance
// Transforms of Sampled Functions") over the gaps between a point and boxes, by search, which is as fast for grids of this
// size. Lengths are in cells here.
#include "scene/surface_distances.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "scene/cell_triangle.hpp"

namespace tyn {
namespace {

constexpr float REACH = SURFACE_DISTANCES_EXACT;

// The distances of one mesh while they are found.
class Distances {
public:
  Distances(const Mesh &mesh_, const TynMeshRecord &record_) : mesh(mesh_), record(record_) {
    for (int k = 0; k < 3; k++) {
      size[k] = record.grid_size[k];
      extent[k] = float((double(record.upper[k]) - record.lower[k]) / record.grid_cell);
    }
    near.assign(size_t(size[0]) * size[1] * size[2], INFINITY);
  }

  std::vector<float> squared() {
    for (size_t i = 0; i < mesh.indices.size() / 3; i++)
      add_triangle(i);
    find_gaps_along_rows();
    find_gaps_across(size[1], size[0], size[2], size_t(size[0]) * size[1], false);
    find_gaps_across(size[2], size_t(size[0]) * size[1], size[1], size[0], true);
    for (size_t i = 0; i < near.size(); i++)
      near[i] = near[i] <= REACH * REACH ? std::min(near[i], border[i])
                                         : std::min(std::max(far[i], REACH * REACH), border[i]);
    return std::move(near);
  }

private:
  struct Range {
    int first[3], last[3]; // inclusive
  };

  size_t index(int x, int y, int z) const { return (size_t(z) * size[1] + size_t(y)) * size[0] + size_t(x); }

  void add_triangle(size_t triangle) {
    Double3 p[3];
    for (size_t i = 0; i < 3; i++) {
      const Double3 v = to_double(mesh.positions[mesh.indices[3 * triangle + i]]);
      const double scale = 1.0 / double(record.grid_cell);
      p[i] = {(v.x - double(record.lower[0])) * scale, (v.y - double(record.lower[1])) * scale,
              (v.z - double(record.lower[2])) * scale};
    }
    const CellTriangle cells(p);
    Range range;
    for (int k = 0; k < 3; k++) {
      const auto [lowest, highest] = std::minmax({cells.corner[0][k], cells.corner[1][k], cells.corner[2][k]});
      range.first[k] = std::clamp(int(std::ceil(lowest - REACH - 0.51f)), 0, int(size[k]) - 1);
      range.last[k] = std::clamp(int(std::floor(highest + REACH - 0.49f)), 0, int(size[k]) - 1);
    }
    add_to_range(cells, range);
  }

  // Halves large ranges, and leaves out the halves that the triangle is far from.
  void add_to_range(const CellTriangle &triangle, const Range &range) {
    int longest = 0, length[3];
    for (int k = 0; k < 3; k++) {
      length[k] = range.last[k] - range.first[k] + 1;
      longest = length[k] > length[longest] ? k : longest;
    }
    if (length[0] * length[1] * length[2] <= 128)
      return add_to_cells(triangle, range);
    Range halves[2] = {range, range};
    halves[0].last[longest] = range.first[longest] + length[longest] / 2 - 1;
    halves[1].first[longest] = halves[0].last[longest] + 1;
    for (const Range &half : halves)
      if (may_reach(triangle, half))
        add_to_range(triangle, half);
  }

  static bool may_reach(const CellTriangle &triangle, const Range &range) {
    float centre[3], squared = 0;
    for (int k = 0; k < 3; k++) {
      centre[k] = 0.5f * float(range.first[k] + range.last[k] + 1);
      const float half = 0.5f * float(range.last[k] - range.first[k]);
      squared += half * half;
    }
    const float reach = std::sqrt(squared) + REACH + 0.01f;
    return triangle.squared_distance(centre[0], centre[1], centre[2]) <= reach * reach;
  }

  void add_to_cells(const CellTriangle &triangle, const Range &range) {
    for (int z = range.first[2]; z <= range.last[2]; z++)
      for (int y = range.first[1]; y <= range.last[1]; y++) {
        float *row = &near[index(0, y, z)];
        for (int x = range.first[0]; x <= range.last[0]; x++)
          row[x] = std::min(row[x], triangle.squared_distance(float(x) + 0.5f, float(y) + 0.5f, float(z) + 0.5f));
      }
  }

  // From a cell's centre to the box of a cell `steps` away along an axis.
  static float squared_gap(size_t steps) {
    const float gap = std::max(0.0f, float(steps) - 0.5f);
    return gap * gap;
  }

  // From a cell's centre to where a walk would leave the bounds along an axis.
  float to_bounds(int axis, size_t i) const {
    return std::max(0.0f, std::min(float(i) + 0.5f, extent[axis] - (float(i) + 0.5f)));
  }

  // In each row the gap to the nearest cell that may hold surface: some of it is within half a diagonal of the centre.
  void find_gaps_along_rows() {
    far.assign(near.size(), INFINITY);
    const size_t count = size[0];
    for (size_t row = 0; row < near.size(); row += count)
      for (const bool forwards : {true, false}) {
        size_t steps = SIZE_MAX;
        for (size_t i = 0; i < count; i++) {
          const size_t at = row + (forwards ? i : count - 1 - i);
          if (near[at] <= 0.76f)
            steps = 0;
          else if (steps != SIZE_MAX)
            steps++;
          if (steps != SIZE_MAX)
            far[at] = std::min(far[at], squared_gap(steps));
        }
      }
  }

  // The same across: of `count` rows, `stride` apart, each gets the least of what the others have plus the gap to them. There
  // are `lines` such sets of rows, `line_stride` apart. A walk that leaves the bounds has to be noticed too, so that nothing
  // farther away than these matters. `last`: the axis is z.
  void find_gaps_across(size_t count, size_t stride, size_t lines, size_t line_stride, bool last) {
    std::vector<float> result(far.size());
    if (last)
      border.resize(far.size());
    std::vector<float> best(size[0]), limit(size[0]);
    for (size_t line = 0; line < lines; line++)
      for (size_t i = 0; i < count; i++) {
        const size_t y = last ? line : i;
        const float yz = last ? std::min(to_bounds(1, y), to_bounds(2, i)) : to_bounds(1, y);
        for (size_t x = 0; x < size[0]; x++) {
          const float bound = std::min(to_bounds(0, x), yz);
          limit[x] = bound * bound;
        }
        const float *rows = &far[line * line_stride];
        search(rows, count, stride, i, limit, best);
        const size_t at = line * line_stride + i * stride;
        std::copy(best.begin(), best.end(), &result[at]);
        if (last)
          std::copy(limit.begin(), limit.end(), &border[at]);
      }
    far.swap(result);
  }

  void search(const float *rows, size_t count, size_t stride, size_t i, const std::vector<float> &limit,
              std::vector<float> &best) const {
    const size_t width = size[0];
    for (size_t x = 0; x < width; x++)
      best[x] = std::min(limit[x], rows[i * stride + x]);
    for (size_t steps = 1; steps < count; steps++) {
      const float gap = squared_gap(steps);
      if (gap >= *std::max_element(best.begin(), best.end()))
        break;
      const float *below = i >= steps ? rows + (i - steps) * stride : nullptr;
      const float *above = i + steps < count ? rows + (i + steps) * stride : nullptr;
      for (const float *row : {below, above})
        for (size_t x = 0; row && x < width; x++)
          best[x] = std::min(best[x], row[x] + gap);
    }
  }

  const Mesh &mesh;
  const TynMeshRecord &record;
  uint32_t size[3];
  float extent[3]; // of the bounds; the last cells may reach beyond
  std::vector<float> near, far, border;
};

} // namespace

std::vector<float> squared_surface_distances(const Mesh &mesh, const TynMeshRecord &record) {
  return Distances(mesh, record).squared();
}

} // namespace tyn
