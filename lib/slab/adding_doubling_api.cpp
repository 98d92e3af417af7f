// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/context.hpp"
#include "core/input.hpp"
#include "slab/adding_doubling.hpp"
#include "slab/nodes.hpp"
#include "core/pi.hpp"
#include "tyndall/tyndall_exact.h"

namespace tyn {
namespace {

TynAddingDoublingOptions read_options(const TynAddingDoublingOptions *given, uint32_t channels) {
  TynAddingDoublingOptions options = tyn_adding_doubling_options();
  if (given)
    options = read_struct("TynAddingDoublingOptions", given, options);
  if (options.channel >= channels)
    fail(TYN_ERROR_INVALID_ARGUMENT, "channel is %u, but the slab has %u", options.channel, channels);
  require_choice("incidence", options.incidence, 2);
  if (!(options.angle >= 0 && options.angle < pi / 2))
    fail(TYN_ERROR_INVALID_ARGUMENT, "angle is %g; it must be in [0, pi/2)", options.angle);
  require_between("tolerance", options.tolerance, 1e-10, 0.1);
  if (options.max_nodes < 8 || options.max_nodes > 512)
    fail(TYN_ERROR_INVALID_ARGUMENT, "max_nodes is %u; it must be in 8 .. 512", options.max_nodes);
  if (options.cosine_count > 0)
    require_pointer("cosines", options.cosines);
  for (size_t i = 0; i < options.cosine_count; i++)
    if (!(options.cosines[i] > 0 && options.cosines[i] <= 1))
      fail(TYN_ERROR_INVALID_ARGUMENT, "cosines[%zu] is %g; it must be in (0, 1]", i, options.cosines[i]);
  return options;
}

// Node counts to try: at least two, which differ by a third or more in the nodes that are really used.
std::vector<unsigned> node_counts(const Slab &slab, unsigned most) {
  std::vector<unsigned> counts;
  unsigned used = 0;
  for (unsigned n : {16u, 24u, 32u, 48u, 64u, 96u, 128u, 192u, 256u, 384u, 512u}) {
    const unsigned uses = node_count(media_of(slab), n);
    if (n > most || 3 * uses < 4 * used)
      continue;
    counts.push_back(n);
    used = uses;
  }
  if (counts.size() < 2)
    return {most * 2 / 3, most};
  return counts;
}

struct Refined {
  Totals totals;
  double accuracy;
  unsigned count;
};

Refined refine(const Slab &slab, uint32_t channel, const Light &light, double tolerance, unsigned most) {
  const std::vector<unsigned> counts = node_counts(slab, most);
  Refined result{add_layers(slab, channel, light, counts[0], {}, nullptr), INFINITY, counts[0]};
  for (size_t i = 1; i < counts.size() && !(result.accuracy < tolerance); i++) {
    const Totals finer = add_layers(slab, channel, light, counts[i], {}, nullptr);
    const Totals &coarser = result.totals;
    const double change = std::max(std::abs(finer.reflectance - coarser.reflectance),
                                   std::abs(finer.transmittance - coarser.transmittance));
    result = {finer, change, counts[i]};
  }
  return result;
}

// Appends; light that a cut Legendre series makes negative is none.
void append(std::vector<double> &all, const std::vector<double> &piece) {
  for (double value : piece)
    all.push_back(std::max(value, 0.0));
}

// In pieces, as each cosine adds a row to every matrix.
AngularOutput angular_output(const Slab &slab, const Light &light, const TynAddingDoublingOptions &options,
                             unsigned count) {
  constexpr size_t piece = 64;
  AngularOutput all;
  for (size_t first = 0; first < options.cosine_count; first += piece) {
    const double *begin = options.cosines + first;
    const std::vector<double> cosines(begin, begin + std::min(piece, options.cosine_count - first));
    AngularOutput output;
    add_layers(slab, options.channel, light, count, cosines, &output);
    append(all.reflected, output.reflected);
    append(all.transmitted, output.transmitted);
  }
  return all;
}

double greatest_change(const std::vector<double> &a, const std::vector<double> &b) {
  double change = 0;
  for (size_t i = 0; i < a.size(); i++)
    change = std::max(change, std::abs(a[i] - b[i]));
  return change;
}

// Single directions need more nodes than totals do where the phase function is peaked.
AngularOutput refine_angular(const Slab &slab, const Light &light, const TynAddingDoublingOptions &options,
                             unsigned first) {
  AngularOutput result = angular_output(slab, light, options, first);
  for (unsigned count : node_counts(slab, options.max_nodes)) {
    if (count <= first)
      continue;
    AngularOutput finer = angular_output(slab, light, options, count);
    const double change = std::max(greatest_change(finer.reflected, result.reflected),
                                   greatest_change(finer.transmitted, result.transmitted));
    result = std::move(finer);
    if (change < 10 * options.tolerance)
      break;
  }
  return result;
}

double fraction(double value) { return std::min(std::max(value, 0.0), 1.0); }

TynAddingDoublingResult report(const Refined &refined, const Unscattered &direct) {
  TynAddingDoublingResult result;
  std::memset(&result, 0, sizeof result);
  result.reflectance = fraction(refined.totals.reflectance);
  result.transmittance = fraction(refined.totals.transmittance);
  result.absorbed = fraction(1 - refined.totals.reflectance - refined.totals.transmittance);
  result.specular_reflectance = direct.reflectance;
  result.direct_transmittance = direct.transmittance;
  result.accuracy = refined.accuracy;
  result.nodes = refined.totals.nodes;
  return result;
}

void solve(const TynSlab *given, const TynAddingDoublingOptions *given_options, TynAddingDoublingResult *result,
           double *reflected, double *transmitted) {
  const Slab slab = read_slab(given);
  const TynAddingDoublingOptions options = read_options(given_options, slab.channels);
  require_pointer("TynAddingDoublingResult", result);
  require_size("TynAddingDoublingResult", result->size, sizeof *result, sizeof *result);
  const Light light{options.incidence == TYN_INCIDENCE_DIFFUSE, std::cos(options.angle)};
  const Refined refined = refine(slab, options.channel, light, options.tolerance, options.max_nodes);
  AngularOutput output;
  if (reflected || transmitted)
    output = refine_angular(slab, light, options, refined.count);
  write_struct("TynAddingDoublingResult", result, report(refined, unscattered(slab, options.channel, light)));
  if (reflected)
    std::copy(output.reflected.begin(), output.reflected.end(), reflected);
  if (transmitted)
    std::copy(output.transmitted.begin(), output.transmitted.end(), transmitted);
}

} // namespace
} // namespace tyn

TynStatus tyn_adding_doubling(const TynSlab *slab, const TynAddingDoublingOptions *options,
                              TynAddingDoublingResult *result, double *reflected, double *transmitted, char *message,
                              size_t message_capacity) {
  const auto hand_out = [&](const char *text) {
    if (message && message_capacity > 0)
      std::snprintf(message, message_capacity, "%s", text);
  };
  hand_out("");
  return tyn::guarded(nullptr, [&] {
    try {
      tyn::solve(slab, options, result, reflected, transmitted);
    } catch (const std::bad_alloc &) {
      hand_out("out of host memory");
      throw;
    } catch (const std::exception &error) {
      hand_out(error.what());
      throw;
    }
  });
}
