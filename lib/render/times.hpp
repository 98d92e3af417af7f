// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Where the time of a render goes, by kind of kernel.
#pragma once

#include "core/kernel_times.hpp"

namespace tyn {

// Device seconds; what each holds is said at TynRenderStats.
class RenderTimes {
public:
  // Adds a pass whose kernels are done.
  void add(const KernelTimes &launches);
  // Into the fields of the statistics: zeros if one pass or more was not measured.
  void write(TynRenderStats &stats) const;

private:
  struct Parts {
    double rays, walks, exits, shading;
  };
  static double &part_of(Parts &parts, const char *kernel);

  Parts sums{};
  bool known = true;
};

} // namespace tyn
