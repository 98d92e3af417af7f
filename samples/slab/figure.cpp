// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
//
// The plot: one panel for each thing that was resolved, or the totals if nothing was.
#include "common/table.hpp"
#include "slab/bins.hpp"
#include "slab/format.hpp"
#include "slab/outputs.hpp"

#include <algorithm>
#include <iterator>

namespace slab {
namespace {

using tool::Color;
using tool::Mark;
using tool::number;
using tool::Panel;
using tool::Series;

constexpr double kLogFrom = 30.0; // values whose ratio is above this go on a log axis
constexpr size_t kMostNamed = 8;  // channels that a legend names one by one, and that bars are drawn for
constexpr size_t kMostListed = 3; // channels whose totals are written out
const Color kGray = {0.35, 0.35, 0.35};
const Color kRed = {0.84, 0.15, 0.16}, kGreen = {0.17, 0.60, 0.17}, kBlue = {0.12, 0.40, 0.75};

std::vector<double> centres(const std::vector<double> &edges) {
  std::vector<double> result;
  for (size_t i = 0; i + 1 < edges.size(); ++i)
    result.push_back(0.5 * (edges[i] + edges[i + 1]));
  return result;
}

bool all_zero(const std::vector<double> &values) {
  return std::all_of(values.begin(), values.end(), [](double value) { return value == 0.0; });
}

// Ratio of the largest value to the smallest that is above its noise.
double contrast(const std::vector<Series> &series) {
  double smallest = HUGE_VAL, largest = 0.0;
  for (const Series &one : series)
    for (size_t i = 0; i < one.y.size(); ++i)
      if (one.y[i] > 2.0 * one.error[i]) {
        smallest = std::min(smallest, one.y[i]);
        largest = std::max(largest, one.y[i]);
      }
  return largest > 0.0 ? largest / smallest : 1.0;
}

// One of the curves that share a panel: reflectance, transmittance, ...
struct Part {
  const char *name;
  uint32_t quantity;
};

class Plotter {
public:
  Plotter(const Arguments &arguments, const Results &results) : arguments_(arguments), results_(results) {}

  tool::Figure figure() const {
    tool::Figure result;
    result.title = title();
    result.notes = notes();
    add_resolved(result.panels);
    if (result.panels.empty())
      result.panels.push_back(totals());
    return result;
  }

private:
  size_t channels() const { return results_.channels.size(); }
  const std::string &unit() const { return arguments_.unit; }

  Color channel_color(size_t c) const {
    if (channels() == 3)
      return c == 0 ? kRed : c == 1 ? kGreen : kBlue;
    return tool::distinct_color(c, channels());
  }

  std::string channel_name(size_t c) const {
    if (arguments_.is_rgb)
      return c == 0 ? "red" : c == 1 ? "green" : "blue";
    return "channel " + results_.names[c];
  }

  // ---- text ----

  std::string title() const {
    const LayerArgument &layer = arguments_.layers.front();
    if (arguments_.layers.size() > 1)
      return std::to_string(arguments_.layers.size()) + " layers" + channel_count();
    std::string text = arguments_.medium.empty() ? "" : arguments_.medium + ": ";
    if (channels() == 1 && arguments_.sweep.empty())
      text += "\xcf\x83_{a} = " + number(layer.sigma_a[0]) + ", \xcf\x83_{s} = " + number(layer.sigma_s[0]) + ", ";
    else if (channels() == 1)
      text += "\xcf\x83_{t} = " + number(layer.sigma_a[0] + layer.sigma_s[0]) + ", albedo " +
              number(*std::max_element(arguments_.sweep.begin(), arguments_.sweep.end())) + ", ";
    text += arguments_.phase.given ? arguments_.phase.text : "g = " + number(layer.g);
    text += ", n = " + number(layer.ior) + ", ";
    text += std::isinf(layer.thickness) ? "half-space" : number(layer.thickness) + " " + unit() + " thick";
    return text + channel_count();
  }

  std::string channel_count() const {
    return channels() > 1 && !arguments_.is_rgb ? ", " + std::to_string(channels()) + " channels" : "";
  }

  // "R = 0.0974 ± 0.0002", which is not broken into lines.
  static std::string equation(const char *name, const TynEstimate &estimate) {
    return name + std::string("\xc2\xa0=\xc2\xa0") +
           with_error(estimate.value, estimate.standard_error, "\xc2\xa0\xc2\xb1\xc2\xa0");
  }

  std::vector<std::string> notes() const {
    std::vector<std::string> lines;
    for (size_t c = 0; channels() <= kMostListed && c < channels(); ++c) {
      const TynSlabTotals &totals = results_.channels[c].totals;
      std::string line = channels() > 1 ? channel_name(c) + ":  " : "";
      line += equation("R", totals.reflectance) + ",  ";
      if (totals.transmittance.value > 0.0)
        line += equation("T", totals.transmittance) + ",  ";
      lines.push_back(line + equation("A", totals.absorbed));
    }
    lines.push_back(light() + ", " + grouped(results_.run.photons) + " photons" + (channels() > 1 ? " a channel" : "") +
                    "; bands: \xc2\xb1 1 standard error");
    return lines;
  }

  std::string light() const {
    const TynSlabOptions &options = arguments_.options;
    std::string text = "light at normal incidence";
    if (options.incidence == TYN_INCIDENCE_DIFFUSE)
      text = "diffuse light";
    else if (options.angle > 0.0)
      text = "light at " + number(options.angle * 57.29577951308232, 4) + "\xc2\xb0";
    if (options.beam == TYN_BEAM_DISC)
      text += " on a disc of radius " + number(options.beam_radius);
    else if (options.beam == TYN_BEAM_GAUSSIAN)
      text += " in a Gaussian beam of radius " + number(options.beam_radius);
    return text;
  }

  // ---- panels ----

  void add_resolved(std::vector<Panel> &panels) const {
    const TynSlabOptions &options = arguments_.options;
    if (options.radial_bins)
      panels.push_back(radial());
    if (options.angular_bins)
      panels.push_back(angular());
    if (options.depth_bins) {
      panels.push_back(depth("Absorption",
                             "absorbed per depth, " + unit() +
                                 "^{\xe2\x88\x92"
                                 "1}",
                             TYN_SLAB_DEPTH_ABSORBED));
      panels.push_back(depth("Fluence", "fluence / irradiance", TYN_SLAB_DEPTH_FLUENCE));
    }
    if (options.order_bins)
      panels.push_back(orders());
    if (options.path_bins)
      panels.push_back(path());
    if (!arguments_.sweep.empty())
      panels.push_back(sweep());
  }

  Panel radial() const {
    Panel panel = curves(centres(radial_edges(arguments_)), {{"reflectance", TYN_SLAB_RADIAL_REFLECTANCE},
                                                             {"transmittance", TYN_SLAB_RADIAL_TRANSMITTANCE}});
    panel.title = "Over the radius";
    panel.x.label = "radius r, " + unit();
    panel.x.range = {0.0, arguments_.options.radial_max};
    panel.y.label = symbols(panel, "(r), ") + per(unit(), 2);
    panel.y.log = contrast(panel.series) > kLogFrom;
    return panel;
  }

  Panel angular() const {
    Panel panel = curves(centres(angular_edges(arguments_)), {{"reflectance", TYN_SLAB_ANGULAR_REFLECTANCE},
                                                              {"transmittance", TYN_SLAB_ANGULAR_TRANSMITTANCE}});
    panel.title = "Over the angle";
    panel.x.label = "angle from the normal, degrees";
    panel.x.range = {0.0, 90.0};
    panel.x.step = 15.0;
    panel.y.label = symbols(panel, "(\xce\xb8), ") + per("sr", 1);
    return panel;
  }

  Panel depth(const char *title, const std::string &label, uint32_t quantity) const {
    Panel panel = curves(centres(depth_edges(arguments_)), {{"", quantity}});
    panel.title = title;
    panel.x.label = "depth z, " + unit();
    panel.x.range = {0.0, arguments_.options.depth_max};
    panel.y.label = label;
    const std::vector<double> interfaces = layer_edges(arguments_);
    panel.x.marks.assign(interfaces.begin() + 1, interfaces.end() - 1);
    panel.y.log = contrast(panel.series) > kLogFrom;
    return panel;
  }

  Panel orders() const {
    std::vector<double> x;
    for (uint32_t i = 0; i < arguments_.options.order_bins; ++i)
      x.push_back(i);
    Panel panel =
        curves(x, {{"reflectance", TYN_SLAB_ORDER_REFLECTANCE}, {"transmittance", TYN_SLAB_ORDER_TRANSMITTANCE}});
    panel.title =
        panel.series.size() > channels() ? "Over the scattering order" : "Reflectance over the scattering order";
    panel.x.label = "scattering events";
    panel.x.range = {0.0, std::max(1.0, x.back())};
    panel.x.step = x.size() <= 11 ? 1.0 : 0.0;
    panel.y.label = "fraction of the light";
    panel.y.log = contrast(panel.series) > kLogFrom;
    return panel;
  }

  Panel path() const {
    Panel panel = curves(centres(path_edges(arguments_)),
                         {{"reflectance", TYN_SLAB_PATH_REFLECTANCE}, {"transmittance", TYN_SLAB_PATH_TRANSMITTANCE}});
    panel.title = "Over the path length inside";
    panel.x.label = "path length l, " + unit();
    panel.x.range = {0.0, arguments_.options.path_max};
    panel.y.label = symbols(panel, "(l), ") + per(unit(), 1);
    panel.y.log = contrast(panel.series) > kLogFrom;
    return panel;
  }

  Panel sweep() const {
    Panel panel;
    const Part parts[] = {{"reflectance", TYN_SLAB_SWEEP_REFLECTANCE},
                          {"transmittance", TYN_SLAB_SWEEP_TRANSMITTANCE},
                          {"absorbed", TYN_SLAB_SWEEP_ABSORBED}};
    std::vector<size_t> order(arguments_.sweep.size());
    for (size_t i = 0; i < order.size(); ++i)
      order[i] = i;
    std::sort(order.begin(), order.end(),
              [&](size_t a, size_t b) { return arguments_.sweep[a] < arguments_.sweep[b]; });
    for (size_t p = 0; p < 3; ++p) {
      const Curve &curve = results_.channels.front().quantities[parts[p].quantity];
      if (all_zero(curve.values))
        continue;
      Series series;
      for (const size_t i : order) {
        series.x.push_back(arguments_.sweep[i]);
        series.y.push_back(curve.values[i]);
        series.error.push_back(curve.errors[i]);
      }
      series.color = tool::distinct_color(p, 3);
      series.mark = Mark::kDots;
      panel.legend.push_back({parts[p].name, series.color});
      panel.series.push_back(series);
    }
    panel.title = "Over the single-scattering albedo";
    panel.x.label = "single-scattering albedo";
    panel.y.label = "fraction of the light";
    return panel;
  }

  // Curves of every channel over x. Parts are told apart by dashes and, in a single channel, by colour.
  Panel curves(const std::vector<double> &x, const std::vector<Part> &all) const {
    Panel panel;
    std::vector<Part> parts;
    std::copy_if(all.begin(), all.end(), std::back_inserter(parts), [&](const Part &part) { return !is_zero(part); });
    if (parts.empty())
      parts.push_back(all.front());
    for (size_t c = 0; c < channels(); ++c)
      for (size_t p = 0; p < parts.size(); ++p) {
        const Curve &curve = results_.channels[c].quantities[parts[p].quantity];
        Series series;
        series.x = x;
        series.y = curve.values;
        series.error = curve.errors;
        series.color = channels() == 1 ? tool::distinct_color(p, 2) : channel_color(c);
        series.dashed = p > 0;
        panel.series.push_back(series);
      }
    add_legend(parts, panel);
    return panel;
  }

  bool is_zero(const Part &part) const {
    return std::all_of(results_.channels.begin(), results_.channels.end(), [&](const ChannelResults &channel) {
      return all_zero(channel.quantities[part.quantity].values);
    });
  }

  // A part that is alone is named at the axis.
  void add_legend(const std::vector<Part> &parts, Panel &panel) const {
    for (size_t p = 0; parts.size() > 1 && p < parts.size(); ++p)
      panel.legend.push_back({parts[p].name, channels() == 1 ? tool::distinct_color(p, 2) : kGray, p > 0});
    add_channels(panel);
  }

  // "R(r), " or "R(r), T(r), ": what the curves of a panel are called at its axis.
  std::string symbols(const Panel &panel, const std::string &of) const {
    const bool both = panel.series.size() > channels();
    return "R" + of + (both ? "T" + of : "");
  }

  // Every channel, or of many a few that the rest lie between.
  void add_channels(Panel &panel) const {
    if (channels() == 1)
      return;
    const size_t named = std::min(channels(), channels() > kMostNamed ? 5 : kMostNamed);
    for (size_t i = 0; i < named; ++i) {
      const size_t c = i * (channels() - 1) / (named - 1);
      panel.legend.push_back({channel_name(c), channel_color(c)});
    }
  }

  Panel totals() const {
    Panel panel = channels() > kMostNamed ? spectrum() : bars();
    panel.title = "Where the light goes";
    panel.y.label = "fraction of the light";
    return panel;
  }

  Panel bars() const {
    Panel panel;
    panel.x.categories = {"specular R", "diffuse R", "direct T", "diffuse T", "absorbed"};
    for (size_t c = 0; c < channels(); ++c) {
      const TynSlabTotals &totals = results_.channels[c].totals;
      Series series;
      for (const TynEstimate &estimate : {totals.specular_reflectance, totals.diffuse_reflectance,
                                          totals.direct_transmittance, totals.diffuse_transmittance, totals.absorbed}) {
        series.x.push_back(static_cast<double>(series.x.size()));
        series.y.push_back(estimate.value);
        series.error.push_back(estimate.standard_error);
      }
      series.color = channel_color(c);
      series.mark = Mark::kBars;
      panel.series.push_back(series);
    }
    add_channels(panel);
    return panel;
  }

  // Totals of many channels over their numbers.
  Panel spectrum() const {
    const std::pair<const char *, TynEstimate TynSlabTotals::*> parts[] = {
        {"reflectance", &TynSlabTotals::reflectance},
        {"transmittance", &TynSlabTotals::transmittance},
        {"absorbed", &TynSlabTotals::absorbed}};
    Panel panel;
    for (size_t p = 0; p < 3; ++p) {
      Series series;
      for (size_t c = 0; c < channels(); ++c) {
        const TynEstimate &estimate = results_.channels[c].totals.*parts[p].second;
        series.x.push_back(static_cast<double>(c));
        series.y.push_back(estimate.value);
        series.error.push_back(estimate.standard_error);
      }
      series.color = tool::distinct_color(p, 3);
      panel.legend.push_back({parts[p].first, series.color});
      panel.series.push_back(series);
    }
    panel.x.label = "channel";
    return panel;
  }

  const Arguments &arguments_;
  const Results &results_;
};

} // namespace

tool::Figure to_figure(const Arguments &arguments, const Results &results) {
  return Plotter(arguments, results).figure();
}

} // namespace slab
