// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Chooses the cells of the grids, and puts distances and planes into them.
#include "scene/distance_grid.hpp"

#include <algorithm>
#include <cmath>

#include "scene/bvh.hpp"
#include "scene/surface_distances.hpp"
#include "scene/surface_planes.hpp"
#include "scene/vector.hpp"

namespace tyn {
namespace {

// Cells along the longest side: one for a mean free path, of the channel that has the shortest, since longer flights need
// less; without a medium, which an entry may give, some.
constexpr uint32_t COARSEST = 56, FINEST = 160, WITHOUT_MEDIUM = 40;
constexpr uint64_t MOST_BYTES = 32u << 20; // of a scene
// What rounding may have added to a distance: a few ulps of the grid's size; and the direction's length, which a walk keeps
// within 1e-6 of 1, but which callers may give 1e-3 off.
constexpr double MARGIN_CELLS = 2e-3;
constexpr double MARGIN_RELATIVE = 1e-3;
// The slack behind a ray's origin, where hits count; rounding of hits and of the walk's position, a quarter of it each.
constexpr double MARGIN_SLACKS = 4;

// Cells that the triangles come near, each by each: the time that a grid takes.
double work(const Mesh &mesh, double cell) {
  double sum = 0;
  for (size_t i = 0; i < mesh.indices.size() / 3; i++) {
    double longest = 0;
    for (size_t k = 0; k < 3; k++) {
      const Double3 a = to_double(mesh.positions[mesh.indices[3 * i + k]]);
      longest = std::max(longest, length(to_double(mesh.positions[mesh.indices[3 * i + (k + 1) % 3]]) - a));
    }
    const double width = longest > 0 ? length(area_vector(mesh, i)) / longest : 0;
    sum += 2 * SURFACE_DISTANCES_EXACT * (longest / cell + 2 * SURFACE_DISTANCES_EXACT) *
           (width / cell + 2 * SURFACE_DISTANCES_EXACT);
  }
  return sum;
}

// Cells along the longest side; 0 for no grid.
uint32_t cells_along(const Mesh &mesh, const TynMeshRecord &record, const std::vector<TynMediumRecord> &media) {
  if (mesh.medium == TYN_NONE)
    return mesh.info.closed ? WITHOUT_MEDIUM : 0;
  const float *sigma_t = media[mesh.medium].sigma_t;
  const double cells = longest_side(record) * double(std::max({sigma_t[0], sigma_t[1], sigma_t[2]}));
  return uint32_t(std::min(std::max(cells, double(COARSEST)), double(FINEST)));
}

void choose_cells(const Mesh &mesh, TynMeshRecord &record, uint32_t finest) {
  const double longest = longest_side(record);
  if (!(longest > 0 && std::isfinite(longest)))
    return;
  const double allowed = 2e7 + 300.0 * record.triangle_count;
  while (finest > 2 && work(mesh, longest / finest) > allowed)
    finest /= 2;
  const float cell = float(longest / finest);
  const float per_cell = 1 / cell;
  if (!(cell > 0 && std::isfinite(cell) && per_cell > 0 && std::isfinite(per_cell)))
    return;
  record.grid_cell = cell;
  record.grid_per_cell = per_cell;
  for (int k = 0; k < 3; k++)
    record.grid_size[k] = std::clamp(
        uint32_t(std::ceil((double(record.upper[k]) - double(record.lower[k])) / double(cell))), 1u, finest + 1);
}

uint64_t cell_count(const TynMeshRecord &record) {
  return uint64_t(record.grid_size[0]) * record.grid_size[1] * record.grid_size[2];
}

void choose_no_grid(TynMeshRecord &record) {
  record.grid_cell = record.grid_per_cell = record.grid_step = 0;
  record.grid_first = 0; // read, and taken 0 times
  std::fill_n(record.grid_size, 3, 1u);
}

// Returns the number of cells of all meshes, each with so many times fewer along its sides.
uint64_t choose_all(const std::vector<Mesh> &meshes, const std::vector<TynMediumRecord> &media,
                    std::vector<TynMeshRecord> &records, uint32_t fewer) {
  uint64_t sum = 0;
  for (size_t i = 0; i < meshes.size(); i++) {
    choose_no_grid(records[i]);
    const uint32_t along = cells_along(meshes[i], records[i], media);
    if (along > 0)
      choose_cells(meshes[i], records[i], std::max(2u, along / fewer));
    sum += cell_count(records[i]);
  }
  return sum;
}

// Appends the cells: bound = code^2 times the record's step, which is fine near the surface, where it matters.
void append_cells(const Mesh &mesh, TynMeshRecord &record, std::vector<uint32_t> &cells) {
  const std::vector<float> squared = squared_surface_distances(mesh, record);
  const double cell = double(record.grid_cell), margin = MARGIN_CELLS * cell + MARGIN_SLACKS * double(record.slack);
  auto bound = [&](float s) { return std::max(0.0, (std::sqrt(double(s)) * cell - margin) * (1 - MARGIN_RELATIVE)); };
  const double largest = bound(*std::max_element(squared.begin(), squared.end()));
  record.grid_first = uint32_t(cells.size());
  record.grid_step = float(largest / (255 * 255));
  if (!(record.grid_step > 0))
    record.grid_step = 0;
  const std::vector<uint32_t> planes = surface_planes(mesh, record, squared, margin / cell);
  for (size_t i = 0; i < squared.size(); i++) {
    const double steps = record.grid_step > 0 ? bound(squared[i]) / double(record.grid_step) : 0;
    cells.push_back(planes[i] | uint32_t(std::min(255.0, std::floor(std::sqrt(steps)))));
  }
}

} // namespace

std::vector<uint32_t> build_distance_grids(const std::vector<Mesh> &meshes, const std::vector<TynMediumRecord> &media,
                                           std::vector<TynMeshRecord> &records, uint64_t most_bytes) {
  const uint64_t most_cells = std::min(MOST_BYTES, most_bytes) / sizeof(uint32_t);
  uint32_t fewer = 1;
  while (choose_all(meshes, media, records, fewer) > most_cells && fewer < FINEST)
    fewer *= 2;
  if (fewer >= FINEST) // too many meshes
    for (TynMeshRecord &record : records)
      choose_no_grid(record);
  std::vector<uint32_t> cells;
  for (size_t i = 0; i < meshes.size(); i++)
    if (records[i].grid_cell > 0)
      append_cells(meshes[i], records[i], cells);
  if (cells.empty())
    cells.push_back(0);
  return cells;
}

} // namespace tyn
