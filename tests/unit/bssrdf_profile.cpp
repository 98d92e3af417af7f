// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Profiles on the device against the same shapes in double on the host, at every lane width.
#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include "bssrdf/bssrdf.hpp"
#include "common/bssrdf_model.hpp"
#include "common/walk_scene.hpp"
#include "tyndall/tyndall_cl.h"

namespace {

using namespace tyn_test;

// Radii over 16 decades.
std::vector<float> many_radii() {
  std::vector<float> radii;
  for (double x = 1e-8; x < 1e8; x *= 1.007)
    radii.push_back(float(x));
  return radii;
}

class ProfileOf : public testing::TestWithParam<NamedModel> {};

TEST_P(ProfileOf, IsThatOfTheHost) {
  const std::vector<float> radii = many_radii();
  for (double albedo : {0.1, 0.9, 0.9999}) {
    const BssrdfModel model = make_model(GetParam(), albedo, 1.4);
    const tyn::Profile &profile = model.get()->profiles[0];
    const std::vector<float> values = model.profile(radii);
    for (size_t i = 0; i < radii.size(); ++i) {
      const double x = double(radii[i]) / profile.length;
      const double expected = tyn::profile_value(profile, x) / (profile.length * profile.length);
      // an exponent of -y costs y ulps; below 1e-30 a float has fewer digits
      const double decay = std::log(1e40 * tyn::profile_value(profile, 1e-3) / std::max(1e40 * expected, 1.0));
      EXPECT_NEAR(double(values[i]), expected, 1e-6 * expected * (4 + std::max(decay, 0.0)) + 1e-32)
          << "at " << radii[i];
    }
  }
}

// A batch in parts, at any lane width, to the last bit.
TEST_P(ProfileOf, DependsNeitherOnLanesNorOnBatches) {
  const std::vector<float> radii = many_radii();
  const BssrdfModel model = make_model(GetParam(), 0.9, 1.4);
  const std::vector<float> values = model.profile(radii);
  const BssrdfSamples samples = model.sample(3, 0, 1000);
  const std::vector<float> part(radii.begin() + 17, radii.begin() + 60);
  EXPECT_EQ(std::memcmp(model.profile(part).data(), &values[17], part.size() * sizeof(float)), 0);
  const BssrdfSamples later = model.sample(3, 501, 100);
  EXPECT_EQ(std::memcmp(later.radii.data(), &samples.radii[501], 100 * sizeof(float)), 0);
  for (uint32_t lanes : {1u, 4u, 8u}) {
    ContextHandle context = make_context(lanes);
    ExactSlab slab({{0.1, 0.9, 0, 1.4, INFINITY}});
    TynBssrdfOptions options = tyn_bssrdf_options();
    options.model = GetParam().model;
    options.fit = GetParam().fit;
    options.exact_events = FEW_EVENTS;
    const double weights[] = {0.2, 0.3, 0.1}, variances[] = {0.01, 0.2, 4};
    options.gaussian_count = 3;
    options.gaussian_weights = weights;
    options.gaussian_variances = variances;
    const BssrdfModel other(slab.view(), options, context.get());
    EXPECT_EQ(std::memcmp(other.profile(radii).data(), values.data(), values.size() * sizeof(float)), 0) << lanes;
    const BssrdfSamples same = other.sample(3, 0, 1000);
    EXPECT_EQ(std::memcmp(same.radii.data(), samples.radii.data(), 1000 * sizeof(float)), 0) << lanes;
    EXPECT_EQ(std::memcmp(same.weights.data(), samples.weights.data(), 1000 * sizeof(float)), 0) << lanes;
  }
}

INSTANTIATE_TEST_SUITE_P(EveryModel, ProfileOf, testing::ValuesIn(named_models()),
                         [](const auto &one) { return std::to_string(one.index); });

// The calls on buffers give what those on host pointers give, also where the latter need several batches.
TEST(ProfileBuffers, GiveWhatHostPointersGive) {
  constexpr size_t COUNT = 1200000; // more than a batch
  TynContext &context = *shared_context();
  const BssrdfModel model = make_model(named_models()[1], 0.9, 1.4);
  auto *bssrdf = const_cast<TynBssrdf *>(model.get());
  const BssrdfSamples samples = model.sample(2, 0, COUNT);
  tyn::Buffer radii(context, COUNT * sizeof(float)), values(context, COUNT * sizeof(float));
  tyn::Buffer weights(context, COUNT * sizeof(float));
  std::vector<float> read(COUNT);
  auto same = [&](const tyn::Buffer &buffer, const std::vector<float> &expected) {
    context.read(buffer, read.data(), COUNT * sizeof(float));
    return std::memcmp(read.data(), expected.data(), COUNT * sizeof(float)) == 0;
  };
  ASSERT_EQ(tyn_bssrdf_sample_cl(bssrdf, 2, 0, COUNT, radii.get(), values.get(), weights.get()), TYN_OK);
  EXPECT_TRUE(same(radii, samples.radii));
  EXPECT_TRUE(same(values, samples.pdf));
  EXPECT_TRUE(same(weights, samples.weights));
  ASSERT_EQ(tyn_bssrdf_profile_cl(bssrdf, radii.get(), COUNT, values.get()), TYN_OK);
  EXPECT_TRUE(same(values, model.profile(samples.radii)));
  ASSERT_EQ(tyn_bssrdf_pdf_cl(bssrdf, radii.get(), COUNT, values.get()), TYN_OK);
  EXPECT_TRUE(same(values, samples.pdf));
  EXPECT_EQ(tyn_bssrdf_pdf_cl(bssrdf, radii.get(), COUNT + 1, values.get()), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_bssrdf_profile_cl(bssrdf, nullptr, 1, values.get()), TYN_ERROR_INVALID_ARGUMENT);
}

TEST(Sampler, HasBordersWithFiveBitsOfMantissa) {
  EXPECT_EQ(tyn::sampler_border(0), 0);
  EXPECT_EQ(tyn::sampler_border(1), std::ldexp(1.0, -12));
  EXPECT_EQ(tyn::sampler_border(TYN_SAMPLER_CELLS - 1), std::ldexp(1.0, 12));
  for (uint32_t k = 1; k < TYN_SAMPLER_CELLS; ++k) {
    uint32_t bits;
    const float border = float(tyn::sampler_border(k));
    std::memcpy(&bits, &border, sizeof bits);
    EXPECT_EQ(bits, (k + TYN_SAMPLER_FIRST - 1) << TYN_SAMPLER_SHIFT);
  }
}

} // namespace
