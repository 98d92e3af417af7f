// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Points with a few numbers each, found by where they are, and gone through several at a time.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace tyn {

constexpr size_t POINT_LANES = 4;

// GCC and Clang compute with them lane by lane, by one instruction where the processor has it.
typedef float Float4 __attribute__((vector_size(POINT_LANES * sizeof(float))));

inline Float4 load_float4(const float *from) {
  Float4 lanes;
  std::memcpy(&lanes, from, sizeof lanes);
  return lanes;
}

inline Float4 lane_minimum(Float4 a, Float4 b) { return a < b ? a : b; }

inline float lane_sum(Float4 lanes) { return (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]); }

// Coordinates, each in an array of its own, so that loops over them are vectorized. N: of a point, and what else it has.
template <size_t N>
struct PointCloud {
  std::vector<float> of[N];
  size_t count = 0;

  void add(const float (&values)[N]) {
    for (size_t k = 0; k < N; k++)
      of[k].push_back(values[k]);
    count++;
  }

  // Room for `most` and for a whole number of POINT_LANES.
  void clear(size_t most) {
    count = 0;
    for (std::vector<float> &values : of)
      if (values.size() < most + POINT_LANES)
        values.resize(most + POINT_LANES);
  }

  // Fills the last POINT_LANES with points that are far from everything.
  void pad() {
    for (size_t k = 0; k < N; k++)
      std::fill_n(&of[k][count], POINT_LANES, k < 3 ? 1e6f : 0.0f);
  }
};

constexpr int BIN_CELLS = 4; // cells along the side of a bin

// A cloud sorted by bins of cells.
template <size_t N>
class PointBins {
public:
  PointBins(const PointCloud<N> &from, const int (&grid)[3]) {
    for (int k = 0; k < 3; k++)
      size[k] = (grid[k] + BIN_CELLS - 1) / BIN_CELLS;
    first.assign(size_t(size[0]) * size_t(size[1]) * size_t(size[2]) + 1, 0);
    std::vector<uint32_t> bin(from.count);
    for (size_t i = 0; i < from.count; i++) {
      bin[i] = uint32_t(index(of(from.of[0][i], 0), of(from.of[1][i], 1), of(from.of[2][i], 2)));
      first[bin[i] + 1]++;
    }
    for (size_t i = 1; i < first.size(); i++)
      first[i] += first[i - 1];
    std::vector<uint32_t> next(first.begin(), first.end() - 1);
    for (std::vector<float> &values : all.of)
      values.resize(from.count);
    for (size_t i = 0; i < from.count; i++) {
      const size_t to = next[bin[i]]++;
      for (size_t k = 0; k < N; k++)
        all.of[k][to] = from.of[k][i];
    }
  }

  // What is within a ball around c, relative to c.
  void gather(const float (&c)[3], float radius, PointCloud<N> &near) {
    int from[3], to[3];
    for (int k = 0; k < 3; k++) {
      from[k] = of(c[k] - radius, k);
      to[k] = of(c[k] + radius, k);
    }
    found.clear();
    for_rows(from, to, [&](size_t begin, size_t end) {
      const size_t before = found.size();
      found.resize(before + (end - begin));
      uint32_t *next = found.data() + before;
      for (size_t i = begin; i < end; i++) {
        const float x = all.of[0][i] - c[0], y = all.of[1][i] - c[1], z = all.of[2][i] - c[2];
        *next = uint32_t(i);
        next += x * x + y * y + z * z <= radius * radius;
      }
      found.resize(size_t(next - found.data()));
    });
    near.clear(found.size());
    near.count = found.size();
    for (size_t k = 0; k < N; k++) {
      const float *values = all.of[k].data(), origin = k < 3 ? c[k] : 0;
      for (size_t i = 0; i < found.size(); i++)
        near.of[k][i] = values[found[i]] - origin;
    }
    near.pad();
  }

private:
  // Points beyond the grid are in its outermost bins.
  int of(float x, int axis) const { return std::clamp(int(x * (1.0f / BIN_CELLS)), 0, size[axis] - 1); }
  size_t index(int x, int y, int z) const {
    return (size_t(z) * size_t(size[1]) + size_t(y)) * size_t(size[0]) + size_t(x);
  }

  template <class F>
  void for_rows(const int (&from)[3], const int (&to)[3], F &&f) const {
    for (int z = from[2]; z <= to[2]; z++)
      for (int y = from[1]; y <= to[1]; y++)
        f(first[index(from[0], y, z)], first[index(to[0], y, z) + 1]);
  }

  int size[3];
  std::vector<uint32_t> first;
  PointCloud<N> all;
  std::vector<uint32_t> found; // by the last search
};

} // namespace tyn
