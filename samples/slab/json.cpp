// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "slab/bins.hpp"
#include "slab/outputs.hpp"

namespace slab {
namespace {

using tool::Json;

Json estimate(const TynEstimate &value) { return {{"value", value.value}, {"stderr", value.standard_error}}; }

Json curve(const Curve &values) { return {{"value", values.values}, {"stderr", values.errors}}; }

Json entry(const Curve &values, size_t i) { return {{"value", values.values[i]}, {"stderr", values.errors[i]}}; }

Json rows(const std::vector<double> &values, size_t columns) {
  Json list = Json::array();
  for (size_t i = 0; i < values.size(); i += columns)
    list.push_back(std::vector<double>(values.begin() + i, values.begin() + i + columns));
  return list;
}

Json grid(const Curve &values, size_t columns) {
  return {{"value", rows(values.values, columns)}, {"stderr", rows(values.errors, columns)}};
}

Json layer_list(const Curve &absorbed) {
  Json list = Json::array();
  for (size_t i = 0; i < absorbed.values.size(); ++i)
    list.push_back({{"absorbed", entry(absorbed, i)}});
  return list;
}

Json sweep_list(const Arguments &arguments, const ChannelResults &channel) {
  Json list = Json::array();
  for (size_t i = 0; i < arguments.sweep.size(); ++i)
    list.push_back({{"albedo", arguments.sweep[i]},
                    {"reflectance", entry(channel.quantities[TYN_SLAB_SWEEP_REFLECTANCE], i)},
                    {"transmittance", entry(channel.quantities[TYN_SLAB_SWEEP_TRANSMITTANCE], i)},
                    {"absorbed", entry(channel.quantities[TYN_SLAB_SWEEP_ABSORBED], i)}});
  return list;
}

Json exact(const ChannelResults &channel) {
  const TynAddingDoublingResult &solution = channel.exact;
  const TynSlabTotals &totals = channel.totals;
  return {{"reflectance", solution.reflectance},
          {"transmittance", solution.transmittance},
          {"absorbed", solution.absorbed},
          {"accuracy", solution.accuracy},
          {"reflectance_deviation", deviation(totals.reflectance, solution.reflectance, solution.accuracy)},
          {"transmittance_deviation", deviation(totals.transmittance, solution.transmittance, solution.accuracy)}};
}

void add_totals(const TynSlabTotals &totals, Json &object) {
  object["reflectance"] = {{"specular", estimate(totals.specular_reflectance)},
                           {"diffuse", estimate(totals.diffuse_reflectance)},
                           {"total", estimate(totals.reflectance)}};
  object["transmittance"] = {{"direct", estimate(totals.direct_transmittance)},
                             {"diffuse", estimate(totals.diffuse_transmittance)},
                             {"total", estimate(totals.transmittance)}};
  object["absorbed"] = estimate(totals.absorbed);
  object["cut"] = estimate(totals.cut);
}

void add_resolved(const Arguments &arguments, const ChannelResults &channel, Json &object) {
  const TynSlabOptions &options = arguments.options;
  const auto &q = channel.quantities;
  if (options.radial_bins)
    object["radial"] = {{"edges", radial_edges(arguments)},
                        {"reflectance", curve(q[TYN_SLAB_RADIAL_REFLECTANCE])},
                        {"transmittance", curve(q[TYN_SLAB_RADIAL_TRANSMITTANCE])}};
  if (options.angular_bins)
    object["angular"] = {{"edges", angular_edges(arguments)},
                         {"reflectance", curve(q[TYN_SLAB_ANGULAR_REFLECTANCE])},
                         {"transmittance", curve(q[TYN_SLAB_ANGULAR_TRANSMITTANCE])}};
  if (options.radial_angular)
    object["radial_angular"] = {
        {"reflectance", grid(q[TYN_SLAB_RADIAL_ANGULAR_REFLECTANCE], options.angular_bins)},
        {"transmittance", grid(q[TYN_SLAB_RADIAL_ANGULAR_TRANSMITTANCE], options.angular_bins)}};
  if (options.depth_bins)
    object["depth"] = {{"edges", depth_edges(arguments)},
                       {"absorbed", curve(q[TYN_SLAB_DEPTH_ABSORBED])},
                       {"fluence", curve(q[TYN_SLAB_DEPTH_FLUENCE])}};
  if (options.order_bins)
    object["orders"] = {{"reflectance", curve(q[TYN_SLAB_ORDER_REFLECTANCE])},
                        {"transmittance", curve(q[TYN_SLAB_ORDER_TRANSMITTANCE])}};
  if (options.path_bins)
    object["path"] = {{"edges", path_edges(arguments)},
                      {"reflectance", curve(q[TYN_SLAB_PATH_REFLECTANCE])},
                      {"transmittance", curve(q[TYN_SLAB_PATH_TRANSMITTANCE])}};
  if (!arguments.sweep.empty())
    object["sweep"] = sweep_list(arguments, channel);
}

void add_channel(const Arguments &arguments, const ChannelResults &channel, Json &object) {
  add_totals(channel.totals, object);
  object["layers"] = layer_list(channel.quantities[TYN_SLAB_LAYER_ABSORBED]);
  add_resolved(arguments, channel, object);
  if (arguments.exact)
    object["exact"] = exact(channel);
}

} // namespace

Json to_json(const char *tool_name, const Arguments &arguments, const Results &results) {
  Json outputs = Json::object();
  if (!arguments.csv.empty())
    outputs["csv"] = arguments.csv;
  if (!arguments.plot.empty())
    outputs["plot"] = arguments.plot;
  Json object = {{"tool", tool::version_line(tool_name)},
                 {"interrupted", results.interrupted},
                 {"outputs", outputs},
                 {"unit", arguments.unit},
                 {"photons", results.run.photons},
                 {"events", results.run.events},
                 {"seconds", results.run.seconds},
                 {"seed", results.run.seed},
                 {"device", tool::to_json(results.device)}};
  if (results.channels.size() == 1) {
    add_channel(arguments, results.channels.front(), object);
    return object;
  }
  Json channels = Json::array();
  for (size_t c = 0; c < results.channels.size(); ++c) {
    Json channel = {{"name", results.names[c]}};
    add_channel(arguments, results.channels[c], channel);
    channels.push_back(channel);
  }
  object["channels"] = channels;
  return object;
}

} // namespace slab
