// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
//
// The plot: R(r) of every model, a panel a channel, and below it the deviation from exact transport.
#include "common/table.hpp"
#include "profile/outputs.hpp"
#include "slab/format.hpp"

#include <algorithm>
#include <cmath>

namespace profile {
namespace {

using tool::Color;
using tool::Mark;
using tool::number;
using tool::Panel;
using tool::Series;

constexpr size_t kMostPanels = 3; // side by side; of more channels a few are drawn that the rest lie between
const Color kExact = {0.13, 0.13, 0.13};

class Plotter {
public:
  Plotter(const Arguments &arguments, const Results &results) : arguments_(arguments), results_(results) {}

  tool::Figure figure() const {
    tool::Figure result;
    const size_t all = arguments_.channels();
    const size_t count = std::min(all, kMostPanels);
    std::vector<size_t> channels;
    for (size_t i = 0; i < count; ++i)
      channels.push_back(count > 1 ? i * (all - 1) / (count - 1) : 0);
    result.title = title();
    result.notes = notes(channels);
    result.columns = count;
    for (const size_t c : channels)
      result.panels.push_back(profiles(c));
    for (const size_t c : channels)
      if (arguments_.compare)
        result.panels.push_back(deviations(c));
    result.panels.front().legend = legend();
    return result;
  }

private:
  // ---- text ----

  std::string title() const {
    const std::string transmitted = arguments_.transmitted ? ", transmitted" : "";
    if (arguments_.layers.size() > 1)
      return std::to_string(arguments_.layers.size()) + " layers" + transmitted;
    const slab::LayerArgument &layer = arguments_.top();
    std::string text = arguments_.medium.empty() ? "" : arguments_.medium + ": ";
    if (arguments_.channels() == 1)
      text += "\xcf\x83_{a} = " + number(layer.sigma_a[0]) + ", \xcf\x83_{s} = " + number(layer.sigma_s[0]) + ", ";
    text += "g = " + number(layer.g) + ", n = " + number(layer.ior) + ", ";
    text += std::isinf(layer.thickness) ? "half-space" : number(layer.thickness) + " " + arguments_.unit + " thick";
    return text + transmitted;
  }

  std::string channel_name(size_t c) const {
    if (arguments_.is_rgb)
      return c == 0 ? "red" : c == 1 ? "green" : "blue";
    return "channel " + results_.channel_names[c];
  }

  // Blanks at which no line is broken.
  static std::string kept_together(std::string text) {
    for (size_t at = 0; (at = text.find(' ', at)) != std::string::npos;)
      text.replace(at, 1, "\xc2\xa0");
    return text;
  }

  std::vector<std::string> notes(const std::vector<size_t> &channels) const {
    std::vector<std::string> lines;
    for (const size_t c : channels) {
      std::string line = arguments_.channels() > 1 ? channel_name(c) + ", albedo:" : "albedo:";
      for (const ModelResults &model : results_.models)
        line += (line.back() == ':' ? " " : ", ") + kept_together(model.name + " " + number(model.albedo[c], 3));
      if (arguments_.compare) {
        const TynEstimate &exact = results_.exact.albedo[c];
        line += ", " + kept_together("exact " + slab::with_error(exact.value, exact.standard_error, " \xc2\xb1 "));
      }
      lines.push_back(line);
    }
    if (arguments_.compare)
      lines.push_back("exact transport: " + slab::grouped(results_.exact.run.photons) + " photons" +
                      (arguments_.channels() > 1 ? " a channel" : "") + ", \xc2\xb1 1 standard error");
    if (channels.size() < arguments_.channels())
      lines.push_back(std::to_string(channels.size()) + " of " + std::to_string(arguments_.channels()) + " channels");
    return lines;
  }

  // ---- panels ----

  Color color(size_t model) const { return tool::distinct_color(model, results_.models.size()); }

  std::vector<tool::LegendEntry> legend() const {
    std::vector<tool::LegendEntry> entries;
    for (size_t m = 0; m < results_.models.size(); ++m)
      entries.push_back({results_.models[m].name, color(m), hides_another(m)});
    if (arguments_.compare)
      entries.push_back({"exact", kExact, false, true});
    return entries;
  }

  Panel panel_over_radii() const {
    Panel panel;
    panel.x.label = "radius r, " + arguments_.unit;
    panel.x.log = true;
    panel.x.range = {arguments_.radii.front(), arguments_.radii.back()};
    return panel;
  }

  Panel profiles(size_t c) const {
    Panel panel = panel_over_radii();
    panel.title = arguments_.channels() > 1 ? channel_name(c) : "";
    panel.y.label = (arguments_.transmitted ? "T(r), " : "R(r), ") + slab::per(arguments_.unit, 2);
    panel.y.log = true;
    for (size_t m = 0; m < results_.models.size(); ++m)
      panel.series.push_back(line(arguments_.radii, results_.models[m].profile[c], m));
    if (!arguments_.compare)
      return panel;
    Series exact;
    exact.x = middles();
    exact.y = results_.exact.profile[c].values;
    exact.error = results_.exact.profile[c].errors;
    exact.color = kExact;
    exact.mark = Mark::kPoints;
    panel.series.push_back(exact);
    return panel;
  }

  Panel deviations(size_t c) const {
    Panel panel = panel_over_radii();
    panel.y.label = "deviation from exact, %";
    for (size_t m = 0; m < results_.models.size(); ++m) {
      const Curve &curve = results_.models[m].deviation[c];
      Series series = line(middles(), curve.values, m);
      series.error = curve.errors;
      for (std::vector<double> *values : {&series.y, &series.error})
        for (double &value : *values)
          value *= 100.0;
      panel.series.push_back(series);
    }
    const double limit = limit_of(panel.series);
    panel.y.range = {-limit, limit};
    panel.y.step = 0.5 * limit;
    return panel;
  }

  Series line(const std::vector<double> &x, const std::vector<double> &y, size_t model) const {
    Series series;
    series.x = x;
    series.y = y;
    series.color = color(model);
    series.dashed = hides_another(model);
    return series;
  }

  // Whether it would hide another, as the multipole of a half-space does, which is the standard dipole.
  bool hides_another(size_t model) const {
    const auto &all = results_.models;
    return std::any_of(all.begin(), all.begin() + static_cast<ptrdiff_t>(model),
                       [&](const ModelResults &other) { return other.profile == all[model].profile; });
  }

  // The radii that the rings' means are about at: a ring's borders are those of bins.
  std::vector<double> middles() const {
    const std::vector<double> &edges = results_.exact.edges;
    std::vector<double> result;
    for (size_t i = 0; i + 1 < edges.size(); ++i)
      result.push_back(edges[i] > 0.0 ? std::sqrt(edges[i] * edges[i + 1]) : 0.5 * edges[i + 1]);
    return result;
  }

  // A round number of percent that three quarters of all points are within.
  static double limit_of(const std::vector<Series> &all) {
    std::vector<double> sizes;
    for (const Series &series : all)
      for (const double y : series.y)
        if (std::isfinite(y))
          sizes.push_back(std::fabs(y));
    std::sort(sizes.begin(), sizes.end());
    const double most = sizes.empty() ? 100.0 : sizes[sizes.size() * 3 / 4];
    for (const double limit : {10.0, 20.0, 50.0})
      if (most <= limit)
        return limit;
    return 100.0;
  }

  const Arguments &arguments_;
  const Results &results_;
};

} // namespace

tool::Figure to_figure(const Arguments &arguments, const Results &results) {
  return Plotter(arguments, results).figure();
}

} // namespace profile
