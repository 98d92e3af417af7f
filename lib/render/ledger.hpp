// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The ledger of all of a renderer's walks. The order of walks in a queue changes from run to run, so sums are kept in
// integers: the ledger is the same bits for the same samples.
#pragma once

#include "core/context.hpp"
#include "kernels/shared_render.h"

namespace tyn {

class RenderLedger {
public:
  // Adds `count` walks. `partial` has room for partial_bytes(count).
  void add(TynContext &context, const Buffer &entries, const Buffer &exits, const Buffer &tallies, uint32_t count,
           const Buffer &partial);
  TynLedger value() const;

  static size_t partial_bytes(size_t count) {
    return (count + TYN_LEDGER_SLICE - 1) / TYN_LEDGER_SLICE * TYN_LEDGER_COUNT * sizeof(int64_t);
  }

private:
  __extension__ typedef __int128 Wide;
  Wide sums[TYN_LEDGER_COUNT] = {}; // weights in units of 2^-32, counts in units
};

} // namespace tyn
