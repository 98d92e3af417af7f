// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Slabs of one channel, for tyn_adding_doubling and tyn_slab_simulate.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tyndall/tyndall_exact.h"

namespace tyn_test {

struct ExactLayer {
  double sigma_a, sigma_s, g, ior, thickness;
  const TynPhase *phase = nullptr;
};

class ExactSlab {
public:
  explicit ExactSlab(const std::vector<ExactLayer> &given, double above = 1, double below = 1) : source(given) {
    for (const ExactLayer &layer : source) {
      layers.push_back(tyn_slab_layer());
      layers.back().sigma_a = &layer.sigma_a;
      layers.back().sigma_s = &layer.sigma_s;
      layers.back().g = layer.g;
      layers.back().phase = layer.phase;
      layers.back().ior = layer.ior;
      layers.back().thickness = layer.thickness;
    }
    slab = tyn_slab();
    slab.layers = layers.data();
    slab.layer_count = static_cast<uint32_t>(layers.size());
    slab.ior_above = above;
    slab.ior_below = below;
    options = tyn_adding_doubling_options();
  }
  ExactSlab(const ExactSlab &) = delete;
  ExactSlab &operator=(const ExactSlab &) = delete;

  ExactSlab &tolerance(double value) {
    options.tolerance = value;
    return *this;
  }
  ExactSlab &angle(double value) {
    options.angle = value;
    return *this;
  }
  ExactSlab &diffuse() {
    options.incidence = TYN_INCIDENCE_DIFFUSE;
    return *this;
  }
  ExactSlab &cosines(const std::vector<double> &values) {
    directions = values;
    options.cosines = directions.data();
    options.cosine_count = directions.size();
    return *this;
  }

  TynAddingDoublingResult solve() {
    TynAddingDoublingResult result;
    result.size = sizeof result;
    reflected.assign(directions.size(), -1);
    transmitted.assign(directions.size(), -1);
    char message[256];
    const TynStatus status =
        tyn_adding_doubling(&slab, &options, &result, reflected.data(), transmitted.data(), message, sizeof message);
    EXPECT_EQ(status, TYN_OK) << message;
    return result;
  }

  const TynSlab &view() const { return slab; }

  TynAddingDoublingOptions options;
  std::vector<double> reflected, transmitted; // after solve()

private:
  std::vector<ExactLayer> source;
  std::vector<TynSlabLayer> layers;
  TynSlab slab;
  std::vector<double> directions;
};

// int_0^1 f(x) dx by the double exponential rule: singular ends do no harm.
template <class F>
double integral(F f) {
  double sum = 0;
  for (int i = -200; i <= 200; i++) {
    const double t = i * 0.02, e = M_PI * std::sinh(t);
    const double x = 1 / (1 + std::exp(-e));
    const double weight = M_PI * std::cosh(t) * x / (1 + std::exp(e));
    if (weight > 0 && x < 1)
      sum += weight * f(x);
  }
  return sum * 0.02;
}

} // namespace tyn_test
