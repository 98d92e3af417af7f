// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
//
// What the bins of a resolved quantity stand for.
#pragma once

#include "slab/arguments.hpp"

namespace slab {

// Edges of equal steps from 0 to `end`: one more than there are bins.
std::vector<double> equal_edges(double end, uint32_t bins);

std::vector<double> radial_edges(const Arguments &arguments);  // length
std::vector<double> angular_edges(const Arguments &arguments); // degrees
std::vector<double> depth_edges(const Arguments &arguments);   // length
std::vector<double> path_edges(const Arguments &arguments);    // length
std::vector<double> layer_edges(const Arguments &arguments);   // depths of the interfaces; the last may be infinite

// Rows of a quantity as intervals; a sweep's albedos and scattering orders are intervals without width.
struct Rows {
  std::vector<double> lower, upper;
};
Rows rows_of(uint32_t quantity, const Arguments &arguments);

bool is_radial_angular(uint32_t quantity);

// Unit of a quantity's values, such as "1/mm^2"; "1" if it has none.
std::string unit_of(uint32_t quantity, const Arguments &arguments);

} // namespace slab
