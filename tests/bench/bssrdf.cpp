// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// BSSRDF models in bulk, on the device's own buffers: profile values, samples and paths' S a second, of one channel, beside a
// plain scalar loop in C++ over the same shapes on one core (for the dipole and the table), in turns, in one process.
#include <benchmark/benchmark.h>

#include <chrono>
#include <cmath>
#include <string>
#include <vector>

#include "bssrdf/bssrdf.hpp"
#include "common/bssrdf_model.hpp"
#include "common/bssrdf_paths.hpp"
#include "tyndall/tyndall_cl.h"

namespace {

using namespace tyn_test;
using Clock = std::chrono::steady_clock;

constexpr size_t COUNT = size_t(1) << 22, PLAIN_COUNT = size_t(1) << 18;
constexpr size_t PATH_COUNT = size_t(1) << 20;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

// The shapes of kernels/bssrdf_profile.clh in single precision, written plainly.
float plain_value(const tyn::Profile &p, const std::vector<float> &terms, float x) {
  const float falloff = float(p.falloff);
  float sum = 0;
  if (p.kind == TYN_PROFILE_PAIRS) {
    for (uint32_t i = 0; i < p.count; ++i) {
      const float z_r = terms[3 * i], z_v = terms[3 * i + 1];
      const float d_r = std::sqrt(x * x + z_r * z_r), d_v = std::sqrt(x * x + z_v * z_v);
      const float e_r = std::exp(-falloff * d_r), e_v = std::exp(-falloff * d_v);
      sum += float(p.flux) * (z_r * (1 + falloff * d_r) * e_r / (d_r * d_r * d_r) -
                              z_v * (1 + falloff * d_v) * e_v / (d_v * d_v * d_v)) +
             float(p.fluence) * (e_r / d_r - e_v / d_v);
    }
  } else if (p.kind == TYN_PROFILE_GAUSSIANS) {
    for (uint32_t i = 0; i < p.count; ++i)
      sum += terms[2 * i] * std::exp(-terms[2 * i + 1] * x * x);
  } else if (p.kind == TYN_PROFILE_EXPONENTIALS) {
    sum = float(p.flux) * (std::exp(-x) + std::exp(x * (-1.0f / 3))) / x;
  } else { // linear in ln x
    const float at = (std::log2(x) + 12) * (float(p.count - 1) / 24);
    const uint32_t k = uint32_t(std::min(std::max(at, 0.0f), float(p.count - 2)));
    sum = float(p.flux) * std::exp(terms[2 * k] + (at - float(k)) * (terms[2 * k + 2] - terms[2 * k]));
  }
  return sum;
}

class Bench {
public:
  explicit Bench(const NamedModel &named)
      : model(make_model(named, 0.95, 1.4)), bssrdf(const_cast<TynBssrdf *>(model.get())), context(bssrdf->context),
        radii(context, COUNT * sizeof(float)), values(context, COUNT * sizeof(float)),
        weights(context, COUNT * sizeof(float)), paths(context, PATH_COUNT * sizeof(TynBssrdfPath)),
        terms(bssrdf->profiles[0].terms.begin(), bssrdf->profiles[0].terms.end()) {
    host_radii = model.sample(1, 0, COUNT).radii; // as they are where models are used
    context.write(radii, host_radii.data(), radii.size());
    context.write(paths, random_paths(PATH_COUNT, 1, 0.01, 10).data(), paths.size());
    evaluate();
    evaluate_paths();
    sample();
  }

  double evaluate() {
    const Clock::time_point start = Clock::now();
    tyn_bssrdf_profile_cl(bssrdf, radii.get(), COUNT, values.get());
    context.finish();
    return COUNT / seconds_since(start);
  }

  double evaluate_paths() {
    const Clock::time_point start = Clock::now();
    tyn_bssrdf_evaluate_cl(bssrdf, paths.get(), PATH_COUNT, values.get());
    context.finish();
    return PATH_COUNT / seconds_since(start);
  }

  double sample() {
    const Clock::time_point start = Clock::now();
    tyn_bssrdf_sample_cl(bssrdf, 1, 0, COUNT, weights.get(), values.get(), nullptr);
    context.finish();
    return COUNT / seconds_since(start);
  }

  double evaluate_plainly() {
    const tyn::Profile &profile = bssrdf->profiles[0];
    const float per_length = float(1 / profile.length);
    const Clock::time_point start = Clock::now();
    float sum = 0;
    for (size_t i = 0; i < PLAIN_COUNT; ++i)
      sum += plain_value(profile, terms, host_radii[i] * per_length);
    const double seconds = seconds_since(start);
    benchmark::DoNotOptimize(sum);
    return PLAIN_COUNT / seconds;
  }

private:
  BssrdfModel model;
  TynBssrdf *bssrdf;
  TynContext &context;
  tyn::Buffer radii, values, weights, paths;
  std::vector<float> host_radii, terms;
};

void compare(benchmark::State &state, const NamedModel &named) {
  Bench bench(named);
  double values = 0, paths = 0, samples = 0, plain = 0;
  for (auto _ : state) {
    values = std::max(values, bench.evaluate());
    paths = std::max(paths, bench.evaluate_paths());
    samples = std::max(samples, bench.sample());
    plain = std::max(plain, bench.evaluate_plainly());
  }
  state.counters["values/s"] = values;
  state.counters["paths/s"] = paths;
  state.counters["samples/s"] = samples;
  state.counters["plain/s"] = plain;
  state.counters["ratio"] = values / plain;
}

} // namespace

int main(int argc, char **argv) {
  for (const NamedModel &named : named_models())
    benchmark::RegisterBenchmark(named.name.c_str(), compare, named)->Iterations(10)->Unit(benchmark::kMillisecond);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
