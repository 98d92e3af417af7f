// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "slab/nodes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "slab/gauss.hpp"

namespace tyn {
namespace {

constexpr unsigned least_nodes = 2; // in an interval, however short

// Invariants between two neighbouring indices, by the cosine t in the medium of the upper one: s = n sqrt(1 - t^2).
struct Interval {
  double n;     // the upper index
  double t_max; // cosine at the lower index
  bool crossed; // light crosses an interface at grazing angles
  double extent() const { return n * t_max; }
};

bool has_equal_neighbours(const std::vector<double> &media, double n) {
  const auto pair = [n](double a, double b) { return a == n && b == n; };
  return std::adjacent_find(media.begin(), media.end(), pair) != media.end();
}

std::vector<Interval> cut(const std::vector<double> &media) {
  std::vector<double> indices = media;
  std::sort(indices.begin(), indices.end());
  std::vector<Interval> intervals;
  double lower = 0;
  for (double n : indices)
    if (n > lower) {
      intervals.push_back({n, cosine_in({lower, 0}, n), has_equal_neighbours(media, n)});
      lower = n;
    }
  return intervals;
}

// Gauss-Legendre in x with t = t_max x. Where nothing is reflected at grazing angles radiance behaves like t ln t; there
// t = t_max x^2, which with its Jacobian leaves x^3 ln x.
void add_interval(Nodes &nodes, const Interval &interval, unsigned count) {
  const Quadrature rule = gauss_legendre(count);
  for (unsigned i = 0; i < count; i++) {
    const double x = rule.points[i];
    const double t = interval.t_max * (interval.crossed ? x * x : x);
    const double slope = interval.t_max * (interval.crossed ? 2 * x : 1);
    nodes.directions.push_back({interval.n, t});
    nodes.c.push_back(2 * interval.n * interval.n * t * slope * rule.weights[i]);
  }
}

// How many of `count` nodes each interval gets.
std::vector<unsigned> shares(const std::vector<Interval> &intervals, unsigned count) {
  double extent = 0;
  for (const Interval &interval : intervals)
    extent += interval.extent();
  std::vector<unsigned> counts;
  for (const Interval &interval : intervals)
    counts.push_back(std::max(least_nodes, static_cast<unsigned>(std::lround(count * interval.extent() / extent))));
  return counts;
}

} // namespace

unsigned node_count(const std::vector<double> &media, unsigned count) {
  const std::vector<unsigned> counts = shares(cut(media), count);
  return std::accumulate(counts.begin(), counts.end(), 0u);
}

Nodes make_nodes(const std::vector<double> &media, unsigned count) {
  const std::vector<Interval> intervals = cut(media);
  const std::vector<unsigned> counts = shares(intervals, count);
  Nodes nodes;
  for (size_t i = 0; i < intervals.size(); i++)
    add_interval(nodes, intervals[i], counts[i]);
  return nodes;
}

std::vector<double> media_of(const Slab &slab) {
  std::vector<double> media{slab.ior_above};
  for (const SlabLayer &layer : slab.layers)
    media.push_back(layer.ior);
  if (std::isfinite(slab.layers.back().thickness))
    media.push_back(slab.ior_below);
  return media;
}

// 1 - mu^2 = (s / n)^2
double cosine_in(const Direction &direction, double n) {
  const double own = direction.n * direction.mu;
  return std::sqrt(std::max(0.0, (n - direction.n) * (n + direction.n) + own * own)) / n;
}

std::vector<double> node_cosines(const Nodes &nodes, double n) {
  std::vector<double> cosines;
  for (const Direction &direction : nodes.directions)
    cosines.push_back(cosine_in(direction, n));
  return cosines;
}

} // namespace tyn
