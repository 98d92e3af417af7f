// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "bssrdf/escape_light.hpp"
#include "bssrdf/single_scattering.hpp"

namespace tyn {

// The terms of TYN_DIRECTIONS_TABLE (kernels/shared_bssrdf.h). `single` with extinction 1; `ior`: inside over outside; `paths`:
// mean free paths in the unit of the radii that the terms are asked with.
std::vector<double> angle_terms(const EscapeGrid &grid, const EscapeLight &light, const SingleScattering &single,
                                double ior, double paths);

} // namespace tyn
