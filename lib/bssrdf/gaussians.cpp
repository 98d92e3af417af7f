// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Sums of Gaussians with the caller's weights and variances, as profiles are fitted for texture-space and screen-space
// subsurface scattering (d'Eon, Luebke, Enderton 2007, "Efficient Rendering of Human Skin").
#include "bssrdf/model.hpp"

namespace tyn {

Profile gaussians(const BssrdfInput &input) {
  const TynBssrdfOptions &options = input.options;
  const size_t first = size_t(input.channel) * options.gaussian_count;
  const double *weights = options.gaussian_weights + first, *variances = options.gaussian_variances + first;
  return profile_of_gaussians(std::vector<double>(weights, weights + options.gaussian_count),
                              std::vector<double>(variances, variances + options.gaussian_count));
}

} // namespace tyn
