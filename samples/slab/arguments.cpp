// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "slab/arguments.hpp"

#include "common/help.hpp"
#include "slab/files.hpp"
#include "slab/layer_options.hpp"
#include "slab/parse.hpp"

#include <algorithm>

namespace slab {
namespace {

using tool::Error;
using tool::kUsage;

constexpr uint64_t kMostPhotons = 1000000000000000;
constexpr uint64_t kMostOrders = 999999;
constexpr uint64_t kMostValues = uint64_t(1) << 22; // of R(r, angle) and T(r, angle) together

const char *const kAbout =
    R"(Light in layered slabs and half-spaces, by Monte Carlo, with standard errors: what is reflected,
transmitted and absorbed, and where.

  tyndall-slab --sigma-a A --sigma-s S [--g G] [--ior N] [--thickness D] [options]
  tyndall-slab --layer A,S,G,N,D [--layer ...] [options]
  tyndall-slab --medium NAME [--thickness D] [options]

Examples:
  tyndall-slab --sigma-a 1 --sigma-s 9 --g 0.75 --thickness 0.2
      one layer: total reflectance and transmittance
  tyndall-slab --medium skin1 --radial 10:100 --plot skin.png
      measured skin in red, green and blue: reflectance over the distance from the beam
  tyndall-slab --layer 0.1,10,0.9,1.37,1 --layer 0.1,1,0,1.37,1 --layer 0.2,1,0.7,1.37,2 --depth 4:200 --csv a.csv
      three layers: absorption and fluence over the depth, as a table
  tyndall-slab --sigma-a 0.01 --sigma-s 1 --thickness 5 --sweep-albedo 0.5:1:26 --target-error 1e-4 --json
      one run for 26 albedos, until the standard errors are below 0.0001
  tyndall-slab --sigma-a 0.5 --sigma-s 0.5 --thickness 1 --ior 1.5 --exact
      beside the exact solution

Units: any one unit of length, by convention mm; coefficients in its inverse. R(r) is in 1/mm^2, angles
are in degrees from the normal. --unit cm only changes the name of the unit. Lists give one value a
spectral channel: --sigma-a 0.03,0.17,0.48. Light comes from above. Ctrl-C ends the run and writes
what is done; pressed again it kills.
Exit status: 0 done, 1 failed, 2 wrong usage, 3 an output file cannot be written, 4 no device or kernel
build failed, 130 interrupted (the outputs are written).
)";

// Options as text: numbers are read here, not by CLI11, so that 1e7 photons and inf mean what they say.
struct Text {
  LayerText layers;
  std::string ior_above, ior_below, incidence = "normal", beam = "pencil";
  std::string photons, target_error, time_limit, seed, max_order;
  std::string radial, angular, depth, orders, path, sweep;
  bool radial_angular = false;
};

void add_light_options(CLI::App &app, Text &text) {
  app.add_option("--ior-above", text.ior_above, "refractive index above the slab, 1 to 4 (1)")->type_name("N");
  app.add_option("--ior-below", text.ior_below, "refractive index below the slab, 1 to 4 (1)")->type_name("N");
  app.add_option("--incidence", text.incidence, "normal, angle:DEGREES or diffuse (normal)")->type_name("KIND");
  app.add_option("--beam", text.beam, "pencil, disc:RADIUS or gaussian:RADIUS, where the\nradius is at 1/e^2 (pencil)")
      ->type_name("KIND");
}

void add_run_options(CLI::App &app, Text &text) {
  app.add_option("--photons", text.photons,
                 "photons a channel, such as 1e7 (1e6, or without limit\nif one of the next two is given)")
      ->type_name("N");
  app.add_option("--target-error", text.target_error, "stop when total R and T have this standard error")
      ->type_name("ERROR");
  app.add_option("--time-limit", text.time_limit, "stop after this time; 0: no limit")->type_name("SECONDS");
  app.add_option("--seed", text.seed, "same seed, same bits on the same device (0)")->type_name("N");
  app.add_option("--max-order", text.max_order, "scatter at most so often; 1: single scattering")->type_name("N");
}

void add_result_options(CLI::App &app, Text &text, Arguments &arguments) {
  app.add_option("--radial", text.radial, "R and T over the radius, 0 to RMAX")->type_name("RMAX::BINS");
  app.add_option("--angular", text.angular, "R and T over the angle from the normal")->type_name("BINS");
  app.add_flag("--radial-angular", text.radial_angular, "R and T over both (--json and --csv)");
  app.add_option("--depth", text.depth, "absorption and fluence over the depth, 0 to ZMAX")->type_name("ZMAX::BINS");
  app.add_option("--orders", text.orders, "R and T after 0 to N scattering events")->type_name("N");
  app.add_option("--path", text.path, "R and T over the path length inside, 0 to LMAX")->type_name("LMAX::BINS");
  app.add_option("--sweep-albedo", text.sweep,
                 "the same photons for other albedos in all layers, with\nthe extinction kept (one channel)")
      ->type_name("W,W,...|MIN::MAX::N");
  app.add_flag("--exact", arguments.exact, "also solve by adding-doubling, and compare the totals");
}

void add_output_options(CLI::App &app, Arguments &arguments) {
  app.add_flag("--json", arguments.json, "one JSON object on standard output, and nothing else");
  app.add_option("--csv", arguments.csv, "write all results as a table, one value a row")->type_name("FILE");
  app.add_option("--plot", arguments.plot, "draw the results")->type_name("FILE.png");
  app.add_option("--unit", arguments.unit, "name of the unit of length in --plot and --csv (mm)")->type_name("NAME");
  app.add_option("--device", arguments.device, "OpenCL device (TYNDALL_DEVICE, else 0; tyndall-info --devices)")
      ->type_name("INDEX|NAME");
  app.add_flag("-q,--quiet", arguments.quiet, "errors only");
}

void read_run(const Text &text, TynSlabOptions &options) {
  if (!text.target_error.empty())
    options.target_error =
        number_between("--target-error", text.target_error, 0.0, 1.0, "a standard error from 0 to 1");
  if (!text.time_limit.empty())
    options.seconds = number_between("--time-limit", text.time_limit, 0.0, 1e9, "seconds from 0 to 1e9");
  if (!text.photons.empty())
    options.photons = whole_number("--photons", text.photons, 1, kMostPhotons, "a whole number from 1 to 1e15");
  else if (options.target_error > 0.0 || options.seconds > 0.0)
    options.photons = 0;
  if (!text.seed.empty())
    options.seed = parse_seed(text.seed);
  if (!text.max_order.empty())
    options.max_order = static_cast<uint32_t>(
        whole_number("--max-order", text.max_order, 1, UINT32_MAX, "a whole number from 1 to 4294967295"));
}

void read_results(const Text &text, TynSlabOptions &options) {
  const auto axis = [](const char *option, const std::string &value, double &end, uint32_t &bins) {
    if (value.empty())
      return;
    const Axis parsed = parse_axis(option, value);
    end = parsed.end;
    bins = parsed.bins;
  };
  axis("--radial", text.radial, options.radial_max, options.radial_bins);
  axis("--depth", text.depth, options.depth_max, options.depth_bins);
  axis("--path", text.path, options.path_max, options.path_bins);
  if (!text.angular.empty())
    options.angular_bins = static_cast<uint32_t>(
        whole_number("--angular", text.angular, 1, 1000000, "a number of bins from 1 to 1000000"));
  if (!text.orders.empty())
    options.order_bins = 1 + static_cast<uint32_t>(whole_number("--orders", text.orders, 0, kMostOrders,
                                                                "the highest order, from 0 to 999999"));
  options.radial_angular = text.radial_angular;
}

void check_radial_angular(const Text &text, const TynSlabOptions &options) {
  if (!options.radial_angular)
    return;
  if (!options.radial_bins || !options.angular_bins)
    throw Error(kUsage, "--radial-angular: expected --radial and --angular beside it");
  if (2 * uint64_t(options.radial_bins) * options.angular_bins > kMostValues)
    throw Error(kUsage, "--radial-angular: " + text.radial + " by " + text.angular +
                            " are too many bins: expected at most 2097152 of both together");
}

void read_sweep(const std::string &text, Arguments &arguments) {
  if (text.empty())
    return;
  arguments.sweep = parse_albedos(text);
  const size_t channels = arguments.layers.front().sigma_a.size();
  if (channels > 1)
    throw Error(kUsage, "--sweep-albedo " + text + ": expected one channel, but there are " + std::to_string(channels));
}

// Walks in a half-space that absorbs nothing have no finite mean length.
void check_ends(const Arguments &arguments) {
  const LayerArgument &last = arguments.layers.back();
  if (!std::isinf(last.thickness))
    return;
  for (size_t c = 0; c < last.sigma_a.size(); ++c) {
    const double highest =
        arguments.sweep.empty() ? -1.0 : *std::max_element(arguments.sweep.begin(), arguments.sweep.end());
    if (last.sigma_a[c] + last.sigma_s[c] == 0.0)
      throw Error(kUsage, "the last layer is infinitely thick and empty: expected a --thickness, or its index as "
                          "--ior-below");
    const bool absorbs = highest < 0.0 ? last.sigma_a[c] > 0.0 : highest < 1.0;
    if (!absorbs && !arguments.options.max_order)
      throw Error(kUsage, highest < 0.0 ? "--sigma-a 0 in an infinitely thick layer: its walks would not end; expected "
                                          "absorption, a --thickness or --max-order"
                                        : "--sweep-albedo 1 in an infinitely thick layer: its walks would not end; "
                                          "expected less than 1, a --thickness or --max-order");
  }
}

void check_sums(const std::vector<LayerArgument> &layers) {
  for (const LayerArgument &layer : layers)
    for (size_t c = 0; c < layer.sigma_a.size(); ++c)
      if (layer.sigma_a[c] + layer.sigma_s[c] > 1e30)
        throw Error(kUsage, "--sigma-a and --sigma-s: expected a sum of at most 1e30");
}

void check_unit(const Arguments &arguments) {
  const std::string &unit = arguments.unit;
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  if (unit.empty() || unit.size() > 16 || !std::all_of(unit.begin(), unit.end(), is_letter))
    wrong("--unit", unit, "1 to 16 letters, such as cm");
  if (!arguments.medium.empty() && unit != "mm")
    throw Error(kUsage, "--unit " + unit + " and --medium: expected mm, in which the measured media are");
}

void finish(const char *tool_name, const Text &text, Arguments &arguments) {
  check_files(tool_name, arguments);
  TynSlabOptions &options = arguments.options;
  const std::string index = "a refractive index from 1 to 4";
  if (!text.ior_above.empty())
    arguments.ior_above = number_between("--ior-above", text.ior_above, 1.0, 4.0, index);
  if (!text.ior_below.empty())
    arguments.ior_below = number_between("--ior-below", text.ior_below, 1.0, 4.0, index);
  parse_incidence(text.incidence, options);
  parse_beam(text.beam, options);
  read_run(text, options);
  read_results(text, options);
  check_radial_angular(text, options);
  read_layers(text.layers, arguments);
  check_sums(arguments.layers);
  read_sweep(text.sweep, arguments);
  check_ends(arguments);
  check_unit(arguments);
  if (arguments.exact && options.max_order)
    throw Error(kUsage, "--exact and --max-order " + text.max_order +
                            ": expected one or the other, as adding-doubling has all orders at once");
}

} // namespace

bool parse_arguments(const char *tool_name, int argc, char **argv, Arguments &arguments) {
  CLI::App app(kAbout);
  Text text;
  add_layer_options(app, text.layers);
  add_phase_option(app, text.layers);
  add_light_options(app, text);
  add_run_options(app, text);
  add_result_options(app, text, arguments);
  add_output_options(app, arguments);
  if (!tool::parse_or_answer(app, tool_name, argc, argv))
    return false;
  finish(tool_name, text, arguments);
  return true;
}

} // namespace slab
