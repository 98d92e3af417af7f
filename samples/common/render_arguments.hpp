// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
//
// The command line of tyndall-render, checked as far as it can be without a scene.
#pragma once

#include "common/loading.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace tool {

// --env constant:R,G,B or FILE.exr.
struct EnvironmentArgument {
  bool given = false;
  float radiance[3] = {1.0f, 1.0f, 1.0f};
  std::string file; // empty: constant
};

struct RenderArguments {
  std::string scene;
  std::string exr;
  std::string png;    // empty: none
  uint32_t width = 0; // 0: by the camera
  uint32_t height = 0;
  uint32_t samples = 0; // 0: no limit
  double target_error = 0.0;
  double time_limit = 0.0;
  uint64_t seed = 0;
  std::string camera;
  EnvironmentArgument environment;
  double environment_rotation = 0.0; // degrees
  bool no_lights = false;
  std::vector<MediumArgument> media;
  uint32_t max_bounces = 0;
  uint32_t exit = 0;     // TYN_EXIT_*
  uint32_t bssrdf = 0;   // TYN_BSSRDF_*, or TYN_NONE: walks
  double exposure = 0.0; // stops
  uint32_t tone = 0;     // TYN_TONE_*
  std::string device;
  bool json = false;
  bool quiet = false;
  bool verbose = false;
};

// Fills `arguments`; false if --help or --version was all that was asked for, and has been printed.
bool parse_render_arguments(const char *tool_name, int argc, char **argv, RenderArguments &arguments);

} // namespace tool
