// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
//
// A white sheet for Cairo to draw on: lengths are in points, the origin is at the top left.
#pragma once

#include "common/plot.hpp"

#include <cairo.h>

#include <memory>
#include <string>

namespace tool {

enum class Align { kLeft, kCentre, kRight };

class Canvas {
public:
  // `scale`: pixels a point.
  Canvas(double width, double height, double scale);

  cairo_t *get() const { return cairo_.get(); }

  void set_color(const Color &color, double opacity = 1.0);
  void set_font(double size, bool bold = false);

  // Text of one line at its baseline, with ^{...} above it and _{...} below.
  void text(double x, double y, const std::string &text, Align align = Align::kLeft);
  // The same, read from below.
  void text_upwards(double x, double y, const std::string &text);
  double text_width(const std::string &text);

  void line(double x0, double y0, double x1, double y1);

  std::string png() const;

private:
  double draw_text(const std::string &text, bool only_measure);

  struct Destroyer {
    void operator()(cairo_surface_t *surface) const { cairo_surface_destroy(surface); }
    void operator()(cairo_t *cairo) const { cairo_destroy(cairo); }
  };
  std::unique_ptr<cairo_surface_t, Destroyer> surface_;
  std::unique_ptr<cairo_t, Destroyer> cairo_;
  double font_size_ = 12.0;
};

} // namespace tool
