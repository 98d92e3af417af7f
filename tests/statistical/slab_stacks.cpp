// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// 200 random stacks against adding-doubling: totals within 0.2 % or 3 standard errors. Of the 400 comparisons 1.1 are expected
// beyond 3 standard errors by chance; more than 6 would be seen once in 2000 times. None may be beyond 4.5 (once in 370 times
// for the 400 together).
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "common/slab_run.hpp"

namespace {

using namespace tyn_test;

constexpr int stacks = 200;
constexpr uint64_t photons = 100000;

class Stacks {
public:
  explicit Stacks(uint32_t seed) : random(seed) {}

  // Albedo 0.1 to 0.9999, g -0.8 to 0.95, ior 1 to 1.6, optical thickness 0.05 to 100 and infinite, 1 to 4 layers.
  std::vector<ExactLayer> next() {
    std::vector<ExactLayer> layers(static_cast<size_t>(1 + int(4 * uniform())));
    for (ExactLayer &layer : layers) {
      const double sigma_t = std::exp(uniform(std::log(0.1), std::log(50.0)));
      const double albedo = uniform() < 0.5 ? uniform(0.1, 0.99) : 1 - std::exp(uniform(std::log(1e-4), std::log(0.1)));
      layer.sigma_s = albedo * sigma_t;
      layer.sigma_a = sigma_t - layer.sigma_s;
      layer.g = uniform(-0.8, 0.95);
      layer.ior = uniform() < 0.3 ? 1 : uniform(1, 1.6);
      layer.thickness = std::exp(uniform(std::log(0.05), std::log(100.0))) / sigma_t;
      layer.phase = pick_phase();
    }
    if (uniform() < 0.3)
      layers.back().thickness = INFINITY;
    return layers;
  }
  double ior() { return uniform() < 0.5 ? 1 : uniform(1, 1.6); }
  double uniform(double low = 0, double high = 1) {
    return low + (high - low) * (double(random()) + 0.5) / 4294967296.0;
  }

private:
  const TynPhase *pick_phase() {
    const double u = uniform();
    return u < 0.1 ? &rayleigh : u < 0.2 ? &two_lobe : u < 0.3 ? &draine : u < 0.4 ? &table : nullptr;
  }

  static TynPhase make(uint32_t kind, double g, double g2, double weight, double alpha) {
    TynPhase phase = tyn_phase();
    phase.kind = kind;
    phase.g = g;
    phase.g2 = g2;
    phase.weight = weight;
    phase.alpha = alpha;
    return phase;
  }
  static TynPhase make_table() {
    static const double cosines[] = {-1, -0.5, 0.2, 0.8, 1}, values[] = {0.4, 0.1, 0.2, 0.9, 2.5};
    TynPhase phase = tyn_phase();
    phase.kind = TYN_PHASE_TABULATED;
    phase.cosines = cosines;
    phase.values = values;
    phase.count = 5;
    return phase;
  }

  std::mt19937 random;
  const TynPhase rayleigh = make(TYN_PHASE_RAYLEIGH, 0, 0, 1, 0);
  const TynPhase two_lobe = make(TYN_PHASE_TWO_LOBE, 0.8, -0.3, 0.9, 0);
  const TynPhase draine = make(TYN_PHASE_DRAINE, 0.6, 0, 1, 2);
  const TynPhase table = make_table();
};

std::string describe(const std::vector<ExactLayer> &layers) {
  std::string text;
  for (const ExactLayer &layer : layers)
    text += "[sigma_a " + std::to_string(layer.sigma_a) + " sigma_s " + std::to_string(layer.sigma_s) + " g " +
            std::to_string(layer.g) + " ior " + std::to_string(layer.ior) + " thickness " +
            std::to_string(layer.thickness) + (layer.phase ? " phase " + std::to_string(layer.phase->kind) : "") + "] ";
  return text;
}

TEST(RandomStacks, AgreeWithAddingDoubling) {
  Stacks stacks_of(7);
  int beyond_three = 0, compared = 0;
  double worst = 0, sum_of_squares = 0;
  for (int i = 0; i < stacks; ++i) {
    const std::vector<ExactLayer> layers = stacks_of.next();
    ExactSlab slab(layers, stacks_of.ior(), stacks_of.ior());
    TynSlabOptions options = slab_options(photons, uint64_t(i));
    slab.tolerance(1e-5);
    if (i % 3 == 1) {
      options.incidence = TYN_INCIDENCE_DIFFUSE;
      slab.diffuse();
    } else if (i % 3 == 2) {
      options.angle = stacks_of.uniform(0, 1.4);
      slab.angle(options.angle);
    }
    const TynAddingDoublingResult exact = slab.solve();
    ASSERT_LT(exact.accuracy, 1e-4) << describe(layers);
    const SlabOutcome outcome = simulate(slab.view(), options);
    const TynSlabTotals &totals = outcome.totals[0];
    EXPECT_NEAR(totals.reflectance.value + totals.transmittance.value + totals.absorbed.value, 1, 1e-6);
    const TynEstimate estimates[2] = {totals.reflectance, totals.transmittance};
    const double expected[2] = {exact.reflectance, exact.transmittance};
    for (int side = 0; side < 2; ++side) {
      const double off = std::abs(estimates[side].value - expected[side]);
      // what fewer than a photon is expected of is seen or not
      const double error = std::max(estimates[side].standard_error, 1 / double(photons)) + exact.accuracy;
      const double z = off / error;
      ++compared;
      sum_of_squares += z * z;
      worst = std::max(worst, z);
      EXPECT_LT(z, 4.5) << "stack " << i << " side " << side << ": " << estimates[side].value << " +- " << error
                        << ", exact " << expected[side] << "; " << describe(layers);
      if (off > 0.002 * expected[side] && z > 3)
        ++beyond_three;
    }
  }
  EXPECT_LE(beyond_three, 6);
  // the mean of z^2 of a right program is at most 1; 1.3 is four standard errors above it
  EXPECT_LT(sum_of_squares / compared, 1.3);
  std::printf("%d comparisons: worst %.2f standard errors, mean square %.3f, beyond 3 and 0.2 %%: %d\n", compared,
              worst, sum_of_squares / compared, beyond_three);
}

} // namespace
