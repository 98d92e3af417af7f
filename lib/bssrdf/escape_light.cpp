// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "bssrdf/escape_light.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tyn {
namespace {

constexpr uint32_t FARTHER = 40; // rings beyond those of the walks: five octaves

double first_order(uint32_t number) { return std::ceil(escape_border(TYN_ESCAPE_FIRST_ORDER + number)); }

// The mean of albedo^n over from <= n < to, weighted like n^(-3/2), as orders are distributed when light is diffuse: uniformly
// in n^(-1/2).
double mean_weight(double log_albedo, double from, double to) {
  constexpr int points = 16;
  double sum = 0;
  if (to - from <= points) {
    double all = 0;
    for (double n = from; n < to; ++n) {
      sum += std::exp(n * log_albedo) * std::pow(n, -1.5);
      all += std::pow(n, -1.5);
    }
    return sum / all;
  }
  const double high = 1 / std::sqrt(from), low = 1 / std::sqrt(to);
  for (int i = 0; i < points; ++i) {
    const double root = low + (high - low) * (i + 0.5) / points;
    sum += std::exp(log_albedo / (root * root));
  }
  return sum / points;
}

// Orders beyond the last that was counted. There light is diffuse: the share of walks that are still inside falls like
// (n + shift)^(-1/2), and they have spread sideways as a Gaussian whose variance, of x and of y, grows by 2 / (3 (1 - g)) with
// each event (free flights have the mean square 2, directions persist for 1 / (1 - g) of them).
class Tail {
public:
  Tail(const Escapes &escapes_, double mean_cosine)
      : escapes(escapes_), spread(2 / (3 * (1 - mean_cosine))), last(escape_border(number_after())),
        inside(double(escapes.left) / double(escapes.walks.back())), shift(fitted_shift()) {}

  void add_to(EscapeLight &light, double log_albedo) const {
    const std::vector<double> shares = angle_shares();
    const double variance = inside > 0 ? 1 / double(escapes.left) : 0;
    for (double from = last; inside > 0 && from < LARGEST && from * log_albedo > -FAINT; from *= STEP) {
      const double to = from * STEP;
      const double weight = mean_weight(log_albedo, from, to);
      add_ring_by_ring(light, shares, weight * (remaining(from) - remaining(to)), spread * std::sqrt(from * to));
    }
    // the angles of a ring go together: their variances add up to that of the ring's power
    for (uint32_t radius = 0; radius < light.radii; ++radius) {
      const auto first = light.power.begin() + radius * TYN_ESCAPE_ANGLES;
      const double ring = std::accumulate(first, first + TYN_ESCAPE_ANGLES, 0.0);
      for (uint32_t angle = 0; angle < TYN_ESCAPE_ANGLES; ++angle)
        light.variance[radius * TYN_ESCAPE_ANGLES + angle] += first[angle] * ring * variance;
    }
  }

private:
  static constexpr double STEP = 1.0905; // 2^(1/8)
  static constexpr double LARGEST = 1e14;
  static constexpr double FAINT = 30; // albedo^n < 1e-13

  uint32_t number_after() const { return TYN_ESCAPE_FIRST_ORDER + escapes.grid.orders; }

  // From what left over the last factor of two.
  double fitted_shift() const {
    double before = inside;
    for (uint32_t order = escapes.grid.orders - 8; order < escapes.grid.orders; ++order)
      for (uint32_t i = 0; i < escapes.grid.radii * TYN_ESCAPE_ANGLES; ++i)
        before += double(escapes.count(order, 0, i)) / double(escapes.walks[order]);
    const double ratio = std::min(inside * inside / (before * before), 0.999);
    return std::clamp((last / 2 - ratio * last) / (ratio - 1), -last / 4, last);
  }

  // The share of walks that are inside after n events.
  double remaining(double n) const { return inside * std::sqrt((last + shift) / (n + shift)); }

  // Of the last orders counted.
  std::vector<double> angle_shares() const {
    std::vector<double> shares(TYN_ESCAPE_ANGLES);
    for (uint32_t order = escapes.grid.orders - 8; order < escapes.grid.orders; ++order)
      for (uint32_t radius = 0; radius < escapes.grid.radii; ++radius)
        for (uint32_t angle = 0; angle < TYN_ESCAPE_ANGLES; ++angle)
          shares[angle] += double(escapes.count(order, radius, angle));
    const double all = std::accumulate(shares.begin(), shares.end(), 0.0);
    for (double &share : shares)
      share = all > 0 ? share / all : 1.0 / TYN_ESCAPE_ANGLES;
    return shares;
  }

  void add_ring_by_ring(EscapeLight &light, const std::vector<double> &shares, double power, double variance) const {
    double outside_before = 1;
    for (uint32_t radius = 0; radius < light.radii; ++radius) {
      const double border = ring_end(escapes.grid, radius);
      const bool is_last = radius + 1 == light.radii;
      const double outside = is_last ? 0 : std::exp(-border * border / (2 * variance));
      for (uint32_t angle = 0; angle < TYN_ESCAPE_ANGLES; ++angle)
        light.power[radius * TYN_ESCAPE_ANGLES + angle] += power * (outside_before - outside) * shares[angle];
      outside_before = outside;
    }
  }

  const Escapes &escapes;
  const double spread, last, inside, shift;
};

// A walk comes back once, in one cell: the counts are as good as independent.
void add_counted(EscapeLight &light, const Escapes &escapes, double log_albedo) {
  const size_t cells = size_t(escapes.grid.radii) * TYN_ESCAPE_ANGLES;
  for (uint32_t order = 1; order < escapes.grid.orders; ++order) { // number 0, single scattering, is known exactly
    const double from = first_order(order), to = first_order(order + 1);
    if (!(from < to))
      continue; // between two integers
    const double weight = mean_weight(log_albedo, from, to) / double(escapes.walks[order]);
    for (size_t i = 0; i < cells; ++i) {
      const auto count = double(escapes.counts[order * cells + i]);
      light.power[i] += weight * count;
      light.variance[i] += weight * weight * count;
    }
  }
}

} // namespace

double ring_begin(const EscapeGrid &grid, uint32_t radius) {
  return radius == 0 ? 0 : escape_border(grid.first_radius + radius);
}

double ring_end(const EscapeGrid &grid, uint32_t radius) { return escape_border(grid.first_radius + radius + 1); }

double EscapeLight::sum() const { return std::accumulate(power.begin(), power.end(), 0.0); }

EscapeLight light_of(const Escapes &escapes, double mean_cosine, double absorption) {
  const uint32_t radii = escapes.grid.radii + FARTHER;
  const size_t cells = size_t(radii) * TYN_ESCAPE_ANGLES;
  EscapeLight tail{radii, std::vector<double>(cells), std::vector<double>(cells)}, light = tail;
  if (!(absorption < 1))
    return light;
  const double log_albedo = std::log1p(-absorption);
  Tail(escapes, mean_cosine).add_to(tail, log_albedo);
  add_counted(light, escapes, log_albedo);
  for (size_t i = 0; i < cells; ++i) {
    light.power[i] += tail.power[i];
    light.variance[i] += tail.variance[i];
  }
  return light;
}

} // namespace tyn
