// SPDX-License-Identifier: Apache-2.0
// Sums what walks did with their weight. Integers in units of 2^-32: exact, whatever the order and the grouping.
#include "math.clh"
#include "shared_render.h"

// Nearest multiple of 2^-32; beyond 2^20 and for NaN the number is cut: a path's weight is far below.
static long ledger_fixed(float weight) {
  float w = weight == weight ? clamp(weight, -0x1p20f, 0x1p20f) : 0.0f;
  return convert_long_rte(w * 0x1p32f);
}

static void ledger_add(long sums[TYN_LEDGER_COUNT], uint place, global const float *weight) {
  for (uint c = 0; c < 3; ++c)
    sums[place + c] += ledger_fixed(weight[c]);
}

// `partial`: TYN_LEDGER_COUNT sums of each slice of TYN_LEDGER_SLICE walks.
kernel void ledger_sum(global const TynWalkEntry *entries, global const TynWalkExit *exits,
                       global const TynWalkTally *tallies, uint count, global long *partial) {
  uint slice = (uint)get_global_id(0);
  uint first = slice * TYN_LEDGER_SLICE;
  if (first >= count)
    return;
  long sums[TYN_LEDGER_COUNT];
  for (uint i = 0; i < TYN_LEDGER_COUNT; ++i)
    sums[i] = 0;
  uint end = min(first + TYN_LEDGER_SLICE, count);
  for (uint i = first; i < end; ++i) {
    ledger_add(sums, TYN_LEDGER_ENTERED, entries[i].weight);
    ledger_add(sums, TYN_LEDGER_REFLECTED, tallies[i].reflected);
    ledger_add(sums, TYN_LEDGER_ABSORBED, tallies[i].absorbed);
    ledger_add(sums, TYN_LEDGER_BALANCE, tallies[i].balance);
    uint status = exits[i].status;
    if (status == TYN_WALK_ESCAPED)
      ledger_add(sums, TYN_LEDGER_ESCAPED, exits[i].weight);
    if (status == TYN_WALK_CAPPED)
      ledger_add(sums, TYN_LEDGER_CAPPED, exits[i].weight);
    if (status == TYN_WALK_LEAKED)
      ledger_add(sums, TYN_LEDGER_LEAKED, exits[i].weight);
    if (status == TYN_WALK_LOST)
      ledger_add(sums, TYN_LEDGER_LOST, exits[i].weight);
    sums[TYN_LEDGER_SCATTERINGS] += exits[i].scatterings;
    if (status < 6)
      sums[TYN_LEDGER_WALKS + status] += 1;
  }
  for (uint i = 0; i < TYN_LEDGER_COUNT; ++i)
    partial[(size_t)slice * TYN_LEDGER_COUNT + i] = sums[i];
}
