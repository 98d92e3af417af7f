// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "bssrdf/exact_table.hpp"
#include "bssrdf/single_scattering.hpp"

namespace tyn {

// The terms of TYN_DIRECTIONS_TABLE (kernels/shared_bssrdf.h) for an albedo of a table, whose light that is. `single` with
// extinction 1; `ior`: inside over outside; `paths`: mean free paths in the unit of the radii that the terms are asked with.
std::vector<double> angle_terms(const ExactTable &table, double absorption, const EscapeLight &light,
                                const SingleScattering &single, double ior, double paths);

} // namespace tyn
