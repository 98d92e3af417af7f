// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
//
// Tidy data: every row is one value with all that says what it is, so that spreadsheets and data frames can select.
#include "slab/bins.hpp"
#include "slab/format.hpp"
#include "slab/outputs.hpp"

namespace slab {
namespace {

std::string interval(double lower, double upper) { return exactly(lower) + "," + exactly(upper); }

class Writer {
public:
  Writer(const Arguments &arguments, const Results &results) : arguments_(arguments), results_(results) {}

  std::string write() {
    text_ = "quantity,channel,row,column,lower,upper,column_lower,column_upper,unit,value,stderr\n";
    for (size_t c = 0; c < results_.channels.size(); ++c)
      add_channel(results_.names[c], results_.channels[c]);
    return text_;
  }

private:
  void add_channel(const std::string &name, const ChannelResults &channel) {
    const TynSlabTotals &totals = channel.totals;
    add_total("specular_reflectance", name, totals.specular_reflectance);
    add_total("diffuse_reflectance", name, totals.diffuse_reflectance);
    add_total("reflectance", name, totals.reflectance);
    add_total("direct_transmittance", name, totals.direct_transmittance);
    add_total("diffuse_transmittance", name, totals.diffuse_transmittance);
    add_total("transmittance", name, totals.transmittance);
    add_total("absorbed", name, totals.absorbed);
    add_total("cut", name, totals.cut);
    if (arguments_.exact) {
      add_row("exact_reflectance", name, ",,,,,,1", exactly(channel.exact.reflectance), "");
      add_row("exact_transmittance", name, ",,,,,,1", exactly(channel.exact.transmittance), "");
    }
    for (uint32_t quantity = 0; quantity < TYN_SLAB_QUANTITY_COUNT; ++quantity)
      add_curve(quantity, name, channel.quantities[quantity]);
  }

  void add_total(const char *quantity, const std::string &channel, const TynEstimate &estimate) {
    add_row(quantity, channel, ",,,,,,1", exactly(estimate.value), exactly(estimate.standard_error));
  }

  void add_curve(uint32_t quantity, const std::string &channel, const Curve &curve) {
    if (curve.values.empty())
      return;
    const Rows rows = rows_of(quantity, arguments_);
    const bool grid = is_radial_angular(quantity);
    const std::vector<double> angles = angular_edges(arguments_);
    const size_t columns = grid ? angles.size() - 1 : 1;
    for (size_t i = 0; i < curve.values.size(); ++i) {
      const size_t row = i / columns, column = i % columns;
      std::string where = std::to_string(row) + "," + (grid ? std::to_string(column) : "") + ",";
      where += interval(rows.lower[row], rows.upper[row]) + ",";
      where += grid ? interval(angles[column], angles[column + 1]) : ",";
      where += "," + unit_of(quantity, arguments_);
      add_row(tyn_slab_quantity_name(quantity), channel, where, exactly(curve.values[i]), exactly(curve.errors[i]));
    }
  }

  // `where`: the columns from `row` to `unit`.
  void add_row(const char *quantity, const std::string &channel, const std::string &where, const std::string &value,
               const std::string &error) {
    text_ += std::string(quantity) + "," + channel + "," + where + "," + value + "," + error + "\n";
  }

  const Arguments &arguments_;
  const Results &results_;
  std::string text_;
};

} // namespace

std::string to_csv(const Arguments &arguments, const Results &results) { return Writer(arguments, results).write(); }

} // namespace slab
