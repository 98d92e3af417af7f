// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "common/bssrdf_model.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "common/walk_scene.hpp"
#include "slab/gauss.hpp"

namespace tyn_test {

BssrdfModel::BssrdfModel(const TynSlab &slab, const TynBssrdfOptions &options, TynContext *context)
    : channel_count(slab.channel_count) {
  TynContext *on = context ? context : shared_context();
  TynBssrdf *created = nullptr;
  EXPECT_EQ(tyn_bssrdf_create(on, &slab, &options, &created), TYN_OK) << tyn_context_message(on);
  if (!created)
    throw std::runtime_error("tyn_bssrdf_create");
  handle.reset(created);
}

std::vector<double> BssrdfModel::albedo() const {
  std::vector<double> albedo(channel_count);
  EXPECT_EQ(tyn_bssrdf_albedo(handle.get(), albedo.data(), albedo.size()), TYN_OK);
  return albedo;
}

std::vector<float> BssrdfModel::profile(const std::vector<float> &radii) const {
  std::vector<float> profile(radii.size() * channel_count);
  EXPECT_EQ(tyn_bssrdf_profile(handle.get(), radii.data(), radii.size(), profile.data()), TYN_OK);
  return profile;
}

std::vector<float> BssrdfModel::profile_error(const std::vector<float> &radii) const {
  std::vector<float> errors(radii.size() * channel_count);
  EXPECT_EQ(tyn_bssrdf_profile_error(handle.get(), radii.data(), radii.size(), errors.data()), TYN_OK);
  return errors;
}

std::vector<float> BssrdfModel::pdf(const std::vector<float> &radii) const {
  std::vector<float> pdf(radii.size());
  EXPECT_EQ(tyn_bssrdf_pdf(handle.get(), radii.data(), radii.size(), pdf.data()), TYN_OK);
  return pdf;
}

std::vector<float> BssrdfModel::evaluate(const std::vector<TynBssrdfPath> &paths) const {
  std::vector<float> values(paths.size() * channel_count);
  EXPECT_EQ(tyn_bssrdf_evaluate(handle.get(), paths.data(), paths.size(), values.data()), TYN_OK);
  return values;
}

BssrdfSamples BssrdfModel::sample(uint64_t seed, uint64_t first, size_t count) const {
  BssrdfSamples samples{std::vector<float>(count), std::vector<float>(count),
                        std::vector<float>(count * channel_count)};
  EXPECT_EQ(tyn_bssrdf_sample(handle.get(), seed, first, count, samples.radii.data(), samples.pdf.data(),
                              samples.weights.data()),
            TYN_OK);
  return samples;
}

BssrdfModel half_space_model(uint32_t model, double albedo, double ior, double g, double sigma_t, uint32_t fit) {
  TynBssrdfOptions options = tyn_bssrdf_options();
  options.model = model;
  options.fit = fit;
  options.exact_events = few_events(ior);
  // sigma_a + sigma_s (1 - g) = sigma_t
  ExactSlab slab({{(1 - albedo) * sigma_t, albedo * sigma_t / (1 - g), g, ior, INFINITY}});
  return BssrdfModel(slab.view(), options);
}

BssrdfModel gaussian_model(size_t channels) {
  std::vector<double> weights, variances, sigma(channels, 1.0);
  for (size_t c = 0; c < channels; ++c) {
    weights.insert(weights.end(), {0.2, 0.3, 0.1});
    variances.insert(variances.end(), {0.01, 0.2, 4});
  }
  TynSlabLayer layer = tyn_slab_layer();
  layer.sigma_a = layer.sigma_s = sigma.data();
  TynSlab slab = tyn_slab();
  slab.channel_count = uint32_t(channels);
  slab.layer_count = 1;
  slab.layers = &layer;
  TynBssrdfOptions options = tyn_bssrdf_options();
  options.model = TYN_BSSRDF_GAUSSIANS;
  options.gaussian_count = 3;
  options.gaussian_weights = weights.data();
  options.gaussian_variances = variances.data();
  return BssrdfModel(slab, options);
}

std::vector<NamedModel> named_models() {
  std::vector<NamedModel> models;
  for (uint32_t model = 0; model < TYN_BSSRDF_MODEL_COUNT; ++model)
    models.push_back({tyn_bssrdf_model_name(model), model, TYN_NORMALIZED_SEARCHLIGHT});
  models.push_back({"normalized diffusion of diffuse light", TYN_BSSRDF_NORMALIZED_DIFFUSION, TYN_NORMALIZED_DIFFUSE});
  models.push_back(
      {"normalized diffusion by diffuse mean free path", TYN_BSSRDF_NORMALIZED_DIFFUSION, TYN_NORMALIZED_DMFP});
  return models;
}

BssrdfModel make_model(const NamedModel &named, double albedo, double ior) {
  return named.model == TYN_BSSRDF_GAUSSIANS ? gaussian_model()
                                             : half_space_model(named.model, albedo, ior, 0, 1, named.fit);
}

double plane_integral(const BssrdfModel &model, bool density, double length) {
  const tyn::Quadrature rule = tyn::gauss_legendre(8);
  std::vector<float> radii;
  std::vector<double> weights;
  const double step = density ? 0.002 : 0.02; // densities have steps
  for (double from = std::log(1e-7); from < std::log(1e6); from += step)
    for (size_t i = 0; i < rule.points.size(); ++i) {
      const double r = std::exp(from + step * rule.points[i]) * length;
      radii.push_back(float(r));
      weights.push_back(2 * 3.14159265358979 * r * r * step * rule.weights[i]);
    }
  const std::vector<float> values = density ? model.pdf(radii) : model.profile(radii);
  double sum = 0;
  for (size_t i = 0; i < radii.size(); ++i)
    sum += weights[i] * double(values[i]);
  return sum;
}

} // namespace tyn_test
