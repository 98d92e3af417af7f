// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "common/table.hpp"
#include "profile/outputs.hpp"
#include "slab/format.hpp"

#include <cmath>
#include <cstdio>

namespace profile {
namespace {

using tool::number;
using tool::Table;

class Report {
public:
  Report(const Arguments &arguments, const Results &results) : arguments_(arguments), results_(results) {}

  void print() const {
    if (results_.interrupted)
      std::printf("interrupted; what was done:\n");
    for (size_t c = 0; c < arguments_.channels(); ++c)
      print_channel(c);
    if (arguments_.compare)
      print_run();
    for (const std::string *file : {&arguments_.csv, &arguments_.plot})
      if (!file->empty())
        std::printf("wrote %s\n", file->c_str());
  }

private:
  void print_channel(size_t c) const {
    const char *what = arguments_.transmitted ? "T(r), what leaves below" : "R(r)";
    const char *unit = arguments_.unit.c_str();
    const bool is_named = arguments_.channels() > 1;
    const std::string channel =
        is_named ? (arguments_.is_rgb ? "" : "channel ") + results_.channel_names[c] + ": " : "";
    std::printf("%s%s%s, 1/%s^2, over r, %s\n\n", c ? "\n" : "", channel.c_str(), what, unit, unit);
    print_profiles(c);
    if (!arguments_.compare)
      return;
    std::printf("\nThe exact mean over the ring around each radius, and the deviation of the models', %%\n\n");
    print_deviations(c);
  }

  std::vector<std::string> heading(const std::vector<std::string> &first) const {
    std::vector<std::string> row = first;
    for (const ModelResults &model : results_.models)
      row.push_back(model.name);
    return row;
  }

  void print_profiles(size_t c) const {
    Table table;
    table.add(heading({"radius"}));
    for (size_t i = 0; i < arguments_.radii.size(); ++i) {
      std::vector<std::string> row = {number(arguments_.radii[i])};
      for (const ModelResults &model : results_.models)
        row.push_back(number(model.profile[c][i]));
      table.add(row);
    }
    std::vector<std::string> row = {"albedo"};
    for (const ModelResults &model : results_.models)
      row.push_back(number(model.albedo[c]));
    table.add(row);
    table.print(0);
  }

  void print_deviations(size_t c) const {
    Table table;
    table.add(heading({"radius", "exact", "+- %"}));
    const ExactResults &exact = results_.exact;
    for (size_t i = 0; i < arguments_.radii.size(); ++i) {
      const double value = exact.profile[c].values[i];
      std::vector<std::string> row = {number(arguments_.radii[i]), number(value),
                                      number(100.0 * exact.profile[c].errors[i] / value, 2)};
      for (const ModelResults &model : results_.models)
        row.push_back(percent(model.deviation[c].values[i]));
      table.add(row);
    }
    const TynEstimate &albedo = exact.albedo[c];
    std::vector<std::string> row = {"albedo", number(albedo.value),
                                    number(100.0 * albedo.standard_error / albedo.value, 2)};
    for (const ModelResults &model : results_.models)
      row.push_back(percent(model.albedo_deviation[c].value));
    table.add(row);
    table.print(0);
  }

  // To a tenth, or of many to three digits.
  static std::string percent(double ratio) {
    if (!std::isfinite(ratio))
      return "-";
    char text[48];
    const double rounded = std::round(1000.0 * ratio) / 10.0 + 0.0; // 0 without a minus
    std::snprintf(text, sizeof text, std::fabs(ratio) < 10.0 ? "%+.1f" : "%+.3g", rounded);
    return text;
  }

  void print_run() const {
    const TynSlabRun &run = results_.exact.run;
    std::printf("\n%llu photons%s, %.3g scattering events in %.3g s on %s\n",
                static_cast<unsigned long long>(run.photons), arguments_.channels() > 1 ? " a channel" : "",
                static_cast<double>(run.events), run.seconds, results_.device.name);
  }

  const Arguments &arguments_;
  const Results &results_;
};

} // namespace

void print_text(const Arguments &arguments, const Results &results) { Report(arguments, results).print(); }

} // namespace profile
