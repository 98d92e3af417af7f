// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "render/times.hpp"

#include <string_view>

namespace tyn {

double &RenderTimes::part_of(Parts &parts, const char *kernel) {
  const std::string_view name = kernel;
  if (name == "camera_rays" || name == "trace_paths" || name == "trace_shadows")
    return parts.rays;
  if (name == "walk_paths" || name == "bssrdf_walks" || name == "ledger_sum")
    return parts.walks;
  if (name == "shade_exits")
    return parts.exits;
  return parts.shading; // shade, film_add
}

void RenderTimes::add(const KernelTimes &launches) {
  known = launches.each([this](const char *kernel, double seconds) { part_of(sums, kernel) += seconds; }) && known;
}

void RenderTimes::write(TynRenderStats &stats) const {
  const Parts parts = known ? sums : Parts{};
  stats.seconds_rays = parts.rays;
  stats.seconds_walks = parts.walks;
  stats.seconds_exits = parts.exits;
  stats.seconds_shading = parts.shading;
}

} // namespace tyn
