// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The directions in which adding-doubling follows light, shared by all layers.
//
// A direction is known by its Snell invariant s = n sin(theta), the same in every layer, so that refraction maps nodes onto
// themselves. Basic radiance l = L / n^2 is unchanged by refraction too; the flux through a layer of index n is
// pi sum c l over the nodes with s < n, with weights c = 2 n^2 mu w that are the same in every layer.
#pragma once

#include <cstddef>
#include <vector>

#include "slab/validate.hpp"

namespace tyn {

// A direction, by its cosine in a medium in which it exists: s itself would lose the digits of small cosines.
struct Direction {
  double n, mu;
};

struct Nodes {
  std::vector<Direction> directions; // first those of the quadrature, then further ones of no weight
  std::vector<double> c;             // weights of flux, of the quadrature's nodes only
  size_t quadrature() const { return c.size(); }
  size_t all() const { return directions.size(); }
};

// About `count` nodes for media of these indices, from above to below. The range of s is cut at each index, where Fresnel's
// formulas and the set of layers that light reaches change abruptly.
Nodes make_nodes(const std::vector<double> &media, unsigned count);

// How many those are: every range between two indices needs some.
unsigned node_count(const std::vector<double> &media, unsigned count);

// The indices above, of the layers, and below unless the last layer is infinite.
std::vector<double> media_of(const Slab &slab);

// Cosine of a direction in a medium of index n; 0 where it does not exist.
double cosine_in(const Direction &direction, double n);
std::vector<double> node_cosines(const Nodes &nodes, double n);

} // namespace tyn
