// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
//
// An axis of a plot: its range, its ticks at round numbers, and where a value lies.
#pragma once

#include "common/plot.hpp"

namespace tool {

struct Tick {
  double value;
  std::string label; // empty: a minor tick
};

class Scale {
public:
  // `fit`: the range grows to round numbers; false: it ends where the data do.
  Scale(const PlotAxis &axis, double lowest, double highest, bool fit);

  // 0 at the low end, 1 at the high end. Values that a log axis does not have lie far below.
  double position(double value) const;

  const std::vector<Tick> &ticks() const { return ticks_; }

  // What labels were divided by: "" or "10^{-4}".
  const std::string &factor() const { return factor_; }

private:
  void set_linear(const PlotAxis &axis, bool fit);
  void set_log(bool fit);
  void add_decade(int decade, bool labels_between, int every);
  void add_categories(const std::vector<std::string> &names);

  bool log_;
  double low_, high_;
  std::vector<Tick> ticks_;
  std::string factor_;
};

} // namespace tool
