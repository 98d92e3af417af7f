// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "slab/layers.hpp"

#include "common/loading.hpp"
#include "slab/parse.hpp"
#include "slab/phase.hpp"

#include <charconv>

namespace slab {
namespace {

constexpr size_t kMostLayers = 64;
constexpr size_t kMostChannels = 1024;
constexpr double kMostCoefficient = 1e30;
constexpr double kMetresPerMm = 1e-3;

std::vector<double> coefficients(const std::string &option, const std::string &text, char separator) {
  const std::string expected = "coefficients from 0 to 1e30 (1/length), one a channel";
  const std::vector<std::string> parts = split(text, separator);
  if (parts.size() > kMostChannels)
    wrong(option, std::to_string(parts.size()) + " values", "1 to 1024 channels");
  std::vector<double> values;
  for (const std::string &part : parts)
    values.push_back(number_between(option, part, 0.0, kMostCoefficient, expected));
  return values;
}

double mean_cosine(const std::string &option, const std::string &text) {
  double g = 0.0;
  if (!parse_number(text, g) || !(g > -1.0 && g < 1.0))
    wrong(option, text, "a mean cosine above -1 and below 1");
  return g;
}

double refractive_index(const std::string &option, const std::string &text) {
  return number_between(option, text, 1.0, 4.0, "a refractive index from 1 to 4");
}

double layer_thickness(const std::string &option, const std::string &text) {
  double thickness = 0.0;
  if (!parse_number(text, thickness) || !(thickness > 0.0))
    wrong(option, text, "a thickness above 0, or inf");
  return thickness;
}

// A float as the decimal number that it was written as.
double as_written(float value) {
  char text[32];
  const char *end = std::to_chars(text, text + sizeof text, value).ptr;
  double result = value;
  std::from_chars(text, end, result);
  return result;
}

LayerArgument preset_layer(const std::string &name) {
  tool::parse_media({name}); // throws, naming those that there are
  TynMedium medium = tyn_medium();
  if (tyn_medium_preset(name.c_str(), kMetresPerMm, &medium) != TYN_OK)
    wrong("--medium", name, "the name of a measured medium");
  LayerArgument layer;
  for (int c = 0; c < 3; ++c) {
    layer.sigma_a.push_back(as_written(medium.sigma_a[c]));
    layer.sigma_s.push_back(as_written(medium.sigma_s[c]));
  }
  layer.g = as_written(medium.g);
  layer.ior = as_written(medium.ior);
  return layer;
}

LayerArgument single_layer(const LayerText &text) {
  LayerArgument layer;
  if (!text.medium.empty()) {
    if (!text.sigma_a.empty() || !text.sigma_s.empty())
      throw tool::Error(tool::kUsage,
                        "--medium " + text.medium + " and --sigma-a or --sigma-s: expected one or the other");
    layer = preset_layer(text.medium);
  } else {
    if (text.sigma_a.empty() || text.sigma_s.empty())
      throw tool::Error(tool::kUsage, "expected --sigma-a and --sigma-s, or --layer, or --medium (see --help)");
    layer.sigma_a = coefficients("--sigma-a", text.sigma_a, ',');
    layer.sigma_s = coefficients("--sigma-s", text.sigma_s, ',');
  }
  if (!text.g.empty())
    layer.g = mean_cosine("--g", text.g);
  if (!text.ior.empty())
    layer.ior = refractive_index("--ior", text.ior);
  if (!text.thickness.empty())
    layer.thickness = layer_thickness("--thickness", text.thickness);
  return layer;
}

LayerArgument parse_layer(const std::string &text) {
  const std::string option = "--layer " + text + ":";
  const std::vector<std::string> parts = split(text, ',');
  if (parts.size() != 5)
    wrong("--layer", text, "five values, sigma_a,sigma_s,g,ior,thickness (channels apart by /: 0.1/0.2/0.3)");
  LayerArgument layer;
  layer.sigma_a = coefficients(option + " sigma_a", parts[0], '/');
  layer.sigma_s = coefficients(option + " sigma_s", parts[1], '/');
  layer.g = mean_cosine(option + " g", parts[2]);
  layer.ior = refractive_index(option + " ior", parts[3]);
  layer.thickness = layer_thickness(option + " thickness", parts[4]);
  return layer;
}

void refuse_beside_layers(const char *option, const std::string &text) {
  if (!text.empty())
    throw tool::Error(tool::kUsage, std::string(option) + " " + text + " and --layer: expected one or the other");
}

void read_stack(const LayerText &text, Arguments &arguments) {
  refuse_beside_layers("--sigma-a", text.sigma_a);
  refuse_beside_layers("--sigma-s", text.sigma_s);
  refuse_beside_layers("--g", text.g);
  refuse_beside_layers("--ior", text.ior);
  refuse_beside_layers("--thickness", text.thickness);
  refuse_beside_layers("--medium", text.medium);
  refuse_beside_layers("--phase", text.phase);
  if (text.layers.size() > kMostLayers)
    wrong("--layer", "given " + std::to_string(text.layers.size()) + " times", "1 to 64 layers");
  arguments.is_stack = true;
  for (const std::string &layer : text.layers)
    arguments.layers.push_back(parse_layer(layer));
}

void read_single(const LayerText &text, Arguments &arguments) {
  arguments.layers.push_back(single_layer(text));
  arguments.medium = text.medium;
  arguments.is_rgb = !text.medium.empty();
  if (text.phase.empty())
    return;
  if (text.phase != "hg" && !text.g.empty())
    throw tool::Error(tool::kUsage, "--g " + text.g + " and --phase " + text.phase + ": --g is for --phase hg only");
  arguments.phase = parse_phase(text.phase);
}

void check_channels(const std::vector<LayerArgument> &layers, bool is_stack) {
  const size_t channels = layers.front().sigma_a.size();
  for (size_t i = 0; i < layers.size(); ++i) {
    const std::string where = is_stack ? "--layer " + std::to_string(i + 1) + ": " : "--sigma-a and --sigma-s: ";
    const size_t sigma_a = layers[i].sigma_a.size(), sigma_s = layers[i].sigma_s.size();
    if (sigma_a != sigma_s)
      throw tool::Error(tool::kUsage, where + std::to_string(sigma_a) + " and " + std::to_string(sigma_s) +
                                          " values: expected one a channel for both");
    if (sigma_a != channels)
      throw tool::Error(tool::kUsage, where + std::to_string(sigma_a) + " values a coefficient, but " +
                                          std::to_string(channels) + " in layer 1: expected as many in all layers");
  }
}

void check_thicknesses(const std::vector<LayerArgument> &layers) {
  for (size_t i = 0; i + 1 < layers.size(); ++i)
    if (std::isinf(layers[i].thickness))
      throw tool::Error(tool::kUsage, "--layer " + std::to_string(i + 1) +
                                          ": its thickness is inf: expected a finite one in all layers but the last");
}

} // namespace

void read_layers(const LayerText &text, Arguments &arguments) {
  if (text.layers.empty())
    read_single(text, arguments);
  else
    read_stack(text, arguments);
  check_channels(arguments.layers, arguments.is_stack);
  check_thicknesses(arguments.layers);
}

} // namespace slab
