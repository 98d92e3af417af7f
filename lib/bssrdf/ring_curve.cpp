// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "bssrdf/ring_curve.hpp"

#include <algorithm>
#include <cmath>

#include "bssrdf/monotone.hpp"
#include "core/pi.hpp"
#include "slab/gauss.hpp"

namespace tyn {
namespace {

constexpr double WELL_KNOWN = 0.01;  // relative error, of all light, from which on a ring is a point of its own ...
constexpr double AT_LEAST = 0.1;     // ... and that of f alone
constexpr double KNOWN = 0.05;       // what the last point is known to ...
constexpr double BARELY = 0.3;       // ... and f alone, there
constexpr double WIDEST = 1.3;       // ratio of the borders of rings that are joined, near the centre twice as much ...
constexpr double WIDEST_INNER = 2.1; // ... where the curve is flat
constexpr size_t INNER = 24;         // rings that count as near the centre
constexpr double ENOUGH = 0.5;       // part of all power that the points hold at least
constexpr int MATCHES = 4;
// Of the mean at the centre: fainter rings, which only the orders that were not counted reach, end where these were cut off
// (albedo^n < 1e-13, at about 1e-26) and, farther out, where doubles do.
constexpr double FAINTEST = 1e-20;

double area(double begin, double end) { return pi * (end - begin) * (end + begin); }

double dipole_log(double rate, double r) { return std::log1p(rate * r) - rate * r - 3 * std::log(r); }

} // namespace

RingCurve::RingCurve(const std::vector<Ring> &rings) {
  join(rings);
  if (points.size() < 4 || !holds_enough(rings)) {
    points.clear();
    return;
  }
  place_points();
  fit_falloff();
  match_means();
}

void RingCurve::join(const std::vector<Ring> &rings) {
  Ring joined{};
  for (size_t i = 0; i < rings.size(); ++i) {
    joined = {joined.end == 0 ? rings[i].begin : joined.begin, rings[i].end, joined.power + rings[i].power,
              std::hypot(joined.error, rings[i].error), joined.beside + rings[i].beside};
    const double relative = joined.power > 0 ? joined.error / joined.power : INFINITY;
    const double of_all = relative * joined.power / (joined.power + joined.beside);
    // the ring around the centre may grow as it has to
    const double widest = joined.begin == 0 ? INFINITY : i < INNER ? WIDEST_INNER : WIDEST;
    const bool wide = joined.end * joined.end > joined.begin * rings[i].begin * widest;
    const bool well_known = of_all <= WELL_KNOWN && relative <= AT_LEAST;
    if (!well_known && !wide)
      continue;
    if (!well_known && (of_all > KNOWN || relative > BARELY))
      return; // the end of what is known
    const double mean = joined.power / area(joined.begin, joined.end);
    if (!points.empty() && mean < FAINTEST * points.front().mean)
      return;
    points.push_back({joined.begin, joined.end, mean, relative, 0, 0});
    joined = {};
  }
}

// Not where counts are so few that only what is known without counting, as a faint rest, seems well known.
bool RingCurve::holds_enough(const std::vector<Ring> &rings) const {
  double all = 0, held = 0;
  for (const Ring &ring : rings)
    all += ring.power;
  for (const Point &point : points)
    held += point.mean * area(point.begin, point.end);
  return held >= ENOUGH * all;
}

void RingCurve::place_points() {
  for (Point &point : points) {
    point.position = std::log(std::sqrt(0.5 * (point.begin * point.begin + point.end * point.end)));
    point.log_value = std::log(point.mean);
  }
  set_slopes();
}

void RingCurve::set_slopes() {
  positions.clear();
  log_values.clear();
  for (const Point &point : points) {
    positions.push_back(point.position);
    log_values.push_back(point.log_value);
  }
  slopes = monotone_slopes(positions, log_values);
}

// So that the curve's mean over each ring is what was counted there.
void RingCurve::match_means() {
  for (int i = 0; i < MATCHES; ++i) {
    for (Point &point : points)
      point.log_value += std::log(point.mean / mean_over(point));
    set_slopes();
  }
}

double RingCurve::mean_over(const Point &point) const {
  static const Quadrature rule = gauss_legendre(8);
  double sum = 0;
  for (size_t i = 0; i < rule.points.size(); ++i) { // uniformly over the area
    const double square =
        point.begin * point.begin + (point.end - point.begin) * (point.end + point.begin) * rule.points[i];
    sum += rule.weights[i] * value(std::sqrt(square));
  }
  return sum;
}

// The rate with which a dipole's light falls as the curve does from half the last radius to it.
void RingCurve::fit_falloff() {
  const Point &last = points.back();
  size_t i = points.size() - 2;
  while (i > 0 && points[i].position > last.position - std::log(2.0))
    --i;
  const double far = std::exp(last.position), near = std::exp(points[i].position);
  const double fall = last.log_value - points[i].log_value;
  double low = 0, high = 1e3 / far;
  for (int step = 0; step < 60; ++step) {
    const double middle = 0.5 * (low + high);
    (dipole_log(middle, far) - dipole_log(middle, near) > fall ? low : high) = middle;
  }
  rate = low;
}

double RingCurve::value(double r) const {
  const double at = std::log(r);
  if (at <= positions.front()) // not steeper than what is scattered once, which diverges like 1 / r
    return std::exp(log_values.front() + std::clamp(slopes.front(), -1.0, 0.0) * (at - positions.front()));
  if (at >= positions.back())
    return std::exp(log_values.back() + dipole_log(rate, r) - dipole_log(rate, std::exp(positions.back())));
  const size_t i = size_t(std::upper_bound(positions.begin(), positions.end(), at) - positions.begin()) - 1;
  return std::exp(hermite(&positions[i], &log_values[i], &slopes[i], at));
}

double RingCurve::relative_error(double r) const {
  for (const Point &point : points)
    if (r < point.end)
      return point.error;
  return points.back().error;
}

} // namespace tyn
