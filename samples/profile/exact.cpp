// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "profile/exact.hpp"

#include "slab/run.hpp"

#include <cmath>

namespace profile {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kMostError = 0.3; // relative standard error up to which an exact value means something

// Of the light that arrives perpendicularly, what gets in. Not 1 minus the specular reflectance, which for a slab holds light
// that had got in and comes back unscattered from the far side.
double fraction_in(const TynSlab &slab) {
  const double above = slab.ior_above, inside = slab.layers[0].ior;
  const double amplitude = (inside - above) / (inside + above);
  return 1.0 - amplitude * amplitude;
}

TynEstimate meaningful(const TynEstimate &estimate) {
  const bool is = estimate.value > 0.0 && estimate.standard_error <= kMostError * estimate.value;
  return is ? estimate : TynEstimate{NAN, NAN};
}

// Means over rings, per power that gets in. A photon leaves once, in one bin: what bins hold is as good as independent, and
// squares of standard errors add up.
Curve pool(const slab::Curve &bins, const Rings &rings, double in) {
  const double step = rings.end / rings.bin_count;
  Curve curve;
  for (size_t ring = 0; ring < rings.count(); ++ring) {
    double power = 0.0, square = 0.0;
    for (uint32_t i = rings.borders[ring]; i < rings.borders[ring + 1]; ++i) {
      const double area = kPi * step * step * (2.0 * i + 1.0);
      power += area * bins.values[i];
      square += std::pow(area * bins.errors[i], 2);
    }
    const double inner = rings.edge(ring), outer = rings.edge(ring + 1);
    const double area = kPi * (outer - inner) * (outer + inner) * in;
    const TynEstimate mean = meaningful({power / area, std::sqrt(square) / area});
    curve.values.push_back(mean.value);
    curve.errors.push_back(mean.standard_error);
  }
  return curve;
}

// `error`: the model's own.
TynEstimate deviation(double model, double error, const TynEstimate &exact) {
  const double ratio = model / exact.value;
  return {ratio - 1.0, std::hypot(ratio * exact.standard_error, error) / exact.value};
}

void add_deviations(const ExactResults &exact, ModelResults &model) {
  for (size_t c = 0; c < exact.profile.size(); ++c) {
    const Curve &rings = exact.profile[c];
    Curve curve;
    for (size_t i = 0; i < rings.values.size(); ++i) {
      const TynEstimate relative =
          deviation(model.ring_means[c].values[i], model.ring_means[c].errors[i], {rings.values[i], rings.errors[i]});
      curve.values.push_back(relative.value);
      curve.errors.push_back(relative.standard_error);
    }
    model.deviation.push_back(curve);
    model.albedo_deviation.push_back(deviation(model.albedo[c], 0.0, exact.albedo[c]));
  }
}

} // namespace

void compare_with_exact(const char *tool_name, TynContext *context, const TynSlab &slab, const Arguments &arguments,
                        const Rings &rings, Results &results) {
  TynSlabOptions options = tyn_slab_options();
  options.photons = arguments.options.photons;
  options.seed = arguments.options.seed;
  options.radial_max = rings.end;
  options.radial_bins = rings.bin_count;
  slab::Results photons;
  slab::simulate(tool_name, context, slab, options, arguments, photons);
  const double in = fraction_in(slab);
  const uint32_t quantity = arguments.transmitted ? TYN_SLAB_RADIAL_TRANSMITTANCE : TYN_SLAB_RADIAL_REFLECTANCE;
  results.interrupted = photons.interrupted;
  results.exact.edges = rings.edges();
  results.exact.run = photons.run;
  for (const slab::ChannelResults &channel : photons.channels) {
    const TynSlabTotals &totals = channel.totals;
    const TynEstimate &total = arguments.transmitted ? totals.diffuse_transmittance : totals.diffuse_reflectance;
    results.exact.profile.push_back(pool(channel.quantities[quantity], rings, in));
    results.exact.albedo.push_back(meaningful({total.value / in, total.standard_error / in}));
  }
  for (ModelResults &model : results.models)
    add_deviations(results.exact, model);
}

} // namespace profile
