// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Legendre moments of a function that is linear between the entries of a table, interval by interval. The closed form of the
// integral of mu P_l is a difference of nearly equal numbers for the narrow intervals of a diffraction peak; Gauss quadrature of
// pieces that are short against the oscillation of the highest P_l is exact to rounding and cancels nowhere.
#include "media/legendre.hpp"

#include <algorithm>
#include <cmath>

namespace tyn {
namespace {

struct Rule {
  int points;
  const double *nodes, *weights; // on [0, 1]
};

const double nodes4[] = {0.069431844202973712388, 0.330009478207571867599, 0.669990521792428132401,
                         0.930568155797026287612};
const double weights4[] = {0.173927422568726928687, 0.326072577431273071313, 0.326072577431273071313,
                           0.173927422568726928687};
const double nodes8[] = {0.019855071751231884158, 0.101666761293186630204, 0.237233795041835507091,
                         0.408282678752175097530, 0.591717321247824902470, 0.762766204958164492909,
                         0.898333238706813369796, 0.980144928248768115842};
const double weights8[] = {0.050614268145188129576, 0.111190517226687235272, 0.156853322938943643669,
                           0.181341891689180991483, 0.181341891689180991483, 0.156853322938943643669,
                           0.111190517226687235272, 0.050614268145188129576};
const Rule rule4 = {4, nodes4, weights4}, rule8 = {8, nodes8, weights8};

// Phase, in radians, through which the highest P_l may turn in one piece.
constexpr double turn4 = 0.3, turn8 = 3;

// Adds weight P_l(mu) to the moments, mu given by its distance to the nearer pole: mu = 1 - away, or away - 1 if `backward`.
// P_(l+1) - P_l = (l (P_l - P_(l-1)) - (2 l + 1) away P_l) / (l + 1) keeps its accuracy at the pole.
void add_point(std::vector<double> &moments, double away, bool backward, double weight) {
  double p = 1, difference = 0;
  for (size_t l = 0; l < moments.size(); l++) {
    moments[l] += backward && l % 2 ? -weight * p : weight * p;
    difference = (double(l) * difference - (2 * double(l) + 1) * away * p) / (double(l) + 1);
    p += difference;
  }
}

struct Interval {
  double away0, away1; // from the nearer pole
  bool backward;
  double value0, value1;
};

// The piece between shares t0 and t1 of an interval.
void add_piece(std::vector<double> &moments, const Interval &interval, double t0, double t1, const Rule &rule) {
  const double width = std::abs(interval.away1 - interval.away0);
  for (int k = 0; k < rule.points; k++) {
    const double t = t0 + (t1 - t0) * rule.nodes[k];
    const double value = (1 - t) * interval.value0 + t * interval.value1;
    const double away = (1 - t) * interval.away0 + t * interval.away1;
    add_point(moments, away, interval.backward, rule.weights[k] * (t1 - t0) * width * value);
  }
}

double angle_of(double away) { return 2 * std::asin(std::min(1.0, std::sqrt(0.5 * away))); }

double away_of(double angle) { return 2 * std::sin(0.5 * angle) * std::sin(0.5 * angle); }

// In pieces of equal angle.
void add_interval(std::vector<double> &moments, const Interval &interval) {
  if (interval.value0 == 0 && interval.value1 == 0)
    return;
  const double angle0 = angle_of(interval.away0), angle1 = angle_of(interval.away1);
  const double turn = double(moments.size() + 1) * std::abs(angle1 - angle0);
  if (turn <= turn4) {
    add_piece(moments, interval, 0, 1, rule4);
    return;
  }
  const int pieces = int(std::ceil(turn / turn8));
  double t0 = 0;
  for (int i = 1; i <= pieces; i++) {
    const double away = away_of(angle0 + (angle1 - angle0) * i / pieces);
    const double t1 = i == pieces ? 1 : (away - interval.away0) / (interval.away1 - interval.away0);
    add_piece(moments, interval, t0, t1, rule8);
    t0 = t1;
  }
}

} // namespace

std::vector<double> linear_legendre_moments(const double *cosines, const std::vector<double> &values, size_t count) {
  std::vector<double> moments(count, 0.0);
  for (size_t i = 0; i + 1 < values.size(); i++) {
    const double a = cosines[i], b = cosines[i + 1];
    if (b <= 0)
      add_interval(moments, {1 + a, 1 + b, true, values[i], values[i + 1]});
    else if (a >= 0)
      add_interval(moments, {1 - a, 1 - b, false, values[i], values[i + 1]});
    else { // split at 0, where the nearer pole changes
      const double middle = (values[i] * b - values[i + 1] * a) / (b - a);
      add_interval(moments, {1 + a, 1, true, values[i], middle});
      add_interval(moments, {1, 1 - b, false, middle, values[i + 1]});
    }
  }
  return moments;
}

} // namespace tyn
