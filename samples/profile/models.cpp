// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "profile/models.hpp"

#include "common/call_progress.hpp"
#include "common/tool.hpp"
#include "slab/messages.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <memory>

namespace profile {
namespace {

using Bssrdf = std::unique_ptr<TynBssrdf, tool::Releaser<TynBssrdf, tyn_bssrdf_release>>;

// Gauss and Legendre's points in (0, 1) and their weights.
constexpr double kPoints[] = {0.019855071751231884, 0.10166676129318664, 0.23723379504183550, 0.40828267875217510,
                              0.59171732124782490,  0.76276620495816450, 0.89833323870681336, 0.98014492824876812};
constexpr double kWeights[] = {0.050614268145188130, 0.11119051722668724, 0.15685332293894364, 0.18134189168918100,
                               0.18134189168918100,  0.15685332293894364, 0.11119051722668724, 0.050614268145188130};
constexpr double kStep = 1.2;      // ratio of the ends of a piece that these points do for
constexpr size_t kMostPieces = 64; // of a ring

// Whether the tool fails if the model does not take the layers. Those that --model all stands for need not, but for the only
// one that takes several.
bool is_needed(const Arguments &arguments, uint32_t model) {
  return !arguments.all_models || arguments.models.size() == 1 ||
         (arguments.fit_given && model == TYN_BSSRDF_NORMALIZED_DIFFUSION) ||
         (arguments.layers.size() > 1 && model == TYN_BSSRDF_MULTIPOLE);
}

// A model or, if it does not take the layers, why; neither if Ctrl-C came.
struct Created {
  Bssrdf bssrdf;
  std::string refusal;
};

Created create(const char *tool_name, TynContext *context, const TynSlab &slab, const Arguments &arguments,
               uint32_t model) {
  std::vector<double> weights, variances;
  for (size_t c = 0; c < arguments.channels(); ++c) {
    weights.insert(weights.end(), arguments.gaussian_weights.begin(), arguments.gaussian_weights.end());
    variances.insert(variances.end(), arguments.gaussian_variances.begin(), arguments.gaussian_variances.end());
  }
  TynBssrdfOptions options = tyn_bssrdf_options();
  options.model = model;
  options.fit = arguments.fit;
  options.transmitted = arguments.transmitted;
  options.gaussian_count = static_cast<uint32_t>(arguments.gaussian_weights.size());
  options.gaussian_weights = weights.data();
  options.gaussian_variances = variances.data();
  TynBssrdf *bssrdf = nullptr;
  TynStatus status = TYN_OK;
  {
    tool::CallProgress progress(tool_name, arguments.quiet, "table of exact"); // the only model that makes one
    options.progress = &tool::CallProgress::report;
    options.user = &progress;
    status = tyn_bssrdf_create(context, &slab, &options, &bssrdf);
  }
  if (status == TYN_ERROR_CANCELLED)
    return {};
  if (status == TYN_ERROR_INVALID_ARGUMENT)
    return {nullptr, slab::in_options(tyn_context_message(context), arguments)};
  tool::check(status, context);
  return {Bssrdf(bssrdf), ""};
}

struct Refusal {
  std::string model, reason;
};

using Evaluation = decltype(&tyn_bssrdf_profile);

// What `evaluate` gives: [channel][radius].
std::vector<std::vector<double>> evaluate_at(Evaluation evaluate, TynContext *context, TynBssrdf *bssrdf,
                                             const std::vector<double> &radii, size_t channels) {
  const std::vector<float> rounded(radii.begin(), radii.end());
  std::vector<float> values(channels * radii.size());
  tool::check(evaluate(bssrdf, rounded.data(), rounded.size(), values.data()), context);
  std::vector<std::vector<double>> result;
  for (size_t c = 0; c < channels; ++c)
    result.emplace_back(values.begin() + c * radii.size(), values.begin() + (c + 1) * radii.size());
  return result;
}

// Radii at which a ring's mean is looked at, and what each counts for: the piece's area, 2 r dr, over the ring's.
struct Quadrature {
  std::vector<double> radii, weights;
  std::vector<size_t> ends; // of each ring's
};

void add_ring(double inner, double outer, Quadrature &quadrature) {
  const double ratio = inner > 0.0 ? outer / inner : std::pow(kStep, kMostPieces);
  const auto pieces =
      static_cast<size_t>(std::clamp(std::ceil(std::log(ratio) / std::log(kStep)), 1.0, double(kMostPieces)));
  const double step = std::pow(ratio, 1.0 / static_cast<double>(pieces));
  double upper = outer;
  for (size_t piece = 0; piece < pieces; ++piece) {
    const double lower = piece + 1 == pieces ? inner : upper / step;
    for (size_t i = 0; i < std::size(kPoints); ++i) {
      const double radius = lower + kPoints[i] * (upper - lower);
      quadrature.radii.push_back(radius);
      quadrature.weights.push_back(kWeights[i] * (upper - lower) * 2.0 * radius / (outer - inner) / (outer + inner));
    }
    upper = lower;
  }
}

Quadrature quadrature_of(const Rings &rings) {
  Quadrature quadrature;
  for (size_t i = 0; i < rings.count(); ++i) {
    if (!rings.empty(i))
      add_ring(rings.edge(i), rings.edge(i + 1), quadrature);
    quadrature.ends.push_back(quadrature.radii.size());
  }
  return quadrature;
}

std::vector<double> means(const Quadrature &quadrature, const std::vector<double> &values) {
  std::vector<double> result;
  size_t i = 0;
  for (const size_t end : quadrature.ends) {
    double sum = i == end ? NAN : 0.0;
    for (; i < end; ++i)
      sum += quadrature.weights[i] * values[i];
    result.push_back(sum);
  }
  return result;
}

ModelResults evaluate(TynContext *context, TynBssrdf *bssrdf, const Arguments &arguments,
                      const Quadrature &quadrature) {
  const size_t channels = arguments.channels();
  ModelResults results;
  results.profile = evaluate_at(tyn_bssrdf_profile, context, bssrdf, arguments.radii, channels);
  results.errors = evaluate_at(tyn_bssrdf_profile_error, context, bssrdf, arguments.radii, channels);
  results.albedo.resize(channels);
  tool::check(tyn_bssrdf_albedo(bssrdf, results.albedo.data(), channels), context);
  if (quadrature.radii.empty())
    return results;
  const auto values = evaluate_at(tyn_bssrdf_profile, context, bssrdf, quadrature.radii, channels);
  const auto errors = evaluate_at(tyn_bssrdf_profile_error, context, bssrdf, quadrature.radii, channels);
  for (size_t c = 0; c < channels; ++c) // a table's errors at neighbouring radii go together
    results.ring_means.push_back({means(quadrature, values[c]), means(quadrature, errors[c])});
  return results;
}

} // namespace

void evaluate_models(const char *tool_name, TynContext *context, const TynSlab &slab, const Arguments &arguments,
                     const Rings *rings, Results &results) {
  const Quadrature quadrature = rings ? quadrature_of(*rings) : Quadrature();
  std::vector<Refusal> refusals;
  for (const uint32_t model : arguments.models) {
    const std::string name = tyn_bssrdf_model_name(model);
    const Created created = create(tool_name, context, slab, arguments, model);
    if (created.bssrdf) {
      results.models.push_back(evaluate(context, created.bssrdf.get(), arguments, quadrature));
      results.models.back().name = name;
    } else if (created.refusal.empty()) {
      results.missing.push_back(name);
    } else if (is_needed(arguments, model)) {
      throw tool::Error(tool::kUsage, "--model " + name + ": " + created.refusal);
    } else {
      refusals.push_back({name, created.refusal});
    }
  }
  results.interrupted = tool::interrupted();
  if (results.models.empty() && results.missing.empty())
    throw tool::Error(tool::kUsage, "no model takes this: " + refusals.front().model + ": " + refusals.front().reason);
  for (const Refusal &refusal : refusals)
    if (!arguments.quiet)
      std::fprintf(stderr, "%s: %s is left out: %s\n", tool_name, refusal.model.c_str(), refusal.reason.c_str());
}

} // namespace profile
