// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// BSSRDF models on the shared context, with what they give as vectors. A failure fails the test.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "common/exact_slab.hpp"
#include "tyndall/tyndall_bssrdf.h"

namespace tyn_test {

struct ReleaseBssrdf {
  void operator()(TynBssrdf *bssrdf) const { tyn_bssrdf_release(bssrdf); }
};

constexpr uint64_t FEW_EVENTS = 20000000; // of an exact table, where its precision does not matter
// Behind a boundary of a high index light stays inside for long, and few walks reach their ends.
constexpr uint64_t few_events(double ior) { return ior > 2 ? 5 * FEW_EVENTS : FEW_EVENTS; }

struct BssrdfSamples {
  std::vector<float> radii, pdf, weights; // weights: channel by channel
};

class BssrdfModel {
public:
  BssrdfModel(const TynSlab &slab, const TynBssrdfOptions &options, TynContext *context = nullptr);

  size_t channels() const { return channel_count; }
  std::vector<double> albedo() const;
  std::vector<float> profile(const std::vector<float> &radii) const;
  std::vector<float> profile_error(const std::vector<float> &radii) const;
  std::vector<float> pdf(const std::vector<float> &radii) const;
  std::vector<float> evaluate(const std::vector<TynBssrdfPath> &paths) const;
  BssrdfSamples sample(uint64_t seed, uint64_t first, size_t count) const;
  TynBssrdf *get() const { return handle.get(); }

private:
  std::unique_ptr<TynBssrdf, ReleaseBssrdf> handle;
  size_t channel_count;
};

// A half-space of one channel with similarity-reduced albedo `albedo` and extinction 1 (or `sigma_t`).
BssrdfModel half_space_model(uint32_t model, double albedo, double ior = 1, double g = 0, double sigma_t = 1,
                             uint32_t fit = TYN_NORMALIZED_SEARCHLIGHT);

// Gaussians of weights 0.2, 0.3, 0.1 and variances 0.01, 0.2, 4 in every one of `channels` channels.
BssrdfModel gaussian_model(size_t channels = 1);

// All that need no options, and Gaussians; half-spaces.
struct NamedModel {
  std::string name;
  uint32_t model, fit;
};
std::vector<NamedModel> named_models();
BssrdfModel make_model(const NamedModel &named, double albedo, double ior);

// int 2 pi r f(r) dr by Gauss-Legendre over ln r, of one channel; r from 1e-7 to 1e6 times `length`.
double plane_integral(const BssrdfModel &model, bool density, double length = 1);

} // namespace tyn_test
