// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "common/plot.hpp"

#include "common/plot_canvas.hpp"
#include "common/plot_scale.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace tool {
namespace {

// Points; drawn with kPixels pixels each.
constexpr double kPixels = 2.0;
constexpr double kPanelWidth = 470.0, kSingleWidth = 560.0, kPanelHeight = 350.0, kMargin = 16.0;
constexpr double kLabelWidth = 32.0; // at least, so that panels above each other begin alike
constexpr double kTitleSize = 14.0, kTextSize = 12.0;
constexpr double kLine = 17.0; // between baselines
constexpr double kTickLength = 4.0;
constexpr size_t kFewDots = 30;      // up to so many points of a line are marked
constexpr double kMostDecades = 8.0; // of a log axis

constexpr double kSample = 24.0, kGap = 6.0, kApart = 16.0; // of a legend: line, line to text, entry to entry

const Color kInk = {0.13, 0.13, 0.13}, kGrid = {0.88, 0.88, 0.88};

// An error that is not known is not drawn.
double error_at(const Series &series, size_t i) {
  return series.error.empty() || !std::isfinite(series.error[i]) ? 0.0 : series.error[i];
}

struct Span {
  double low = HUGE_VAL, high = -HUGE_VAL;
  void include(double value) {
    if (!std::isfinite(value))
      return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  bool empty() const { return low > high; }
};

Span x_span(const Panel &panel) {
  Span span;
  for (const Series &series : panel.series)
    for (const double x : series.x)
      if (!panel.x.log || x > 0.0)
        span.include(x);
  return span.empty() ? Span{0.0, 1.0} : span;
}

// On a linear axis from 0; on a log axis what is well above its own noise.
Span y_span(const Panel &panel) {
  Span span;
  for (const Series &series : panel.series)
    for (size_t i = 0; i < series.y.size(); ++i) {
      const double y = series.y[i], error = error_at(series, i);
      if (!panel.y.log) {
        span.include(y - error);
        span.include(y + error);
      } else if (y > error && y > 0.0) {
        span.include(y);
      }
    }
  if (span.empty())
    return panel.y.log ? Span{0.1, 1.0} : Span{0.0, 1.0};
  if (!panel.y.log)
    return {std::min(span.low, 0.0), span.high};
  return {std::max(span.low, span.high * std::pow(10.0, -kMostDecades)), span.high};
}

// A panel within the rectangle that it was given.
class PanelPainter {
public:
  PanelPainter(Canvas &canvas, const Panel &panel, double x, double y, double width)
      : canvas_(canvas), panel_(panel), x_(panel.x, x_span(panel).low, x_span(panel).high, false),
        y_(panel.y, y_span(panel).low, y_span(panel).high, true), outer_left_(x), outer_top_(y), outer_width_(width) {}

  // Rows that the legend takes.
  size_t legend_rows() {
    lay_out(0);
    return place_legend(false);
  }

  // `rows` are kept for the legend, so that panels side by side begin alike.
  void paint(size_t rows) {
    lay_out(rows);
    place_legend(true);
    paint_title();
    paint_grid();
    cairo_save(canvas_.get());
    cairo_rectangle(canvas_.get(), left_, top_, right_ - left_, bottom_ - top_);
    cairo_clip(canvas_.get());
    paint_marks();
    for (const Series &series : panel_.series)
      if (series.mark == Mark::kLine)
        for (const Run &run : runs(series))
          paint_band(series, run);
    for (const Series &series : panel_.series)
      paint_series(series);
    cairo_restore(canvas_.get());
    paint_values();
    paint_frame();
    for (const Series &series : panel_.series)
      paint_dots(series);
  }

private:
  double across(double value) const { return left_ + x_.position(value) * (right_ - left_); }
  double up(double value) const { return bottom_ - y_.position(value) * (bottom_ - top_); }

  size_t category_lines() const {
    size_t lines = 1;
    for (const std::string &name : panel_.x.categories)
      lines = std::max<size_t>(lines, 1 + std::count(name.begin(), name.end(), '\n'));
    return lines;
  }

  void lay_out(size_t legend_rows) {
    canvas_.set_font(kTextSize);
    double widest = kLabelWidth;
    for (const Tick &tick : y_.ticks())
      widest = std::max(widest, canvas_.text_width(tick.label));
    left_ = outer_left_ + kMargin + kLine + 4.0 + widest + kTickLength + 4.0;
    right_ = outer_left_ + outer_width_ - kMargin - 6.0;
    bottom_ = outer_top_ + kPanelHeight - kMargin - kLine * (panel_.x.label.empty() ? 0.5 : 1.1) -
              kLine * static_cast<double>(category_lines());
    top_ = outer_top_ + kMargin + kLine + (legend_rows ? kLine * static_cast<double>(legend_rows) + 4.0 : 0.0);
  }

  void paint_title() {
    canvas_.set_color(kInk);
    canvas_.set_font(kTitleSize, true);
    canvas_.text(left_, outer_top_ + kMargin + 8.0, panel_.title);
  }

  // Goes through the legend from left to right and on to new rows; returns how many there are.
  size_t place_legend(bool draw) {
    canvas_.set_font(kTextSize);
    double x = left_, y = outer_top_ + kMargin + kLine + 2.0;
    size_t rows = panel_.legend.empty() ? 0 : 1;
    for (const LegendEntry &entry : panel_.legend) {
      const double width = kSample + kGap + canvas_.text_width(entry.label);
      if (x > left_ && x + width > right_) {
        x = left_;
        y += kLine;
        ++rows;
      }
      if (draw)
        paint_entry(entry, x, y);
      x += width + kApart;
    }
    return rows;
  }

  void paint_entry(const LegendEntry &entry, double x, double y) {
    canvas_.set_color(entry.color);
    set_stroke(entry.dashed, entry.points ? 1.2 : 2.0);
    if (entry.points) {
      canvas_.line(x + 0.5 * kSample, y, x + 0.5 * kSample, y + 12.0);
      cairo_arc(canvas_.get(), x + 0.5 * kSample, y + 6.0, 2.6, 0.0, 6.283185307);
      cairo_fill(canvas_.get());
    } else {
      canvas_.line(x, y + 6.0, x + kSample, y + 6.0);
    }
    canvas_.set_color(kInk);
    canvas_.text(x + kSample + kGap, y + 10.0, entry.label);
  }

  void set_stroke(bool dashed, double width) {
    const double pattern[] = {6.0, 3.5};
    cairo_set_line_width(canvas_.get(), width);
    cairo_set_dash(canvas_.get(), pattern, dashed ? 2 : 0, 0.0);
    cairo_set_line_join(canvas_.get(), CAIRO_LINE_JOIN_ROUND);
  }

  void paint_grid() {
    canvas_.set_color(kGrid);
    set_stroke(false, 0.75);
    for (const Tick &tick : y_.ticks())
      if (!tick.label.empty())
        canvas_.line(left_, up(tick.value), right_, up(tick.value));
    for (const Tick &tick : x_.ticks())
      if (!tick.label.empty() && panel_.x.categories.empty())
        canvas_.line(across(tick.value), top_, across(tick.value), bottom_);
  }

  void paint_marks() {
    canvas_.set_color(kInk, 0.6);
    const double pattern[] = {1.5, 3.0};
    for (const double value : panel_.x.marks) {
      set_stroke(false, 1.0);
      cairo_set_dash(canvas_.get(), pattern, 2, 0.0);
      canvas_.line(across(value), top_, across(value), bottom_);
    }
  }

  void paint_frame() {
    canvas_.set_color(kInk);
    canvas_.set_font(kTextSize);
    set_stroke(false, 1.0);
    cairo_rectangle(canvas_.get(), left_, top_, right_ - left_, bottom_ - top_);
    cairo_stroke(canvas_.get());
    for (const Tick &tick : x_.ticks())
      paint_x_tick(tick);
    for (const Tick &tick : y_.ticks()) {
      const double length = tick.label.empty() ? 0.5 * kTickLength : kTickLength;
      canvas_.line(left_ - length, up(tick.value), left_, up(tick.value));
      canvas_.text(left_ - kTickLength - 4.0, up(tick.value) + 0.36 * kTextSize, tick.label, Align::kRight);
    }
    canvas_.text(0.5 * (left_ + right_), outer_top_ + kPanelHeight - kMargin + 2.0, label(panel_.x, x_),
                 Align::kCentre);
    canvas_.text_upwards(outer_left_ + kMargin + 0.5 * kLine, 0.5 * (top_ + bottom_), label(panel_.y, y_));
  }

  void paint_x_tick(const Tick &tick) {
    const double x = across(tick.value);
    const bool is_category = !panel_.x.categories.empty();
    const double length = tick.label.empty() ? 0.5 * kTickLength : kTickLength;
    if (!is_category)
      canvas_.line(x, bottom_, x, bottom_ + length);
    double y = bottom_ + kTickLength + kTextSize + 1.0;
    size_t begin = 0;
    for (size_t end = 0; end != std::string::npos; begin = end + 1, y += kLine - 2.0) {
      end = tick.label.find('\n', begin);
      canvas_.text(x, y, tick.label.substr(begin, end - begin), Align::kCentre);
    }
  }

  static std::string label(const PlotAxis &axis, const Scale &scale) {
    return scale.factor().empty() ? axis.label : axis.label + "  (\xc3\x97 " + scale.factor() + ")";
  }

  // Neighbouring points that the axes have: a log axis has no 0, and a line there is interrupted.
  struct Run {
    size_t begin, end;
  };
  std::vector<Run> runs(const Series &series) const {
    std::vector<Run> result;
    for (size_t i = 0; i < series.x.size(); ++i) {
      if (!is_shown(series, i))
        continue;
      if (result.empty() || result.back().end != i)
        result.push_back({i, i});
      result.back().end = i + 1;
    }
    return result;
  }

  bool is_shown(const Series &series, size_t i) const {
    return std::isfinite(series.y[i]) && (!panel_.y.log || series.y[i] > 0.0) && (!panel_.x.log || series.x[i] > 0.0);
  }

  void paint_band(const Series &series, const Run &run) {
    if (series.error.empty())
      return;
    canvas_.set_color(series.color, 0.25);
    for (size_t i = run.begin; i < run.end; ++i)
      cairo_line_to(canvas_.get(), across(series.x[i]), limited_up(series.y[i] + error_at(series, i)));
    for (size_t i = run.end; i-- > run.begin;)
      cairo_line_to(canvas_.get(), across(series.x[i]), limited_up(series.y[i] - error_at(series, i)));
    cairo_close_path(canvas_.get());
    cairo_fill(canvas_.get());
  }

  // Far outside, where nothing is seen, coordinates stay within what Cairo's fixed-point numbers hold.
  double limited_up(double value) const { return std::clamp(up(value), top_ - 2000.0, bottom_ + 2000.0); }

  void paint_series(const Series &series) {
    if (series.mark == Mark::kBars) {
      paint_bars(series);
      return;
    }
    canvas_.set_color(series.color);
    set_stroke(series.dashed, series.mark == Mark::kLine ? 1.6 : 1.0);
    for (const Run &run : runs(series)) {
      for (size_t i = run.begin; series.mark != Mark::kPoints && i < run.end; ++i)
        cairo_line_to(canvas_.get(), across(series.x[i]), limited_up(series.y[i]));
      cairo_stroke(canvas_.get());
    }
    set_stroke(false, 1.2);
    if (series.mark != Mark::kLine)
      for (size_t i = 0; i < series.x.size(); ++i)
        if (is_shown(series, i))
          paint_whisker(across(series.x[i]), series, i);
  }

  // Over the frame, where dots at its edge are whole; of a long line only those that no line leads to.
  void paint_dots(const Series &series) {
    if (series.mark == Mark::kBars)
      return;
    canvas_.set_color(series.color);
    const bool all = series.mark != Mark::kLine || series.x.size() <= kFewDots;
    const double radius = series.x.size() > kFewDots ? 1.6 : 2.6;
    for (const Run &run : runs(series))
      for (size_t i = run.begin; (all || run.end - run.begin == 1) && i < run.end; ++i)
        paint_dot(across(series.x[i]), up(series.y[i]), radius);
  }

  void paint_dot(double x, double y, double radius) {
    if (x < left_ - 0.5 || x > right_ + 0.5 || y < top_ - 0.5 || y > bottom_ + 0.5)
      return;
    cairo_arc(canvas_.get(), x, y, radius, 0.0, 6.283185307);
    cairo_fill(canvas_.get());
  }

  void paint_whisker(double x, const Series &series, size_t i) {
    const double error = error_at(series, i);
    if (!(error > 0.0))
      return;
    const double high = limited_up(series.y[i] + error), low = limited_up(series.y[i] - error);
    canvas_.line(x, high, x, low);
    if (low - high > 2.0) { // caps on what is too short to be seen would look like an error
      canvas_.line(x - 3.0, high, x + 3.0, high);
      canvas_.line(x - 3.0, low, x + 3.0, low);
    }
  }

  // Where the bars of a series stand beside those of the others, and how wide they are.
  struct BarPlace {
    double offset, width;
  };
  BarPlace bar_place(const Series &series) const {
    const auto count = static_cast<double>(panel_.series.size());
    const auto index = static_cast<double>(&series - panel_.series.data());
    const double width = 0.7 / count;
    return {(index - 0.5 * (count - 1.0)) * width, width};
  }

  void paint_bars(const Series &series) {
    const BarPlace place = bar_place(series);
    for (size_t i = 0; i < series.x.size(); ++i) {
      const double x0 = across(series.x[i] + place.offset - 0.47 * place.width);
      const double x1 = across(series.x[i] + place.offset + 0.47 * place.width);
      canvas_.set_color(series.color, 0.85);
      cairo_rectangle(canvas_.get(), x0, up(series.y[i]), x1 - x0, bottom_ - up(series.y[i]));
      cairo_fill(canvas_.get());
      canvas_.set_color(kInk);
      set_stroke(false, 1.0);
      paint_whisker(0.5 * (x0 + x1), series, i);
    }
  }

  // The numbers of bars that stand alone.
  void paint_values() {
    if (panel_.series.size() != 1 || panel_.series.front().mark != Mark::kBars)
      return;
    const Series &series = panel_.series.front();
    canvas_.set_color(kInk);
    canvas_.set_font(kTextSize);
    for (size_t i = 0; i < series.x.size(); ++i) {
      char text[32];
      std::snprintf(text, sizeof text, "%.4g", series.y[i]);
      const double above = std::max(up(series.y[i] + error_at(series, i)) - 5.0, top_ + kTextSize + 2.0);
      canvas_.text(across(series.x[i]), above, text, Align::kCentre);
    }
  }

  Canvas &canvas_;
  const Panel &panel_;
  Scale x_, y_;
  double outer_left_, outer_top_, outer_width_;
  double left_ = 0.0, right_ = 0.0, top_ = 0.0, bottom_ = 0.0; // of the axes
};

// Breaks lines at blanks where they would be wider than the figure.
std::vector<std::string> wrapped(const std::vector<std::string> &lines, double width) {
  Canvas canvas(1.0, 1.0, 1.0); // to measure with
  canvas.set_font(kTextSize);
  std::vector<std::string> result;
  for (const std::string &line : lines) {
    std::string fitting;
    for (size_t begin = 0; begin <= line.size();) {
      const size_t end = std::min(line.find(' ', begin), line.size());
      const std::string word = line.substr(begin, end - begin);
      begin = end + 1;
      if (!fitting.empty() && canvas.text_width(fitting + " " + word) > width) {
        result.push_back(fitting);
        fitting = word;
      } else {
        fitting += (fitting.empty() ? "" : " ") + word;
      }
    }
    result.push_back(fitting);
  }
  return result;
}

// Title and notes at the top left.
void paint_header(Canvas &canvas, const std::string &title, const std::vector<std::string> &notes) {
  canvas.set_color(kInk);
  canvas.set_font(kTitleSize + 1.0, true);
  canvas.text(kMargin, kMargin + kLine * 0.8, title);
  canvas.set_font(kTextSize);
  for (size_t i = 0; i < notes.size(); ++i)
    canvas.text(kMargin, kMargin + kLine * (1.9 + static_cast<double>(i)), notes[i]);
}

} // namespace

bool plot_available() { return true; }

std::string draw_png(const Figure &figure) {
  const size_t count = std::max<size_t>(figure.panels.size(), 1);
  const size_t columns = figure.columns ? figure.columns : count == 1 ? 1 : count <= 4 ? 2 : 3;
  const size_t rows = (count + columns - 1) / columns;
  const double each = columns == 1 ? kSingleWidth : kPanelWidth;
  const double width = static_cast<double>(columns) * each;
  const std::vector<std::string> notes = wrapped(figure.notes, width - 2.0 * kMargin);
  const double header = figure.title.empty() ? 0.0 : kMargin + kLine * (1.3 + static_cast<double>(notes.size()));
  Canvas canvas(width, header + static_cast<double>(rows) * kPanelHeight, kPixels);
  paint_header(canvas, figure.title, notes);
  std::vector<PanelPainter> painters;
  for (size_t i = 0; i < figure.panels.size(); ++i)
    painters.emplace_back(canvas, figure.panels[i], static_cast<double>(i % columns) * each,
                          header + static_cast<double>(i / columns) * kPanelHeight, each);
  std::vector<size_t> legend_rows(rows, 0);
  for (size_t i = 0; i < painters.size(); ++i)
    legend_rows[i / columns] = std::max(legend_rows[i / columns], painters[i].legend_rows());
  for (size_t i = 0; i < painters.size(); ++i)
    painters[i].paint(legend_rows[i / columns]);
  return canvas.png();
}

} // namespace tool
