// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/local_roots.hpp"

#include <algorithm>
#include <cmath>

namespace tyn {
namespace {

constexpr double TRIANGLES_A_CELL = 12;
constexpr uint32_t FINEST = 192;           // cells along the longest side
constexpr uint64_t MOST_BYTES = 32u << 20; // of a scene
constexpr float MARGIN = 1.0f / 64;        // of a cell: what rounding may add to the box of a ray

struct Box {
  float lower[3], upper[3];
};

struct Child {
  uint32_t reference;
  Box box;
};

bool is_inner(uint32_t reference) { return !(reference & TYN_CHILD_LEAF); }

bool overlap(const TynBvhNode &node, uint32_t i, const Box &box) {
  for (int k = 0; k < 3; k++)
    if (!(node.bounds[k][i] <= box.upper[k] && node.bounds[k + 3][i] >= box.lower[k]))
      return false;
  return true;
}

// Appends the children that overlap the box.
void append_children(const TynBvhNode &node, const Box &box, std::vector<Child> &children) {
  for (uint32_t i = 0; i < TYN_BVH_WIDTH; i++)
    if (node.child[i] != TYN_CHILD_EMPTY && overlap(node, i, box)) {
      Child child{node.child[i], {}};
      for (int k = 0; k < 3; k++)
        child.box.lower[k] = node.bounds[k][i], child.box.upper[k] = node.bounds[k + 3][i];
      children.push_back(child);
    }
}

bool overlap(const Box &a, const Box &b) {
  for (int k = 0; k < 3; k++)
    if (!(a.lower[k] <= b.upper[k] && a.upper[k] >= b.lower[k]))
      return false;
  return true;
}

float half_area(const Box &box) {
  const float x = box.upper[0] - box.lower[0], y = box.upper[1] - box.lower[1], z = box.upper[2] - box.lower[2];
  return x * y + y * z + z * x;
}

// The local roots of a mesh. Blocks of cells are halved; each half starts from the nodes that the whole has come down to.
class LocalRoots {
public:
  LocalRoots(Bvh &bvh_, const TynMeshRecord &record_, uint32_t *cells_, size_t most_nodes_)
      : bvh(bvh_), record(record_), cells(cells_), most_nodes(most_nodes_), levels(64) {}

  void add() {
    const Range all{{0, 0, 0}, {record.local_size[0], record.local_size[1], record.local_size[2]}};
    append_children(bvh.nodes[record.root], box_of(all), levels[0]);
    add_range(all, 0);
  }

private:
  struct Range {
    uint32_t first[3], end[3];
  };

  // What is around belongs to a cell, and what rounding and the slack behind a ray's origin may add.
  Box box_of(const Range &range) const {
    Box box;
    const float reach = TYN_LOCAL_REACH + MARGIN;
    for (int k = 0; k < 3; k++) {
      box.lower[k] = record.lower[k] + (float(range.first[k]) - reach) * record.local_cell - 2 * record.slack;
      box.upper[k] = record.lower[k] + (float(range.end[k]) + reach) * record.local_cell + 2 * record.slack;
    }
    return box;
  }

  // levels[depth]: nodes that hold all that overlaps the range.
  void add_range(const Range &range, size_t depth) {
    const Box box = box_of(range);
    std::vector<Child> &children = levels[depth];
    open(children, box);
    int longest = 0;
    for (int k = 1; k < 3; k++)
      if (range.end[k] - range.first[k] > range.end[longest] - range.first[longest])
        longest = k;
    const uint32_t size = range.end[longest] - range.first[longest];
    if (children.empty() || size == 1)
      return fill(range, append_root(children));
    for (const bool upper : {false, true}) {
      Range half = range;
      (upper ? half.first : half.end)[longest] = range.first[longest] + size / 2;
      const Box half_box = box_of(half);
      levels[depth + 1].clear();
      for (const Child &child : children)
        if (overlap(child.box, half_box))
          levels[depth + 1].push_back(child);
      add_range(half, depth + 1);
    }
  }

  // Opens the largest of the nodes as long as what then overlaps the box finds a place.
  void open(std::vector<Child> &children, const Box &box) {
    closed.assign(children.size(), 0);
    for (;;) {
      size_t largest = children.size();
      float area = -1;
      for (size_t i = 0; i < children.size(); i++)
        if (!closed[i] && is_inner(children[i].reference) && half_area(children[i].box) > area) {
          largest = i;
          area = half_area(children[i].box);
        }
      if (largest == children.size())
        return;
      opened.clear();
      append_children(bvh.nodes[children[largest].reference], box, opened);
      if (children.size() - 1 + opened.size() > TYN_BVH_WIDTH) {
        closed[largest] = 1;
        continue;
      }
      children[largest] = children.back();
      closed[largest] = closed.back();
      children.pop_back();
      children.insert(children.end(), opened.begin(), opened.end());
      closed.resize(children.size() - opened.size());
      closed.resize(children.size(), 0);
    }
  }

  // Returns TYN_NONE where nothing is near.
  uint32_t append_root(const std::vector<Child> &children) {
    if (children.empty())
      return TYN_NONE;
    if (children.size() == 1 && is_inner(children[0].reference))
      return children[0].reference;
    TynBvhNode node;
    for (uint32_t i = 0; i < TYN_BVH_WIDTH; i++) {
      const bool used = i < children.size();
      for (int k = 0; k < 3; k++) {
        node.bounds[k][i] = used ? children[i].box.lower[k] : INFINITY;
        node.bounds[k + 3][i] = used ? children[i].box.upper[k] : -INFINITY;
      }
      node.child[i] = used ? children[i].reference : TYN_CHILD_EMPTY;
    }
    // the one before is often the same
    if (added > 0 && std::equal(node.child, node.child + TYN_BVH_WIDTH, bvh.nodes.back().child))
      return uint32_t(bvh.nodes.size() - 1);
    if (added == most_nodes || bvh.nodes.size() >= TYN_CHILD_LEAF)
      return record.root;
    bvh.nodes.push_back(node);
    added++;
    return uint32_t(bvh.nodes.size() - 1);
  }

  void fill(const Range &range, uint32_t root) {
    for (uint32_t z = range.first[2]; z < range.end[2]; z++)
      for (uint32_t y = range.first[1]; y < range.end[1]; y++) {
        uint32_t *row = cells + (size_t(z) * record.local_size[1] + y) * record.local_size[0];
        std::fill(row + range.first[0], row + range.end[0], root);
      }
  }

  Bvh &bvh;
  const TynMeshRecord &record;
  uint32_t *const cells;
  const size_t most_nodes;
  size_t added = 0;
  std::vector<std::vector<Child>> levels;
  std::vector<Child> opened;
  std::vector<uint8_t> closed;
};

// One cell that is larger than the mesh, whose root is the mesh's own: every walk looks for its local root.
void add_none(TynMeshRecord &record, std::vector<uint32_t> &cells) {
  const float cell = float(4 * longest_side(record));
  const bool usable = cell > 0 && std::isfinite(cell) && std::isfinite(1 / cell);
  record.local_cell = usable ? cell : 0;
  record.local_per_cell = usable ? 1 / cell : 0;
  std::fill_n(record.local_size, 3, 1u);
  record.local_first = uint32_t(cells.size());
  cells.push_back(record.root);
}

// The number of cells; 0 where no grid would be of use or find a place.
uint64_t choose_cells(TynMeshRecord &record, uint64_t most_bytes) {
  double extent[3];
  for (int k = 0; k < 3; k++)
    extent[k] = double(record.upper[k]) - double(record.lower[k]);
  const double longest = longest_side(record);
  // as many cells as the bounds' six sides would need
  const double sides = 2 * (extent[0] * extent[1] + extent[1] * extent[2] + extent[2] * extent[0]);
  double along = std::sqrt(record.triangle_count / TRIANGLES_A_CELL * longest * longest / sides);
  for (along = std::ceil(std::min(along, double(FINEST))); along >= 2; along = std::floor(along / 2)) {
    record.local_cell = float(longest / along);
    record.local_per_cell = 1 / record.local_cell;
    if (!std::isfinite(record.local_per_cell))
      continue;
    uint64_t count = 1;
    for (int k = 0; k < 3; k++) {
      record.local_size[k] = std::clamp(uint32_t(std::ceil(extent[k] * double(record.local_per_cell))), 1u, FINEST + 1);
      count *= record.local_size[k];
    }
    // half for the cells, half for their roots
    if (count * sizeof(uint32_t) <= most_bytes / 2)
      return count;
  }
  return 0;
}

} // namespace

void add_local_roots(Bvh &bvh, std::vector<TynMeshRecord> &records, std::vector<uint32_t> &cells, uint64_t most_bytes) {
  uint64_t left = std::min(MOST_BYTES, most_bytes);
  for (TynMeshRecord &record : records) {
    const uint64_t count = record.grid_cell > 0 ? choose_cells(record, left) : 0;
    if (count == 0) {
      add_none(record, cells);
      continue;
    }
    const size_t nodes = bvh.nodes.size();
    record.local_first = uint32_t(cells.size());
    cells.resize(cells.size() + count);
    LocalRoots(bvh, record, &cells[record.local_first], left / 2 / sizeof(TynBvhNode)).add();
    left -= count * sizeof(uint32_t) + (bvh.nodes.size() - nodes) * sizeof(TynBvhNode);
  }
}

} // namespace tyn
