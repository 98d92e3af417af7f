// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Radii drawn from BSSRDF models: they have the density that they are said to have, and their weights give the albedos.
#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "common/bssrdf_model.hpp"
#include "common/statistics.hpp"
#include "slab/gauss.hpp"

namespace {

using namespace tyn_test;

constexpr size_t COUNT = 1000000;

// The chance of a radius between two borders, by the density.
std::vector<double> chances(const BssrdfModel &model, const std::vector<double> &borders) {
  const tyn::Quadrature rule = tyn::gauss_legendre(16);
  constexpr int PARTS = 16;
  std::vector<float> radii;
  for (size_t i = 0; i + 1 < borders.size(); ++i)
    for (int part = 0; part < PARTS; ++part)
      for (double x : rule.points)
        radii.push_back(float(borders[i] * std::pow(borders[i + 1] / borders[i], (part + x) / PARTS)));
  const std::vector<float> pdf = model.pdf(radii);
  std::vector<double> result;
  size_t k = 0;
  for (size_t i = 0; i + 1 < borders.size(); ++i) {
    double sum = 0;
    for (int part = 0; part < PARTS; ++part)
      for (double weight : rule.weights) {
        const double r = double(radii[k]);
        sum += weight * 2 * 3.14159265358979 * r * r * double(pdf[k++]);
      }
    result.push_back(sum * std::log(borders[i + 1] / borders[i]) / PARTS);
  }
  return result;
}

// 120 bins from 1e-6 to 1e6 lengths, beyond which there is less than 1e-6 of the light. A right sampler fails once in 1e4 times.
void expect_density(const BssrdfModel &model, uint64_t seed) {
  std::vector<double> borders;
  for (int i = 0; i <= 120; ++i)
    borders.push_back(1e-6 * std::pow(10, 0.1 * i));
  std::vector<double> expected = chances(model, borders), observed(expected.size());
  for (double &chance : expected)
    chance *= COUNT;
  for (float r : model.sample(seed, 0, COUNT).radii) {
    const auto above = std::upper_bound(borders.begin(), borders.end(), double(r));
    if (above != borders.begin() && above != borders.end())
      ++observed[size_t(above - borders.begin()) - 1];
  }
  EXPECT_NEAR(std::accumulate(expected.begin(), expected.end(), 0.0), COUNT, 1e-3 * COUNT);
  EXPECT_NEAR(std::accumulate(observed.begin(), observed.end(), 0.0), COUNT, 1e-4 * COUNT);
  EXPECT_GT(chi_square_test(observed, expected), 1e-4);
}

class SamplesOf : public testing::TestWithParam<NamedModel> {};

TEST_P(SamplesOf, HaveTheirDensity) {
  for (double albedo : {0.4, 0.99})
    expect_density(make_model(GetParam(), albedo, 1.4), 5);
}

TEST_P(SamplesOf, HaveTheDensityThatIsAskedFor) {
  const BssrdfModel model = make_model(GetParam(), 0.9, 1.4);
  const BssrdfSamples samples = model.sample(7, 0, 10000);
  const std::vector<float> pdf = model.pdf(samples.radii), profile = model.profile(samples.radii);
  const double most = 1.5 * model.albedo()[0];
  for (size_t i = 0; i < samples.radii.size(); ++i) {
    EXPECT_EQ(samples.pdf[i], pdf[i]);
    EXPECT_NEAR(double(samples.weights[i]), double(profile[i]) / double(pdf[i]), 1e-6);
    EXPECT_LE(double(samples.weights[i]), most);
  }
}

INSTANTIATE_TEST_SUITE_P(EveryModel, SamplesOf, testing::ValuesIn(named_models()),
                         [](const auto &one) { return std::to_string(one.index); });

// Three channels of very different extent, one of them black: within 4 standard errors, exceeded once in 16 000 times.
TEST(SamplesOfChannels, WeighToTheirAlbedos) {
  const double sigma_a[] = {0.01, 0.5, 1, 0.2}, sigma_s[] = {1, 20, 0, 0.4};
  TynSlabLayer layer = tyn_slab_layer();
  layer.sigma_a = sigma_a;
  layer.sigma_s = sigma_s;
  layer.ior = 1.3;
  TynSlab slab = tyn_slab();
  slab.channel_count = 4;
  slab.layer_count = 1;
  slab.layers = &layer;
  for (uint32_t kind :
       {TYN_BSSRDF_STANDARD_DIPOLE, TYN_BSSRDF_PHOTON_BEAM_DIFFUSION, TYN_BSSRDF_NORMALIZED_DIFFUSION}) {
    TynBssrdfOptions options = tyn_bssrdf_options();
    options.model = kind;
    const BssrdfModel model(slab, options);
    const std::vector<double> albedo = model.albedo();
    const BssrdfSamples samples = model.sample(1, 1ull << 40, COUNT);
    double most = 0;
    for (double a : albedo)
      most += 1.5 * a;
    for (size_t c = 0; c < 4; ++c) {
      Mean mean;
      for (size_t i = 0; i < COUNT; ++i) {
        mean.add(double(samples.weights[c * COUNT + i]));
        ASSERT_LE(double(samples.weights[c * COUNT + i]), most);
      }
      EXPECT_NEAR(mean.mean(), albedo[c], four_sigma * mean.standard_error() + 1e-6) << kind << " " << c;
    }
    EXPECT_EQ(albedo[2], 0);
    expect_density(model, 9);
  }
}

} // namespace
