// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// A prepared model: its profiles, and what the kernels read of them.
#pragma once

#include <atomic>
#include <vector>

#include "bssrdf/profile.hpp"
#include "core/context.hpp"
#include "tyndall/tyndall_bssrdf.h"

namespace tyn {

struct PreparedBssrdf {
  std::vector<Profile> profiles; // of each channel
  double ior, exit_ior;          // inside over outside: where light gets in and where it leaves
  bool transmitted;              // it leaves on a slab's other side
};

// Throws INVALID_ARGUMENT, CANCELLED.
PreparedBssrdf prepare_bssrdf(TynContext &context, const TynSlab *slab, const TynBssrdfOptions *options);

} // namespace tyn

struct TynBssrdf {
  TynBssrdf(TynContext &context, tyn::PreparedBssrdf prepared);
  ~TynBssrdf() = default;
  void retain();
  void release();

  uint32_t channels() const { return uint32_t(profiles.size()); }

  TynContext &context; // retained
  const std::vector<tyn::Profile> profiles;
  const bool transmitted;
  tyn::Buffer records; // TynProfileRecord of each channel
  tyn::Buffer terms;   // float: the terms of all channels, and their chances
  float reach = 0;     // the largest of the records'

private:
  std::atomic<uint32_t> references{1};
};
