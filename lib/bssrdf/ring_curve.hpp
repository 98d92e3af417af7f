// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// A smooth curve through estimates of what falls into rings.
#pragma once

#include <vector>

namespace tyn {

struct Ring {
  double begin, end;   // radii
  double power, error; // int 2 pi r f(r) dr over the ring, and its standard error
  double beside;       // power of what f will be added to, which says how well it has to be known
};

// f(r) > 0 with the powers of the rings: monotone between its points (one a ring), a power of r nearer than the first; beyond
// the last ring that is known well it goes on as a dipole's light does, like (1 + k r) exp(-k r) / r^3, k from what is there.
class RingCurve {
public:
  // Rings from the centre outwards without gaps. Those that hold too little to be known well are joined with their neighbours.
  explicit RingCurve(const std::vector<Ring> &rings);

  bool empty() const { return points.empty(); } // nothing was known well
  double value(double r) const;
  double relative_error(double r) const;
  double falloff() const { return rate; } // k

private:
  struct Point {
    double begin, end;
    double mean, error; // of f over the ring; relative
    double position;    // log of the radius
    double log_value;
  };

  void join(const std::vector<Ring> &rings);
  bool holds_enough(const std::vector<Ring> &rings) const;
  void place_points();
  void match_means();
  void fit_falloff();
  void set_slopes();
  double mean_over(const Point &point) const;

  std::vector<Point> points;
  std::vector<double> positions, log_values, slopes;
  double rate = 0;
};

} // namespace tyn
