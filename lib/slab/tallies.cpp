// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/argument.hpp"
#include "core/pi.hpp"
#include "slab/tallies.hpp"

namespace tyn {

namespace {

constexpr uint64_t most_tallies = uint64_t(1) << 22;     // 32 MiB a batch
constexpr uint64_t most_in_channels = uint64_t(1) << 23; // of all channels: each keeps its estimates

double scale_of(uint32_t bins, double end) { return bins ? bins / end : 0; }

// The areas of the rings, 1/scale wide.
std::vector<double> ring_areas(uint32_t bins, double scale) {
  std::vector<double> areas(bins);
  for (uint32_t i = 0; i < bins; ++i)
    areas[i] = pi * (2.0 * i + 1) / (scale * scale);
  return areas;
}

// The solid angles of bins of equal steps of the angle from 0 to pi/2.
std::vector<double> solid_angles(uint32_t bins) {
  std::vector<double> angles(bins);
  const double step = pi / 2 / bins;
  for (uint32_t i = 0; i < bins; ++i)
    angles[i] = 4 * pi * std::sin((i + 0.5) * step) * std::sin(0.5 * step); // 2 pi (cos a - cos b)
  return angles;
}

std::vector<double> products(const std::vector<double> &rows, const std::vector<double> &columns) {
  std::vector<double> all;
  all.reserve(rows.size() * columns.size());
  for (double row : rows)
    for (double column : columns)
      all.push_back(row * column);
  return all;
}

double weight_of(int64_t tally) { return double(tally) / double(TYN_SLAB_WEIGHT_SCALE); }

double sweep_weight_of(int64_t tally) { return double(tally) / double(TYN_SLAB_SWEEP_SCALE); }

// How many values each quantity has.
std::array<size_t, TYN_SLAB_QUANTITY_COUNT> counts_of(const TynSlabParameters &p) {
  std::array<size_t, TYN_SLAB_QUANTITY_COUNT> count{};
  count[TYN_SLAB_LAYER_ABSORBED] = p.layer_count;
  count[TYN_SLAB_RADIAL_REFLECTANCE] = count[TYN_SLAB_RADIAL_TRANSMITTANCE] = p.radial_bins;
  count[TYN_SLAB_ANGULAR_REFLECTANCE] = count[TYN_SLAB_ANGULAR_TRANSMITTANCE] = p.angular_bins;
  if (p.radial_angular)
    count[TYN_SLAB_RADIAL_ANGULAR_REFLECTANCE] = count[TYN_SLAB_RADIAL_ANGULAR_TRANSMITTANCE] =
        size_t(p.radial_bins) * p.angular_bins;
  count[TYN_SLAB_DEPTH_ABSORBED] = count[TYN_SLAB_DEPTH_FLUENCE] = p.depth_bins;
  count[TYN_SLAB_ORDER_REFLECTANCE] = count[TYN_SLAB_ORDER_TRANSMITTANCE] = p.order_bins;
  count[TYN_SLAB_PATH_REFLECTANCE] = count[TYN_SLAB_PATH_TRANSMITTANCE] = p.path_bins;
  for (uint32_t quantity : {TYN_SLAB_SWEEP_REFLECTANCE, TYN_SLAB_SWEEP_TRANSMITTANCE, TYN_SLAB_SWEEP_ABSORBED})
    count[quantity] = p.sweep_count;
  return count;
}

} // namespace

void lay_out_tallies(const TynSlabOptions &options, size_t channels, TynSlabParameters &p) {
  const uint64_t most = std::min<uint64_t>(most_tallies, most_in_channels / channels);
  p.radial_bins = options.radial_bins;
  p.angular_bins = options.angular_bins;
  p.depth_bins = options.depth_bins;
  p.order_bins = options.order_bins;
  p.path_bins = options.path_bins;
  p.sweep_count = options.sweep_count;
  p.radial_scale = float(scale_of(options.radial_bins, options.radial_max));
  p.depth_scale = float(scale_of(options.depth_bins, options.depth_max));
  p.path_scale = float(scale_of(options.path_bins, options.path_max));

  uint64_t next = TYN_SLAB_TALLY_LAYERS + p.layer_count;
  auto place = [&](uint32_t &first, uint64_t count) {
    first = uint32_t(next);
    next += count;
    if (next > most)
      fail(TYN_ERROR_INVALID_ARGUMENT, "the bins asked for need more than %llu tallies a channel: ask for fewer bins",
           (unsigned long long)most);
  };
  place(p.radial, 2 * uint64_t(p.radial_bins));
  place(p.angular, 2 * uint64_t(p.angular_bins));
  place(p.depth, uint64_t(p.layer_count) * p.depth_bins);
  place(p.order, 2 * uint64_t(p.order_bins));
  place(p.path, 2 * uint64_t(p.path_bins));
  place(p.sweep, 2 * uint64_t(p.sweep_count));
  if (options.radial_angular)
    place(p.radial_angular, 2 * uint64_t(p.radial_bins) * p.angular_bins);
  p.tally_count = uint32_t(next);
}

Estimates::Estimates(const Slab &slab_, size_t channel_, const TynSlabOptions &options,
                     const TynSlabParameters &parameters_, double specular_)
    : slab(slab_), channel(channel_), parameters(parameters_), specular(specular_), count(counts_of(parameters_)),
      moments(0) {
  size_t next = TotalCount;
  for (size_t quantity = 0; quantity < TYN_SLAB_QUANTITY_COUNT; ++quantity) {
    first[quantity] = next;
    next += count[quantity];
  }
  batch.resize(next);
  moments = Moments(next);
  const std::vector<double> areas = ring_areas(options.radial_bins, scale_of(options.radial_bins, options.radial_max));
  const std::vector<double> angles = solid_angles(options.angular_bins);
  bin_size[TYN_SLAB_RADIAL_REFLECTANCE] = areas;
  bin_size[TYN_SLAB_ANGULAR_REFLECTANCE] = angles;
  if (parameters.radial_angular)
    bin_size[TYN_SLAB_RADIAL_ANGULAR_REFLECTANCE] = products(areas, angles);
  if (options.path_bins)
    bin_size[TYN_SLAB_PATH_REFLECTANCE].assign(options.path_bins, options.path_max / options.path_bins);
}

void Estimates::add(const int64_t *tallies, uint64_t photons) {
  std::fill(batch.begin(), batch.end(), 0.0);
  evaluate_totals(tallies, photons);
  evaluate_sides(TYN_SLAB_RADIAL_REFLECTANCE, tallies, parameters.radial);
  evaluate_sides(TYN_SLAB_ANGULAR_REFLECTANCE, tallies, parameters.angular);
  evaluate_sides(TYN_SLAB_RADIAL_ANGULAR_REFLECTANCE, tallies, parameters.radial_angular);
  evaluate_sides(TYN_SLAB_ORDER_REFLECTANCE, tallies, parameters.order);
  evaluate_sides(TYN_SLAB_PATH_REFLECTANCE, tallies, parameters.path);
  evaluate_depth(tallies);
  evaluate_sweep(tallies, photons);
  // light that the first interface reflects has not been scattered
  if (parameters.order_bins)
    values(TYN_SLAB_ORDER_REFLECTANCE)[0] = batch[Specular];
  event_count += uint64_t(tallies[TYN_SLAB_TALLY_EVENTS]);
  moments.add(batch, photons);
}

// What the first interface reflects, which never becomes a walk.
double Estimates::surface_reflection(const int64_t *tallies, uint64_t photons) const {
  return specular * double(photons) + weight_of(tallies[TYN_SLAB_TALLY_SURFACE]);
}

void Estimates::evaluate_totals(const int64_t *tallies, uint64_t photons) {
  batch[Specular] = surface_reflection(tallies, photons) + weight_of(tallies[TYN_SLAB_TALLY_EXIT]);
  batch[DiffuseR] = weight_of(tallies[TYN_SLAB_TALLY_EXIT + 1]);
  batch[Reflectance] = batch[Specular] + batch[DiffuseR];
  batch[Direct] = weight_of(tallies[TYN_SLAB_TALLY_EXIT + 2]);
  batch[DiffuseT] = weight_of(tallies[TYN_SLAB_TALLY_EXIT + 3]);
  batch[Transmittance] = batch[Direct] + batch[DiffuseT];
  batch[Cut] = weight_of(tallies[TYN_SLAB_TALLY_CUT]);
  for (uint32_t i = 0; i < parameters.layer_count; ++i) {
    values(TYN_SLAB_LAYER_ABSORBED)[i] = weight_of(tallies[TYN_SLAB_TALLY_LAYERS + i]);
    batch[Absorbed] += values(TYN_SLAB_LAYER_ABSORBED)[i];
  }
}

// A quantity of reflected light, and of transmitted light, which follows it both in the tallies and in the enumeration.
void Estimates::evaluate_sides(uint32_t quantity, const int64_t *tallies, uint32_t tally) {
  const std::vector<double> &size = bin_size[quantity];
  for (uint32_t side = 0; side < 2; ++side)
    for (size_t i = 0; i < count[quantity]; ++i)
      values(quantity + side)[i] =
          weight_of(tallies[tally + side * count[quantity] + i]) / (size.empty() ? 1 : size[i]);
}

// Every event adds its weight w to the bin of its layer and depth: w (1 - albedo) of it is absorbed, and w / sigma_t is the
// collision estimate of the path length there. In clear layers the path length itself is added.
void Estimates::evaluate_depth(const int64_t *tallies) {
  for (uint32_t bin = 0; bin < parameters.depth_bins; ++bin)
    for (size_t i = 0; i < slab.layers.size(); ++i) {
      const SlabLayer &layer = slab.layers[i];
      const double sigma_t = layer.sigma_a[channel] + layer.sigma_s[channel];
      const double weight = weight_of(tallies[parameters.depth + i * parameters.depth_bins + bin]);
      const double per_length = weight * double(parameters.depth_scale);
      if (sigma_t > 0) {
        values(TYN_SLAB_DEPTH_ABSORBED)[bin] += per_length * layer.sigma_a[channel] / sigma_t;
        values(TYN_SLAB_DEPTH_FLUENCE)[bin] += per_length / sigma_t;
      } else {
        values(TYN_SLAB_DEPTH_FLUENCE)[bin] += weight;
      }
    }
}

void Estimates::evaluate_sweep(const int64_t *tallies, uint64_t photons) {
  const double surface = surface_reflection(tallies, photons);
  for (uint32_t row = 0; row < parameters.sweep_count; ++row) {
    const double reflected = surface + sweep_weight_of(tallies[parameters.sweep + row]);
    const double transmitted = sweep_weight_of(tallies[parameters.sweep + parameters.sweep_count + row]);
    values(TYN_SLAB_SWEEP_REFLECTANCE)[row] = reflected;
    values(TYN_SLAB_SWEEP_TRANSMITTANCE)[row] = transmitted;
    values(TYN_SLAB_SWEEP_ABSORBED)[row] = double(photons) - reflected - transmitted;
  }
}

double Estimates::error() const {
  return std::max(moments.estimate(Reflectance).standard_error, moments.estimate(Transmittance).standard_error);
}

SlabChannelResult Estimates::result() const {
  SlabChannelResult result;
  TynSlabTotals &totals = result.totals;
  totals.size = sizeof totals;
  totals.specular_reflectance = moments.estimate(Specular);
  totals.diffuse_reflectance = moments.estimate(DiffuseR);
  totals.reflectance = moments.estimate(Reflectance);
  totals.direct_transmittance = moments.estimate(Direct);
  totals.diffuse_transmittance = moments.estimate(DiffuseT);
  totals.transmittance = moments.estimate(Transmittance);
  totals.absorbed = moments.estimate(Absorbed);
  totals.cut = moments.estimate(Cut);
  for (size_t quantity = 0; quantity < TYN_SLAB_QUANTITY_COUNT; ++quantity)
    for (size_t i = 0; i < count[quantity]; ++i)
      result.quantities[quantity].push_back(moments.estimate(first[quantity] + i));
  return result;
}

} // namespace tyn
