// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Disjoint sets whose members also carry a parity relative to each other: are two triangles wound alike?
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace tyn {

class ParitySets {
public:
  struct Place {
    uint32_t root;
    uint32_t parity; // 0: like the root, 1: opposite
  };

  explicit ParitySets(uint32_t count) : parent(count), parity(count, 0), contradicted(count, 0) {
    for (uint32_t i = 0; i < count; i++)
      parent[i] = i;
  }

  Place find(uint32_t i) {
    // To the root, then once more to hang everything on the way directly below it.
    uint32_t root = i, total = 0;
    while (parent[root] != root) {
      total ^= parity[root];
      root = parent[root];
    }
    const Place place{root, total};
    while (parent[i] != root) {
      const uint32_t next = parent[i], here = parity[i];
      parent[i] = root;
      parity[i] = uint8_t(total);
      total ^= here;
      i = next;
    }
    return place;
  }

  // Joins the sets of a and b, whose parities differ by `difference` (0 or 1). The lower root stays, so that the
  // result does not depend on anything but the joins themselves.
  void join(uint32_t a, uint32_t b, uint32_t difference) {
    Place p = find(a), q = find(b);
    if (p.root == q.root) {
      if ((p.parity ^ q.parity) != difference)
        contradicted[p.root] = 1;
      return;
    }
    if (p.root > q.root)
      std::swap(p, q);
    parent[q.root] = p.root;
    parity[q.root] = uint8_t(p.parity ^ q.parity ^ difference);
    contradicted[p.root] |= contradicted[q.root];
  }

  // Whether joins of the set with this root contradict each other.
  bool contradictory(uint32_t root) const { return contradicted[root] != 0; }

private:
  std::vector<uint32_t> parent;
  std::vector<uint8_t> parity, contradicted;
};

} // namespace tyn
