// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "common/table.hpp"
#include "slab/format.hpp"
#include "slab/outputs.hpp"

#include <algorithm>
#include <cstdio>

namespace slab {
namespace {

using tool::number;
using tool::Table;

constexpr size_t kMostColumns = 4;    // channels side by side; more go one below the other
constexpr size_t kMostSweepRows = 32; // more are for files

std::string with_error(const TynEstimate &estimate) {
  return slab::with_error(estimate.value, estimate.standard_error);
}

std::string with_error(const Curve &curve, size_t i) { return slab::with_error(curve.values[i], curve.errors[i]); }

struct Line {
  const char *name;
  TynEstimate TynSlabTotals::*member;
};

const Line kLines[] = {{"specular reflectance", &TynSlabTotals::specular_reflectance},
                       {"diffuse reflectance", &TynSlabTotals::diffuse_reflectance},
                       {"reflectance", &TynSlabTotals::reflectance},
                       {"direct transmittance", &TynSlabTotals::direct_transmittance},
                       {"diffuse transmittance", &TynSlabTotals::diffuse_transmittance},
                       {"transmittance", &TynSlabTotals::transmittance},
                       {"absorbed", &TynSlabTotals::absorbed},
                       {"cut", &TynSlabTotals::cut}};

class Report {
public:
  Report(const Arguments &arguments, const Results &results) : arguments_(arguments), results_(results) {}

  void print() const {
    if (results_.interrupted)
      std::printf("interrupted; what was done:\n");
    if (results_.channels.size() <= kMostColumns)
      print_side_by_side();
    else
      print_one_below_the_other();
    if (arguments_.exact)
      print_exact();
    if (!arguments_.sweep.empty())
      print_sweep();
    print_run();
    print_files();
  }

private:
  size_t layers() const { return arguments_.layers.size(); }

  static std::string layer_name(size_t i) { return "absorbed in layer " + std::to_string(i + 1); }

  bool any_cut() const {
    return std::any_of(results_.channels.begin(), results_.channels.end(),
                       [](const ChannelResults &channel) { return channel.totals.cut.value != 0.0; });
  }

  std::string channel_name(size_t c) const { return (arguments_.is_rgb ? "" : "channel ") + results_.names[c]; }

  void print_side_by_side() const {
    Table table;
    std::vector<std::string> heading = {"fraction of the light"};
    for (size_t c = 0; c < results_.channels.size(); ++c)
      heading.push_back(results_.channels.size() > 1 ? channel_name(c) : "");
    table.add(heading);
    for (const Line &line : kLines) {
      if (line.member == &TynSlabTotals::cut && !any_cut())
        continue;
      std::vector<std::string> row = {line.name};
      for (const ChannelResults &channel : results_.channels)
        row.push_back(with_error(channel.totals.*line.member));
      table.add(row);
    }
    for (size_t i = 0; layers() > 1 && i < layers(); ++i) {
      std::vector<std::string> row = {layer_name(i)};
      for (const ChannelResults &channel : results_.channels)
        row.push_back(with_error(channel.quantities[TYN_SLAB_LAYER_ABSORBED], i));
      table.add(row);
    }
    table.print(0);
  }

  void print_one_below_the_other() const {
    Table table;
    table.add({"channel", "reflectance", "transmittance", "absorbed"});
    for (size_t c = 0; c < results_.channels.size(); ++c) {
      const TynSlabTotals &totals = results_.channels[c].totals;
      table.add({results_.names[c], with_error(totals.reflectance), with_error(totals.transmittance),
                 with_error(totals.absorbed)});
    }
    table.print(0);
  }

  void print_exact() const {
    Table table;
    table.add({"adding-doubling", "reflectance", "", "transmittance", "", "accuracy"});
    for (size_t c = 0; c < results_.channels.size(); ++c) {
      const ChannelResults &channel = results_.channels[c];
      const TynAddingDoublingResult &exact = channel.exact;
      table.add({results_.channels.size() > 1 ? channel_name(c) : "", number(exact.reflectance, 7),
                 sigmas(channel.totals.reflectance, exact.reflectance, exact.accuracy), number(exact.transmittance, 7),
                 sigmas(channel.totals.transmittance, exact.transmittance, exact.accuracy), number(exact.accuracy, 2)});
    }
    std::printf("\n");
    table.print(0);
    std::printf("in parentheses: how many standard errors the estimate is above it\n");
  }

  static std::string sigmas(const TynEstimate &estimate, double exact, double accuracy) {
    const double sigma = deviation(estimate, exact, accuracy);
    if (std::isnan(sigma))
      return "(error unknown)";
    char text[48];
    std::snprintf(text, sizeof text, "(%+.2f)", sigma);
    return text;
  }

  void print_sweep() const {
    const ChannelResults &channel = results_.channels.front();
    Table table;
    table.add({"albedo", "reflectance", "transmittance", "absorbed"});
    const size_t count = std::min(arguments_.sweep.size(), kMostSweepRows);
    for (size_t i = 0; i < count; ++i)
      table.add({number(arguments_.sweep[i], 6), with_error(channel.quantities[TYN_SLAB_SWEEP_REFLECTANCE], i),
                 with_error(channel.quantities[TYN_SLAB_SWEEP_TRANSMITTANCE], i),
                 with_error(channel.quantities[TYN_SLAB_SWEEP_ABSORBED], i)});
    const double highest = *std::max_element(arguments_.sweep.begin(), arguments_.sweep.end());
    std::printf("\nThe above is at albedo %s, the highest of the sweep:\n\n", number(highest, 6).c_str());
    table.print(0);
    if (count < arguments_.sweep.size())
      std::printf("... and %zu more: --csv FILE or --json\n", arguments_.sweep.size() - count);
  }

  void print_run() const {
    const TynSlabRun &run = results_.run;
    const double rate = run.seconds > 0.0 ? static_cast<double>(run.events) / run.seconds : 0.0;
    std::printf("\n%llu photon%s, %.3g scattering events in %.3g s: %.3g events/s on %s\n",
                static_cast<unsigned long long>(run.photons),
                results_.channels.size() > 1 ? "s a channel"
                : run.photons > 1            ? "s"
                                             : "",
                static_cast<double>(run.events), run.seconds, rate, results_.device.name);
  }

  void print_files() const {
    for (const std::string *file : {&arguments_.csv, &arguments_.plot})
      if (!file->empty())
        std::printf("wrote %s\n", file->c_str());
    const TynSlabOptions &options = arguments_.options;
    const bool resolved =
        options.radial_bins || options.angular_bins || options.depth_bins || options.order_bins || options.path_bins;
    if (resolved && arguments_.csv.empty() && arguments_.plot.empty())
      std::printf("The bins are in --csv FILE, --plot FILE.png and --json.\n");
  }

  const Arguments &arguments_;
  const Results &results_;
};

} // namespace

void print_text(const Arguments &arguments, const Results &results) { Report(arguments, results).print(); }

} // namespace slab
