// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "profile/arguments.hpp"

#include "common/help.hpp"
#include "profile/radii.hpp"
#include "slab/files.hpp"
#include "slab/layer_options.hpp"
#include "slab/parse.hpp"

#include <algorithm>
#include <utility>

namespace profile {
namespace {

using slab::split;
using slab::wrong;
using tool::Error;
using tool::kUsage;

constexpr uint64_t kMostPhotons = 1000000000000000;
constexpr size_t kMostGaussians = 64;

const char *const kAbout =
    R"(Profiles of BSSRDF models: R(r), the light that leaves at a distance r from where light gets in, and the
albedo, of every model of a medium side by side; on request their error against exact transport.

  tyndall-profile --sigma-a A --sigma-s S [--g G] [--ior N] [--thickness D] [options]
  tyndall-profile --layer A,S,G,N,D [--layer ...] [options]
  tyndall-profile --medium NAME [--thickness D] [options]

Examples:
  tyndall-profile --medium marble
      all models of marble in red, green and blue, as a table
  tyndall-profile --sigma-a 0.01 --sigma-s 10 --g 0.9 --ior 1.4 --error --plot milk.png
      beside exact transport, with the deviation of each model
  tyndall-profile --model standard-dipole,multipole --sigma-a 0.01 --sigma-s 1 --radii 0.1:10:5
      two models at five radii
  tyndall-profile --model multipole --transmitted --sigma-a 0.01 --sigma-s 1 --thickness 5 --json
      what goes through a slab
  tyndall-profile --model multipole --layer 0.2,50,0.8,1.4,0.5 --layer 0.02,20,0.8,1.4,inf --error
      a layer on another one, beside exact transport
  tyndall-profile --model gaussians --gaussians 0.3:0.05,0.2:0.4 --sigma-a 0.1 --sigma-s 1
      a sum of Gaussians, for which the medium does not matter

Models: standard-dipole, better-dipole, photon-beam-diffusion, multipole, normalized-diffusion, gaussians,
single-scattering, quantized-diffusion, directional-dipole, exact. Slabs of finite thickness: multipole,
gaussians, single-scattering. Several layers: multipole, if each is thicker than a reduced mean free path.
exact takes mean cosines up to 0.999. Light arrives perpendicularly from air. R(r) and the albedo are per power
that gets in: what the surface reflects is apart.

Units: any one unit of length, by convention mm; coefficients in its inverse, R(r) in 1/mm^2. Lists give one
value a spectral channel: --sigma-a 0.03,0.17,0.48. In --json a profile is a list of channels, each a list
over `radii`, also where there is one channel.
--error follows photons through the same layers and counts them in rings around the radii. A model's deviation
is that of its mean over the ring, model / exact - 1; where the exact value is not known to 30 % there is none
(null in --json, - in the table). The numbers behind +- are standard errors. Ctrl-C ends the run and writes
what is done; pressed again it kills.
Exit status: 0 done, 1 failed, 2 wrong usage, 3 an output file cannot be written, 4 no device or kernel
build failed, 130 interrupted (the outputs are written).
)";

// Options as text: numbers are read here, not by CLI11, so that 1e7 photons and inf mean what they say.
struct Text {
  slab::LayerText layers;
  std::string models = "all", fit, gaussians, radii, photons, seed;
};

void add_model_options(CLI::App &app, Text &text, Arguments &arguments) {
  app.add_option("--model", text.models,
                 "models, or all that take the layers (all); gaussians\nis one of all if --gaussians is given")
      ->type_name("NAME[,NAME...]|all");
  app.add_option("--radii", text.radii,
                 "N radii in equal ratios, MIN > 0 (0.01 to 20 of the\nlongest reduced mean free path, 60 radii)")
      ->type_name("MIN::MAX::N");
  app.add_option("--fit", text.fit,
                 "normalized-diffusion: what its fit was made for,\nsearchlight, diffuse or dmfp (searchlight)")
      ->type_name("KIND");
  app.add_option("--gaussians", text.gaussians,
                 "gaussians: weights, which add up to the albedo, and\nvariances, length^2; the same in each channel")
      ->type_name("W::V[,W::V...]");
  app.add_flag("--transmitted", arguments.transmitted, "multipole: what leaves below a slab");
}

void add_run_options(CLI::App &app, Text &text, Arguments &arguments) {
  app.add_flag("--error", arguments.compare, "compare with exact transport");
  app.add_option("--photons", text.photons, "photons a channel for --error, such as 1e7 (1e6)")->type_name("N");
  app.add_option("--seed", text.seed, "same seed, same bits on the same device (0)")->type_name("N");
}

void add_output_options(CLI::App &app, Arguments &arguments) {
  app.add_flag("--json", arguments.json, "one JSON object on standard output, and nothing else");
  app.add_option("--csv", arguments.csv, "write the profiles as a table, one value a row")->type_name("FILE");
  app.add_option("--plot", arguments.plot, "draw the profiles")->type_name("FILE.png");
  app.add_option("--device", arguments.device, "OpenCL device (TYNDALL_DEVICE, else 0; tyndall-info --devices)")
      ->type_name("INDEX|NAME");
  app.add_flag("-q,--quiet", arguments.quiet, "errors only");
}

bool has(const Arguments &arguments, uint32_t model) {
  return std::find(arguments.models.begin(), arguments.models.end(), model) != arguments.models.end();
}

void read_models(const Text &text, Arguments &arguments) {
  arguments.all_models = text.models == "all";
  if (arguments.all_models) {
    for (uint32_t model = 0; model < TYN_BSSRDF_MODEL_COUNT; ++model)
      if (arguments.transmitted ? model == TYN_BSSRDF_MULTIPOLE
                                : model != TYN_BSSRDF_GAUSSIANS || !text.gaussians.empty())
        arguments.models.push_back(model);
    return;
  }
  for (const std::string &name : split(text.models, ',')) {
    const uint32_t model = tyn_bssrdf_find_model(name.c_str());
    if (model == TYN_BSSRDF_MODEL_COUNT)
      wrong("--model", name, "all, or of " + model_names());
    if (has(arguments, model))
      throw Error(kUsage, "--model " + text.models + ": " + name + " is there twice");
    arguments.models.push_back(model);
  }
}

void read_fit(const Text &text, Arguments &arguments) {
  if (text.fit.empty())
    return;
  const std::vector<std::string> fits = {"searchlight", "diffuse", "dmfp"}; // TYN_NORMALIZED_*
  const auto found = std::find(fits.begin(), fits.end(), text.fit);
  if (found == fits.end())
    wrong("--fit", text.fit, "searchlight, diffuse or dmfp");
  if (!has(arguments, TYN_BSSRDF_NORMALIZED_DIFFUSION))
    throw Error(kUsage, "--fit " + text.fit + ": expected --model normalized-diffusion beside it");
  arguments.fit = static_cast<uint32_t>(found - fits.begin());
  arguments.fit_given = true;
}

void read_gaussians(const Text &text, Arguments &arguments) {
  const std::string expected = "1 to 64 of WEIGHT:VARIANCE, weights >= 0 that add up to at most 1, variances > 0";
  const bool wanted = has(arguments, TYN_BSSRDF_GAUSSIANS);
  if (wanted && text.gaussians.empty())
    throw Error(kUsage, "--model gaussians: expected --gaussians W:V[,W:V...] beside it, which a medium does not give");
  if (text.gaussians.empty())
    return;
  if (!wanted)
    throw Error(kUsage, "--gaussians " + text.gaussians + ": expected --model gaussians beside it");
  double sum = 0.0;
  for (const std::string &pair : split(text.gaussians, ',')) {
    const std::vector<std::string> parts = split(pair, ':');
    double weight = 0.0, variance = 0.0;
    if (parts.size() != 2 || !slab::parse_number(parts[0], weight) || !slab::parse_number(parts[1], variance) ||
        !(weight >= 0.0) || !(variance >= 1e-30 && variance <= 1e30))
      wrong("--gaussians", text.gaussians, expected);
    sum += weight;
    arguments.gaussian_weights.push_back(weight);
    arguments.gaussian_variances.push_back(variance);
  }
  if (!(sum <= 1.0 + 1e-6) || arguments.gaussian_weights.size() > kMostGaussians)
    wrong("--gaussians", text.gaussians, expected);
}

void check_transmitted(const Arguments &arguments) {
  if (!arguments.transmitted)
    return;
  if (arguments.models != std::vector<uint32_t>{TYN_BSSRDF_MULTIPOLE})
    throw Error(kUsage, "--transmitted: expected --model multipole alone, which has it");
  if (arguments.is_half_space())
    throw Error(kUsage, "--transmitted: expected a finite --thickness, as nothing goes through a half-space");
}

void read_run(const Text &text, Arguments &arguments) {
  for (const auto &[option, value] : {std::pair("--photons ", &text.photons), std::pair("--seed ", &text.seed)})
    if (!value->empty() && !arguments.compare)
      throw Error(kUsage, option + *value + ": expected --error beside it, which is what follows photons");
  if (!text.photons.empty())
    arguments.options.photons =
        slab::whole_number("--photons", text.photons, 1, kMostPhotons, "a whole number from 1 to 1e15");
  if (!text.seed.empty())
    arguments.options.seed = slab::parse_seed(text.seed);
  const std::vector<double> &sigma_a = arguments.layers.back().sigma_a;
  const bool absorbs = *std::min_element(sigma_a.begin(), sigma_a.end()) > 0.0;
  if (arguments.compare && arguments.is_half_space() && !absorbs)
    throw Error(kUsage, "--error and --sigma-a 0 in a half-space: its walks would not end; expected absorption or a "
                        "--thickness");
}

void finish(const char *tool_name, const Text &text, Arguments &arguments) {
  slab::check_files(tool_name, arguments);
  read_models(text, arguments);
  read_fit(text, arguments);
  read_gaussians(text, arguments);
  slab::read_layers(text.layers, arguments);
  check_transmitted(arguments);
  read_run(text, arguments);
  arguments.radii = text.radii.empty() ? default_radii(arguments.layers) : parse_radii(text.radii);
}

} // namespace

bool parse_arguments(const char *tool_name, int argc, char **argv, Arguments &arguments) {
  CLI::App app(kAbout);
  Text text;
  slab::add_layer_options(app, text.layers);
  add_model_options(app, text, arguments);
  add_run_options(app, text, arguments);
  add_output_options(app, arguments);
  if (!tool::parse_or_answer(app, tool_name, argc, argv))
    return false;
  finish(tool_name, text, arguments);
  return true;
}

std::string model_names() {
  std::string names;
  for (uint32_t model = 0; model < TYN_BSSRDF_MODEL_COUNT; ++model)
    names += (model ? ", " : "") + std::string(tyn_bssrdf_model_name(model));
  return names;
}

} // namespace profile
