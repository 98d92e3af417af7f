// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// What a run leaves behind.
#pragma once

#include <array>
#include <atomic>
#include <vector>

#include "tyndall/tyndall_slab.h"

namespace tyn {

using SlabQuantities = std::array<std::vector<TynEstimate>, TYN_SLAB_QUANTITY_COUNT>;

struct SlabChannelResult {
  TynSlabTotals totals{};
  SlabQuantities quantities;
};

} // namespace tyn

struct TynSlabResult {
  TynSlabRun run{};
  std::vector<tyn::SlabChannelResult> channels;
  std::atomic<uint32_t> references{1};
};
