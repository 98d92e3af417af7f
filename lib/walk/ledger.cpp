// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "walk/walk.hpp"

namespace tyn {

namespace {

struct Column {
  double *weight; // where what is left of the walk's weight goes; NULL: nothing is left
  uint64_t *walks;
};

Column column_of(TynLedger &ledger, uint32_t status) {
  switch (status) {
  case TYN_WALK_ESCAPED:
    return {ledger.escaped, &ledger.escaped_walks};
  case TYN_WALK_ABSORBED:
    return {nullptr, &ledger.absorbed_walks};
  case TYN_WALK_CAPPED:
    return {ledger.capped, &ledger.capped_walks};
  case TYN_WALK_LEAKED:
    return {ledger.leaked, &ledger.leaked_walks};
  case TYN_WALK_REFLECTED:
    return {nullptr, &ledger.reflected_walks};
  default:
    return {ledger.lost, &ledger.lost_walks};
  }
}

} // namespace

void add_to_ledger(TynLedger &ledger, const TynWalkEntry *entries, const TynWalkExit *exits,
                   const TynWalkTally *tallies, size_t count) {
  for (size_t i = 0; i < count; ++i) {
    Column column = column_of(ledger, exits[i].status);
    ++*column.walks;
    ++ledger.walks;
    ledger.scatterings += exits[i].scatterings;
    for (int c = 0; c < 3; ++c) {
      ledger.entered[c] += entries[i].weight[c];
      ledger.reflected[c] += tallies[i].reflected[c];
      ledger.absorbed[c] += tallies[i].absorbed[c];
      ledger.balance[c] += tallies[i].balance[c];
      if (column.weight)
        column.weight[c] += exits[i].weight[c];
    }
  }
}

} // namespace tyn
