// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Batches of photons on the device.
#pragma once

#include <vector>

#include "core/context.hpp"
#include "kernels/shared_slab.h"
#include "slab/validate.hpp"

namespace tyn {

class BatchEngine {
public:
  BatchEngine(TynContext &context, const Slab &slab, const TynSlabOptions &options);

  // Compiles the kernels.
  void prepare();
  // Walks photons first .. first + count - 1 of a channel to their ends, in batches of `batch` (at most TYN_SLAB_BATCH); the last
  // one may have fewer. No more than most_batches() at once. Returns the tallies, batch after batch.
  const int64_t *walk(size_t channel, uint64_t first, uint32_t count, uint32_t batch);
  uint32_t most_batches() const { return batches; }

  const TynSlabParameters &parameters() const { return base; }
  // The fraction of collimated light that the first interface reflects; of diffuse light the kernel keeps count.
  double specular() const { return first_reflection; }

private:
  void set_incidence(const Slab &slab, const TynSlabOptions &options);
  void upload_layers(const Slab &slab);
  void upload_sweep(const Slab &slab, const TynSlabOptions &options);
  void allocate_tallies();
  void launch(size_t channel, const TynSlabParameters &parameters, uint32_t used);

  TynContext &context;
  TynSlabParameters base{};
  double first_reflection = 0;
  uint32_t batches = 0;
  Buffer phases, tables, tallies;
  std::vector<Buffer> layers, sweeps; // one a channel
  std::vector<int64_t> host_tallies;
};

} // namespace tyn
