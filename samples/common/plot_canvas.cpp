// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "common/plot_canvas.hpp"

#include "common/tool.hpp"

#include <cmath>

namespace tool {
namespace {

constexpr double kSmall = 0.72; // size of ^{...} and _{...}
constexpr double kUp = 0.38;    // how far they are off the line, of the font's size
constexpr double kDown = 0.18;

cairo_status_t append(void *closure, const unsigned char *data, unsigned size) {
  static_cast<std::string *>(closure)->append(reinterpret_cast<const char *>(data), size);
  return CAIRO_STATUS_SUCCESS;
}

} // namespace

Canvas::Canvas(double width, double height, double scale)
    : surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(std::lround(width * scale)),
                                          static_cast<int>(std::lround(height * scale)))),
      cairo_(cairo_create(surface_.get())) {
  cairo_scale(get(), scale, scale);
  cairo_set_source_rgb(get(), 1, 1, 1);
  cairo_paint(get());
}

void Canvas::set_color(const Color &color, double opacity) {
  cairo_set_source_rgba(get(), color.red, color.green, color.blue, opacity);
}

void Canvas::set_font(double size, bool bold) {
  font_size_ = size;
  cairo_select_font_face(get(), "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                         bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(get(), size);
}

// Draws at the current point, or only says how far the text would go.
double Canvas::draw_text(const std::string &text, bool only_measure) {
  double start_x = 0.0, start_y = 0.0, advance = 0.0;
  cairo_get_current_point(get(), &start_x, &start_y);
  const auto piece = [&](const std::string &part, double size, double rise) {
    cairo_set_font_size(get(), size);
    cairo_text_extents_t extents;
    cairo_text_extents(get(), part.c_str(), &extents);
    if (!only_measure) {
      cairo_move_to(get(), start_x + advance, start_y - rise);
      cairo_show_text(get(), part.c_str());
    }
    advance += extents.x_advance;
  };
  size_t at = 0;
  while (at < text.size()) {
    const size_t mark = text.find_first_of("^_", at);
    const size_t end = mark == std::string::npos ? mark : text.find('}', mark);
    if (end == std::string::npos || text[mark + 1] != '{') {
      piece(text.substr(at), font_size_, 0.0);
      break;
    }
    piece(text.substr(at, mark - at), font_size_, 0.0);
    const double rise = text[mark] == '^' ? kUp : -kDown;
    piece(text.substr(mark + 2, end - mark - 2), kSmall * font_size_, rise * font_size_);
    at = end + 1;
  }
  cairo_set_font_size(get(), font_size_);
  return advance;
}

double Canvas::text_width(const std::string &text) { return draw_text(text, true); }

void Canvas::text(double x, double y, const std::string &text, Align align) {
  const double share = align == Align::kLeft ? 0.0 : align == Align::kCentre ? 0.5 : 1.0;
  cairo_move_to(get(), x - share * text_width(text), y);
  draw_text(text, false);
  cairo_new_path(get());
}

void Canvas::text_upwards(double x, double y, const std::string &words) {
  cairo_save(get());
  cairo_translate(get(), x, y);
  cairo_rotate(get(), -1.57079632679);
  text(0.0, 0.0, words, Align::kCentre);
  cairo_restore(get());
}

void Canvas::line(double x0, double y0, double x1, double y1) {
  cairo_move_to(get(), x0, y0);
  cairo_line_to(get(), x1, y1);
  cairo_stroke(get());
}

std::string Canvas::png() const {
  std::string data;
  const cairo_status_t status = cairo_surface_write_to_png_stream(surface_.get(), append, &data);
  if (status != CAIRO_STATUS_SUCCESS)
    throw Error(kFailed, std::string("the plot was not drawn: ") + cairo_status_to_string(status));
  return data;
}

} // namespace tool
