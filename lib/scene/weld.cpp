// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/weld.hpp"

#include <cstring>

namespace tyn {
namespace {

bool same(const Vec3 &a, const Vec3 &b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

uint64_t bits(float value) {
  value += 0.0f; // -0 becomes +0
  uint32_t result;
  std::memcpy(&result, &value, sizeof result);
  return result;
}

// The finalizer of splitmix64 (Steele, Lea, Flood 2014) over the three coordinates.
uint64_t hash(const Vec3 &p) {
  uint64_t h = (bits(p.x) << 32 | bits(p.y)) + 0x9e3779b97f4a7c15u * (bits(p.z) + 1);
  h = (h ^ h >> 30) * 0xbf58476d1ce4e5b9u;
  h = (h ^ h >> 27) * 0x94d049bb133111ebu;
  return h ^ h >> 31;
}

} // namespace

Welded weld(const std::vector<Vec3> &positions) {
  size_t capacity = 16;
  while (capacity < 2 * positions.size())
    capacity *= 2;
  // Open addressing: the table holds vertices, the first of each position.
  std::vector<uint32_t> table(capacity, TYN_NONE);
  Welded welded;
  welded.vertex.resize(positions.size());
  for (size_t i = 0; i < positions.size(); i++) {
    size_t slot = hash(positions[i]) & (capacity - 1);
    while (table[slot] != TYN_NONE && !same(positions[table[slot]], positions[i]))
      slot = (slot + 1) & (capacity - 1);
    if (table[slot] == TYN_NONE) {
      table[slot] = uint32_t(i);
      welded.vertex[i] = welded.count++;
    } else {
      welded.vertex[i] = welded.vertex[table[slot]];
    }
  }
  return welded;
}

} // namespace tyn
