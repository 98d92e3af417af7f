// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "slab/bins.hpp"

namespace slab {
namespace {

Rows between(const std::vector<double> &edges) {
  return {{edges.begin(), edges.end() - 1}, {edges.begin() + 1, edges.end()}};
}

Rows points(const std::vector<double> &values) { return {values, values}; }

std::vector<double> orders(const Arguments &arguments) {
  std::vector<double> result;
  for (uint32_t i = 0; i < arguments.options.order_bins; ++i)
    result.push_back(i);
  return result;
}

} // namespace

std::vector<double> equal_edges(double end, uint32_t bins) {
  std::vector<double> edges;
  for (uint32_t i = 0; i <= bins; ++i)
    edges.push_back(end * i / (bins ? bins : 1));
  return edges;
}

std::vector<double> radial_edges(const Arguments &arguments) {
  return equal_edges(arguments.options.radial_max, arguments.options.radial_bins);
}

std::vector<double> angular_edges(const Arguments &arguments) {
  return equal_edges(90.0, arguments.options.angular_bins);
}

std::vector<double> depth_edges(const Arguments &arguments) {
  return equal_edges(arguments.options.depth_max, arguments.options.depth_bins);
}

std::vector<double> path_edges(const Arguments &arguments) {
  return equal_edges(arguments.options.path_max, arguments.options.path_bins);
}

std::vector<double> layer_edges(const Arguments &arguments) {
  std::vector<double> edges = {0.0};
  for (const LayerArgument &layer : arguments.layers)
    edges.push_back(edges.back() + layer.thickness);
  return edges;
}

Rows rows_of(uint32_t quantity, const Arguments &arguments) {
  switch (quantity) {
  case TYN_SLAB_LAYER_ABSORBED:
    return between(layer_edges(arguments));
  case TYN_SLAB_RADIAL_REFLECTANCE:
  case TYN_SLAB_RADIAL_TRANSMITTANCE:
  case TYN_SLAB_RADIAL_ANGULAR_REFLECTANCE:
  case TYN_SLAB_RADIAL_ANGULAR_TRANSMITTANCE:
    return between(radial_edges(arguments));
  case TYN_SLAB_ANGULAR_REFLECTANCE:
  case TYN_SLAB_ANGULAR_TRANSMITTANCE:
    return between(angular_edges(arguments));
  case TYN_SLAB_DEPTH_ABSORBED:
  case TYN_SLAB_DEPTH_FLUENCE:
    return between(depth_edges(arguments));
  case TYN_SLAB_PATH_REFLECTANCE:
  case TYN_SLAB_PATH_TRANSMITTANCE:
    return between(path_edges(arguments));
  case TYN_SLAB_ORDER_REFLECTANCE:
  case TYN_SLAB_ORDER_TRANSMITTANCE:
    return points(orders(arguments));
  default:
    return points(arguments.sweep);
  }
}

bool is_radial_angular(uint32_t quantity) {
  return quantity == TYN_SLAB_RADIAL_ANGULAR_REFLECTANCE || quantity == TYN_SLAB_RADIAL_ANGULAR_TRANSMITTANCE;
}

std::string unit_of(uint32_t quantity, const Arguments &arguments) {
  const std::string &length = arguments.unit;
  switch (quantity) {
  case TYN_SLAB_RADIAL_REFLECTANCE:
  case TYN_SLAB_RADIAL_TRANSMITTANCE:
    return "1/" + length + "^2";
  case TYN_SLAB_ANGULAR_REFLECTANCE:
  case TYN_SLAB_ANGULAR_TRANSMITTANCE:
    return "1/sr";
  case TYN_SLAB_RADIAL_ANGULAR_REFLECTANCE:
  case TYN_SLAB_RADIAL_ANGULAR_TRANSMITTANCE:
    return "1/(" + length + "^2 sr)";
  case TYN_SLAB_DEPTH_ABSORBED:
  case TYN_SLAB_PATH_REFLECTANCE:
  case TYN_SLAB_PATH_TRANSMITTANCE:
    return "1/" + length;
  default:
    return "1";
  }
}

} // namespace slab
