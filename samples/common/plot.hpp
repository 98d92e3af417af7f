// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
//
// Plots of curves with their uncertainty, as PNG. Text may hold x^{up} and x_{down}.
#pragma once

#include <string>
#include <vector>

namespace tool {

struct Color {
  double red, green, blue;
};

// The `index`-th of `count` colours that are told apart, by colour-blind people too up to eight.
Color distinct_color(size_t index, size_t count);

enum class Mark {
  kLine,   // a line, its uncertainty as a shaded band, and dots if they are few
  kDots,   // dots with whiskers on a thin line
  kPoints, // the same without the line
  kBars    // a bar at each x, side by side with the other series' bars
};

struct Series {
  std::vector<double> x, y;
  std::vector<double> error; // half the band's height; empty: none
  Color color = {0, 0, 0};
  Mark mark = Mark::kLine;
  bool dashed = false;
};

struct PlotAxis {
  std::string label;
  bool log = false;
  std::vector<double> range;           // two ends; empty: from the data
  double step = 0.0;                   // between ticks of a linear axis; 0: a round one
  std::vector<double> marks;           // values at which a dotted line crosses the panel (x only)
  std::vector<std::string> categories; // names of x = 0, 1, ... instead of numbers; a newline breaks them
};

struct LegendEntry {
  std::string label;
  Color color;
  bool dashed = false;
  bool points = false; // of a series of points: one of them instead of a line
};

struct Panel {
  std::string title;
  PlotAxis x, y;
  std::vector<Series> series;
  std::vector<LegendEntry> legend; // above the axes, in as many rows as it takes
};

struct Figure {
  std::string title;
  std::vector<std::string> notes; // lines below the title
  std::vector<Panel> panels;      // row by row
  size_t columns = 0;             // 0: as many as look well
};

// Whether the tools were built with Cairo, which draws.
bool plot_available();

// The figure as the contents of a PNG file. Throws an Error if there is no Cairo.
std::string draw_png(const Figure &figure);

} // namespace tool
