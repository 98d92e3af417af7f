// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "common/render_arguments.hpp"

#include "common/help.hpp"
#include "common/outputs.hpp"

#include <tyndall/tyndall_io.h>

#include <charconv>
#include <cmath>
#include <optional>

namespace tool {
namespace {

constexpr uint32_t kMaxSize = 32768;
constexpr uint32_t kDefaultSamples = 64;
constexpr double kMaxExposure = 100.0;

const char *const kAbout =
    R"(Renders a glTF model to OpenEXR, with light walked through the inside of its materials.

  tyndall-render SCENE -o OUT.exr [options]

Examples:
  tyndall-render head.glb -o head.exr --png head.png --medium skin1
      a model without scattering turned into skin, and a picture to look at
  tyndall-render bust.glb -o bust.exr --medium Body=marble --env constant:0.8,0.9,1 --spp 256
      one material as marble, under an even sky
  tyndall-render scene.glb -o scene.exr --target-error 0.01 --time-limit 600
      until the error is 1 %, ten minutes at most
  tyndall-render scene.glb -o scene.exr --json -q | jq .ledger
      where the light went

Lengths in the file are metres; radiance is linear Rec.709. Ctrl-C finishes the pass and writes what
is done; pressed again it kills.
Exit status: 0 done, 1 failed, 2 wrong usage, 3 bad input file, 4 no device or kernel build failed,
130 interrupted (the image is written).
)";

// "1.5" with a point whatever the locale; false unless all of `text` is a finite number.
bool parse_number(const std::string &text, float &value) {
  const char *end = text.data() + text.size();
  const std::from_chars_result result = std::from_chars(text.data(), end, value);
  return result.ec == std::errc() && result.ptr == end && std::isfinite(value);
}

bool parse_radiance(const std::string &text, float (&radiance)[3]) {
  size_t begin = 0;
  for (int i = 0; i < 3; ++i) {
    const size_t comma = text.find(',', begin);
    const bool last = comma == std::string::npos;
    if (last != (i == 2))
      return false;
    if (!parse_number(text.substr(begin, comma - begin), radiance[i]) || radiance[i] < 0.0f)
      return false;
    begin = comma + 1;
  }
  return true;
}

EnvironmentArgument parse_environment(const std::string &text) {
  EnvironmentArgument environment;
  if (text.empty())
    return environment;
  environment.given = true;
  const std::string prefix = "constant:";
  if (text.compare(0, prefix.size(), prefix) != 0)
    environment.file = text;
  else if (!parse_radiance(text.substr(prefix.size()), environment.radiance))
    throw Error(kUsage, "--env " + text + ": expected constant:R,G,B with numbers from 0 up");
  return environment;
}

void check_outputs(const RenderArguments &arguments) {
  check_distinct(arguments.exr, arguments.scene);
  check_distinct(arguments.png, arguments.scene);
  check_distinct(arguments.png, arguments.exr);
  if (!has_extension(arguments.exr, ".exr"))
    throw Error(kUsage, "-o " + arguments.exr +
                            ": the image is OpenEXR, so its name ends in .exr "
                            "(--png writes a PNG beside it)");
  if (!arguments.png.empty() && !has_extension(arguments.png, ".png"))
    throw Error(kUsage, "--png " + arguments.png + ": its name must end in .png");
}

void check_number(const char *option, double value, double lowest, const char *allowed) {
  if (!std::isfinite(value) || value < lowest)
    throw Error(kUsage, std::string(option) + ": expected " + allowed);
}

// A model by name; all but the one whose profile a medium does not give.
uint32_t parse_bssrdf(const std::string &name) {
  const uint32_t model = tyn_bssrdf_find_model(name.c_str());
  if (model != TYN_BSSRDF_MODEL_COUNT && model != TYN_BSSRDF_GAUSSIANS)
    return model;
  std::string names;
  for (uint32_t i = 0; i < TYN_BSSRDF_MODEL_COUNT; ++i)
    if (i != TYN_BSSRDF_GAUSSIANS)
      names += (names.empty() ? "" : ", ") + std::string(tyn_bssrdf_model_name(i));
  throw Error(kUsage, "--bssrdf " + name + ": expected one of " + names);
}

// The strings that need more than CLI11's own conversions.
struct RawArguments {
  std::string environment;
  std::vector<std::string> media;
  std::string exit = "diffuse";
  std::optional<std::string> bssrdf;
  std::string tone = "srgb";
  uint32_t max_bounces = tyn_render_options().max_bounces;
};

void add_image_options(CLI::App &app, RenderArguments &arguments, RawArguments &raw) {
  const CLI::Range size(1u, kMaxSize);
  app.add_option("-o,--output", arguments.exr, "OpenEXR image, all layers (required)")
      ->type_name("OUT.exr")
      ->required();
  app.add_option("--png", arguments.png, "also write a PNG preview of the beauty")->type_name("OUT.png");
  app.add_option("--width", arguments.width, "pixels, 1 to 32768 (640, or by --height)")->type_name("N")->check(size);
  app.add_option("--height", arguments.height, "pixels, 1 to 32768 (by the camera's shape)")
      ->type_name("N")
      ->check(size);
  app.add_option("--exposure", arguments.exposure, "brightness of the PNG, -100 to 100 (0)")->type_name("STOPS");
  app.add_option("--tone", raw.tone, "tone curve of the PNG: srgb clamps, aces rolls off (srgb)")
      ->type_name("NAME")
      ->check(CLI::IsMember({"srgb", "aces"}));
}

void add_scene_options(CLI::App &app, RenderArguments &arguments, RawArguments &raw) {
  app.add_option("--camera", arguments.camera, "camera of the file, from 0 (0; else framed)")->type_name("NAME|INDEX");
  app.add_option("--env", raw.environment, "light from all around: constant:R,G,B or FILE.exr")->type_name("LIGHT");
  app.add_option("--env-rotation", arguments.environment_rotation, "turn it about the vertical, counter-clockwise (0)")
      ->type_name("DEGREES");
  app.add_flag("--no-lights", arguments.no_lights, "leave out the file's punctual lights");
  app.add_option("--medium", raw.media,
                 "fill what is not metal, or one material, with a\nmeasured medium (repeatable; "
                 "tyndall-info --media)")
      ->type_name("NAME|MATERIAL=NAME")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void add_quality_options(CLI::App &app, RenderArguments &arguments, RawArguments &raw) {
  app.add_option("--spp", arguments.samples, "samples a pixel (64, or without limit if one of the\nnext two is given)")
      ->type_name("N")
      ->check(CLI::Range(1u, 1u << 24));
  app.add_option("--target-error", arguments.target_error, "stop at this mean relative error: 0.01 is 1 %")
      ->type_name("FRACTION");
  app.add_option("--time-limit", arguments.time_limit, "stop rendering after this time; 0: no limit")
      ->type_name("SECONDS");
  app.add_option("--seed", arguments.seed, "same seed, same bits on the same device (0)")
      ->type_name("N")
      ->check(CLI::NonNegativeNumber);
  app.add_option("--max-bounces", raw.max_bounces, "surface interactions of a path, from 1 (64)")
      ->type_name("N")
      ->check(CLI::Range(1u, 1u << 20));
  app.add_option("--exit", raw.exit,
                 "how light leaves a medium: diffuse (little noise) or\ndielectric (exact, more "
                 "noise) (diffuse)")
      ->type_name("MODEL")
      ->check(CLI::IsMember({"diffuse", "dielectric"}));
  app.add_option("--bssrdf", raw.bssrdf,
                 "a model in place of walks, approximate, for flat\nsurfaces; any other word lists them")
      ->type_name("MODEL");
}

void add_general_options(CLI::App &app, RenderArguments &arguments) {
  app.add_option("--device", arguments.device, "OpenCL device (TYNDALL_DEVICE, else 0; tyndall-info --devices)")
      ->type_name("INDEX|NAME");
  app.add_flag("--json", arguments.json, "one JSON object on standard output, and nothing else");
  CLI::Option *quiet = app.add_flag("-q,--quiet", arguments.quiet, "errors only");
  app.add_flag("-v,--verbose", arguments.verbose, "say what is being done")->excludes(quiet);
}

void finish_arguments(const RawArguments &raw, RenderArguments &arguments) {
  check_outputs(arguments);
  check_number("--target-error", arguments.target_error, 0.0, "a fraction from 0 up");
  check_number("--time-limit", arguments.time_limit, 0.0, "seconds from 0 up");
  if (!(std::abs(arguments.exposure) <= kMaxExposure))
    throw Error(kUsage, "--exposure: expected -100 to 100 stops");
  check_number("--env-rotation", arguments.environment_rotation, -1e6, "an angle in degrees");
  const bool has_other_limit = arguments.target_error > 0.0 || arguments.time_limit > 0.0;
  if (!arguments.samples && !has_other_limit)
    arguments.samples = kDefaultSamples;
  arguments.environment = parse_environment(raw.environment);
  arguments.media = parse_media(raw.media);
  arguments.max_bounces = raw.max_bounces;
  arguments.exit = raw.exit == "dielectric" ? TYN_EXIT_DIELECTRIC : TYN_EXIT_DIFFUSE;
  arguments.bssrdf = raw.bssrdf ? parse_bssrdf(*raw.bssrdf) : uint32_t(TYN_NONE);
  if (arguments.bssrdf != TYN_NONE && arguments.exit == TYN_EXIT_DIELECTRIC)
    throw Error(kUsage, "--bssrdf and --exit dielectric: a model gives no direction for light to leave along");
  arguments.tone = raw.tone == "aces" ? TYN_TONE_ACES : TYN_TONE_SRGB;
}

} // namespace

bool parse_render_arguments(const char *tool_name, int argc, char **argv, RenderArguments &arguments) {
  CLI::App app(kAbout);
  RawArguments raw;
  app.add_option("SCENE", arguments.scene, "glTF 2.0 model, .gltf or .glb")->required();
  add_image_options(app, arguments, raw);
  add_scene_options(app, arguments, raw);
  add_quality_options(app, arguments, raw);
  add_general_options(app, arguments);
  if (!parse_or_answer(app, tool_name, argc, argv))
    return false;
  finish_arguments(raw, arguments);
  return true;
}

} // namespace tool
