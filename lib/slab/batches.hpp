// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Batches of photons on the device.
#pragma once

#include <vector>

#include "core/context.hpp"
#include "kernels/shared_slab.h"
#include "slab/validate.hpp"

namespace tyn {

// The tallies of escapes (TYN_ESCAPE_* in kernels/shared_slab.h).
struct EscapeGrid {
  uint32_t orders;       // numbers of orders, from order 1 on
  uint32_t first_radius; // number of the first radius
  uint32_t radii;

  size_t cells() const { return size_t(orders) * radii * TYN_ESCAPE_ANGLES; }
};

class BatchEngine {
public:
  // `escapes`: not nullptr if they are to be counted, in place of bins.
  BatchEngine(TynContext &context, const Slab &slab, const TynSlabOptions &options,
              const EscapeGrid *escapes = nullptr);

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
  void add_escapes(const EscapeGrid &escapes);
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
