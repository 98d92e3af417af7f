// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "common/tool.hpp"
#include "profile/outputs.hpp"

namespace profile {
namespace {

using tool::Json;

// Numbers that are not finite become null, those in lists too.
Json estimates(const std::vector<TynEstimate> &values, const char *name) {
  Json list = Json::array(), errors = Json::array();
  for (const TynEstimate &value : values) {
    list.push_back(value.value);
    errors.push_back(value.standard_error);
  }
  return {{name, list}, {"standard_error", errors}};
}

// Lists by channel.
Json curves(const std::vector<Curve> &channels, const char *name) {
  Json list = Json::array(), errors = Json::array();
  for (const Curve &curve : channels) {
    list.push_back(curve.values);
    errors.push_back(curve.errors);
  }
  return {{name, list}, {"standard_error", errors}};
}

Json layer(const slab::LayerArgument &layer) {
  return {{"sigma_a", layer.sigma_a},
          {"sigma_s", layer.sigma_s},
          {"g", layer.g},
          {"ior", layer.ior},
          {"thickness", layer.thickness}}; // null: a half-space
}

Json medium(const Arguments &arguments, const Results &results) {
  Json object = Json::object();
  if (!arguments.medium.empty())
    object["name"] = arguments.medium;
  object["channels"] = results.channel_names;
  if (arguments.layers.size() == 1) {
    object.update(layer(arguments.top()));
    return object;
  }
  object["layers"] = Json::array();
  for (const slab::LayerArgument &one : arguments.layers)
    object["layers"].push_back(layer(one));
  return object;
}

Json model(const Arguments &arguments, const Results &results, const ModelResults &model) {
  Json object = {{"profile", model.profile}, {"standard_error", model.errors}, {"albedo", model.albedo}};
  if (!arguments.compare)
    return object;
  Json error = {{"radii", results.exact.edges}};
  error.update(curves(model.deviation, "relative"));
  error["albedo"] = estimates(model.albedo_deviation, "relative");
  object["error"] = error;
  return object;
}

Json exact(const ExactResults &exact) {
  Json object = {{"radii", exact.edges}};
  object.update(curves(exact.profile, "profile"));
  object["albedo"] = estimates(exact.albedo, "value");
  object["photons"] = exact.run.photons;
  object["events"] = exact.run.events;
  object["seconds"] = exact.run.seconds;
  object["seed"] = exact.run.seed;
  return object;
}

} // namespace

Json to_json(const char *tool_name, const Arguments &arguments, const Results &results) {
  Json outputs = Json::object();
  if (!arguments.csv.empty())
    outputs["csv"] = arguments.csv;
  if (!arguments.plot.empty())
    outputs["plot"] = arguments.plot;
  Json models = Json::object();
  for (const ModelResults &one : results.models)
    models[one.name] = model(arguments, results, one);
  Json object = {{"tool", tool::version_line(tool_name)},
                 {"interrupted", results.interrupted},
                 {"outputs", outputs},
                 {"unit", arguments.unit},
                 {"medium", medium(arguments, results)},
                 {"transmitted", arguments.transmitted},
                 {"radii", arguments.radii},
                 {"models", models}};
  if (arguments.compare)
    object["exact"] = exact(results.exact);
  object["device"] = tool::to_json(results.device);
  return object;
}

} // namespace profile
