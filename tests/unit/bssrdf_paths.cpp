// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// S in bulk: at every lane width, in parts, on buffers, channel by channel.
#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include "bssrdf/bssrdf.hpp"
#include "common/bssrdf_model.hpp"
#include "common/bssrdf_paths.hpp"
#include "common/walk_scene.hpp"
#include "tyndall/tyndall_cl.h"

namespace {

using namespace tyn_test;

bool same(const float *a, const float *b, size_t count) { return std::memcmp(a, b, count * sizeof(float)) == 0; }

class PathsOf : public testing::TestWithParam<NamedModel> {};

// A batch in parts, at any lane width, to the last bit.
TEST_P(PathsOf, DependNeitherOnLanesNorOnBatches) {
  const std::vector<TynBssrdfPath> paths = random_paths(999, 3, 1e-5, 20);
  const BssrdfModel model = make_model(GetParam(), 0.9, 1.4);
  const std::vector<float> values = model.evaluate(paths);
  const std::vector<TynBssrdfPath> part(paths.begin() + 17, paths.begin() + 60);
  EXPECT_TRUE(same(model.evaluate(part).data(), &values[17], part.size()));
  if (GetParam().model == TYN_BSSRDF_GAUSSIANS)
    return; // as the profile's own test has it
  for (uint32_t lanes : {1u, 4u, 8u, 16u}) {
    ContextHandle context = make_context(lanes);
    ExactSlab slab({{0.1, 0.9, 0, 1.4, INFINITY}});
    TynBssrdfOptions options = tyn_bssrdf_options();
    options.model = GetParam().model;
    options.exact_events = FEW_EVENTS;
    options.fit = GetParam().fit;
    const BssrdfModel other(slab.view(), options, context.get());
    EXPECT_TRUE(same(other.evaluate(paths).data(), values.data(), values.size())) << lanes;
  }
}

INSTANTIATE_TEST_SUITE_P(EveryModel, PathsOf, testing::ValuesIn(named_models()),
                         [](const auto &one) { return std::to_string(one.index); });

// Also where host pointers need several batches.
TEST(PathBuffers, GiveWhatHostPointersGive) {
  constexpr size_t COUNT = 120000;
  TynContext &context = *shared_context();
  const BssrdfModel model = half_space_model(TYN_BSSRDF_DIRECTIONAL_DIPOLE, 0.9, 1.3);
  auto *bssrdf = const_cast<TynBssrdf *>(model.get());
  const std::vector<TynBssrdfPath> paths = random_paths(COUNT, 5, 1e-2, 20);
  const std::vector<float> expected = model.evaluate(paths);
  tyn::Buffer in(context, COUNT * sizeof(TynBssrdfPath)), out(context, COUNT * sizeof(float));
  context.write(in, paths.data(), in.size());
  ASSERT_EQ(tyn_bssrdf_evaluate_cl(bssrdf, in.get(), COUNT, out.get()), TYN_OK);
  std::vector<float> read(COUNT);
  context.read(out, read.data(), out.size());
  EXPECT_TRUE(same(read.data(), expected.data(), COUNT));
  EXPECT_EQ(tyn_bssrdf_evaluate_cl(bssrdf, in.get(), COUNT + 1, out.get()), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_bssrdf_evaluate_cl(bssrdf, nullptr, 1, out.get()), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_bssrdf_evaluate_cl(bssrdf, in.get(), 1, nullptr), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_bssrdf_evaluate_cl(nullptr, in.get(), 1, out.get()), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_bssrdf_evaluate_cl(bssrdf, nullptr, 0, nullptr), TYN_OK);
}

// Whatever is in a buffer, nothing but numbers comes out.
TEST(PathBuffers, MayHoldAnything) {
  TynContext &context = *shared_context();
  std::vector<TynBssrdfPath> paths = random_paths(18 * 4, 8, 1e-2, 20);
  const float odd[4] = {NAN, INFINITY, 3e38f, 0};
  for (size_t i = 0; i < paths.size(); ++i)
    reinterpret_cast<float *>(&paths[i])[i / 4] = odd[i % 4];
  tyn::Buffer in(context, paths.size() * sizeof(TynBssrdfPath)), out(context, paths.size() * sizeof(float));
  context.write(in, paths.data(), in.size());
  for (uint32_t kind : {TYN_BSSRDF_BETTER_DIPOLE, TYN_BSSRDF_SINGLE_SCATTERING, TYN_BSSRDF_DIRECTIONAL_DIPOLE}) {
    const BssrdfModel model = half_space_model(kind, 0.9, 1.3);
    ASSERT_EQ(tyn_bssrdf_evaluate_cl(const_cast<TynBssrdf *>(model.get()), in.get(), paths.size(), out.get()), TYN_OK);
    std::vector<float> read(paths.size(), NAN);
    context.read(out, read.data(), out.size());
    for (float value : read)
      EXPECT_TRUE(std::isfinite(value) && value >= 0) << kind;
  }
}

// Every channel has its own terms, stored channel by channel.
TEST(PathChannels, AreThoseOfModelsOfOneChannel) {
  const double sigma_a[] = {0.1, 1, 0}, sigma_s[] = {2, 0, 0.4};
  TynSlabLayer layer = tyn_slab_layer();
  layer.sigma_a = sigma_a;
  layer.sigma_s = sigma_s;
  layer.ior = 1.3;
  TynSlab slab = tyn_slab();
  slab.channel_count = 3;
  slab.layer_count = 1;
  slab.layers = &layer;
  const std::vector<TynBssrdfPath> paths = random_paths(500, 9, 1e-2, 20);
  for (uint32_t kind : {TYN_BSSRDF_STANDARD_DIPOLE, TYN_BSSRDF_QUANTIZED_DIFFUSION, TYN_BSSRDF_DIRECTIONAL_DIPOLE}) {
    TynBssrdfOptions options = tyn_bssrdf_options();
    options.model = kind;
    const std::vector<float> values = BssrdfModel(slab, options).evaluate(paths);
    for (size_t c = 0; c < 3; ++c) {
      ExactSlab one({{sigma_a[c], sigma_s[c], 0, 1.3, INFINITY}});
      EXPECT_TRUE(same(&values[c * 500], BssrdfModel(one.view(), options).evaluate(paths).data(), 500)) << kind << c;
    }
    for (size_t i = 500; i < 1000; ++i)
      EXPECT_EQ(values[i], 0); // black
    EXPECT_GT(values[0] + values[1], 0);
  }
}

// Lengths are the caller's: scaling by a power of two changes exponents only.
TEST(PathLengths, AreTheCallers) {
  const float scale = 0x1p-15f;
  std::vector<TynBssrdfPath> paths = random_paths(500, 10, 1e-2, 10), small = paths;
  for (TynBssrdfPath &path : small)
    for (int k = 0; k < 3; ++k)
      path.entry_position[k] *= scale, path.exit_position[k] *= scale;
  for (uint32_t kind : {TYN_BSSRDF_STANDARD_DIPOLE, TYN_BSSRDF_DIRECTIONAL_DIPOLE}) {
    const std::vector<float> of_large = half_space_model(kind, 0.75, 1.3, 0.5, 1).evaluate(paths);
    const std::vector<float> of_small = half_space_model(kind, 0.75, 1.3, 0.5, 0x1p15).evaluate(small);
    for (size_t i = 0; i < paths.size(); ++i)
      ASSERT_EQ(of_large[i], of_small[i] * scale * scale);
  }
}

} // namespace
