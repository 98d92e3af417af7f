// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// A round of photons on the device.
#pragma once

#include <vector>

#include "core/context.hpp"
#include "kernels/shared_slab.h"
#include "slab/validate.hpp"

namespace tyn {

class RoundEngine {
public:
  RoundEngine(TynContext &context, const Slab &slab, const TynSlabOptions &options);

  // Compiles the kernels.
  void prepare();
  // Walks photons first .. first + count - 1 of a channel to their ends and returns the tallies. count <= TYN_SLAB_ROUND.
  const std::vector<int64_t> &walk(size_t channel, uint64_t first, uint32_t count);

  const TynSlabParameters &parameters() const { return base; }
  // The fraction of collimated light that the first interface reflects; of diffuse light the kernel keeps count.
  double specular() const { return first_reflection; }

private:
  void set_incidence(const Slab &slab, const TynSlabOptions &options);
  void upload_layers(const Slab &slab);
  void upload_sweep(const Slab &slab, const TynSlabOptions &options);
  void launch(size_t channel, const TynSlabParameters &parameters, size_t items);
  uint32_t work_items(uint32_t count) const;

  TynContext &context;
  TynSlabParameters base{};
  double first_reflection = 0;
  Buffer phases, tables, tallies, sums;
  std::vector<Buffer> layers, sweeps; // one a channel
  std::vector<int64_t> host_sums;
};

} // namespace tyn
