// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "bssrdf/exact_file.hpp"

#include <cstring>

#include "core/cache.hpp"
#include "media/phase.hpp"

namespace tyn {
namespace {

constexpr unsigned FORMAT = 2; // also to be raised when the walks change

// What comes before the counts of walks, which are those of the escapes' grid.
struct Head {
  EscapeGrid grid;
  uint64_t left;
  double mean_cosine;
  double corrections[ExactTable::STEPS + 1];
  double entries[ExactTable::STEPS + 1][ExactTable::COSINES];
};

template <class T>
void put(unsigned char *&to, const T *values, size_t count) {
  std::memcpy(to, values, count * sizeof(T));
  to += count * sizeof(T);
}

template <class T>
std::vector<T> take(const unsigned char *&from, size_t count) {
  std::vector<T> values(count);
  std::memcpy(values.data(), from, count * sizeof(T));
  from += count * sizeof(T);
  return values;
}

size_t counts_of(const EscapeGrid &grid) { return grid.orders + grid.cells(); }

} // namespace

std::string exact_key(const TynPhase &phase, double ior, uint64_t events, uint64_t seed) {
  PhaseTables tables;
  TynPhaseRecord record = tables.add(phase);
  const uint64_t hash = hash_bytes(tables.data.data(), tables.data.size() * sizeof(float));
  return format("exact %u\nphase %u %.9g %.9g %.9g %.9g %u %016llx\nior %.17g\nevents %llu\nseed %llu\n", FORMAT,
                record.kind, double(record.g), double(record.g2), double(record.weight), double(record.alpha),
                record.count, (unsigned long long)hash, ior, (unsigned long long)events, (unsigned long long)seed);
}

bool load_exact_table(const std::string &path, const std::string &key, const TynPhase &phase, ExactTable &table) {
  const EscapeGrid grid = escape_grid(phase_mean_cosine(phase));
  const Binary binary = load_binary(path, key); // checks that nothing is damaged
  Head head;
  if (binary.size() < sizeof head)
    return false;
  std::memcpy(&head, binary.data(), sizeof head);
  const bool same =
      head.grid.orders == grid.orders && head.grid.first_radius == grid.first_radius && head.grid.radii == grid.radii;
  if (!same || binary.size() != sizeof head + counts_of(grid) * sizeof(uint64_t))
    return false;
  const unsigned char *from = binary.data() + sizeof head;
  table.escapes.grid = head.grid;
  table.escapes.walks = take<uint64_t>(from, head.grid.orders);
  table.escapes.counts = take<uint64_t>(from, head.grid.cells());
  table.escapes.left = head.left;
  table.mean_cosine = head.mean_cosine;
  std::memcpy(table.corrections.data(), head.corrections, sizeof head.corrections);
  std::memcpy(table.entries.data(), head.entries, sizeof head.entries);
  return true;
}

void store_exact_table(const std::string &path, const std::string &key, const ExactTable &table) {
  Head head{};
  head.grid = table.escapes.grid;
  head.left = table.escapes.left;
  head.mean_cosine = table.mean_cosine;
  std::memcpy(head.corrections, table.corrections.data(), sizeof head.corrections);
  std::memcpy(head.entries, table.entries.data(), sizeof head.entries);
  Binary binary(sizeof head + counts_of(head.grid) * sizeof(uint64_t));
  unsigned char *to = binary.data();
  put(to, &head, 1);
  put(to, table.escapes.walks.data(), table.escapes.walks.size());
  put(to, table.escapes.counts.data(), table.escapes.counts.size());
  store_binary(path, key, binary);
}

} // namespace tyn
