// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
//
// The command line of tyndall-slab, checked as far as it can be without a device.
#pragma once

#include <tyndall/tyndall_exact.h>

#include <cmath>
#include <string>
#include <vector>

namespace slab {

struct LayerArgument {
  std::vector<double> sigma_a, sigma_s; // one a channel
  double g = 0.0;
  double ior = 1.0;
  double thickness = HUGE_VAL;
};

// A phase function and, if it is tabulated, its table: whoever uses both points the one to the other.
struct PhaseArgument {
  bool given = false; // false: Henyey-Greenstein with the layer's g
  TynPhase phase = tyn_phase();
  std::vector<double> cosines, values;
  std::string text; // as it was given
};

struct Arguments {
  std::vector<LayerArgument> layers; // from the top
  bool is_stack = false;             // given by --layer
  PhaseArgument phase;               // of the only layer
  std::string medium;                // preset that the only layer is; empty: none
  bool is_rgb = false;               // three channels that are red, green and blue
  std::string unit = "mm";           // of length, for labels
  double ior_above = 1.0;
  double ior_below = 1.0;
  TynSlabOptions options = tyn_slab_options(); // without its sweep and its progress
  std::vector<double> sweep;                   // albedos; empty: none
  bool exact = false;
  std::string csv;  // empty: none
  std::string plot; // empty: none
  std::string device;
  bool json = false;
  bool quiet = false;
};

// Fills `arguments`; false if --help or --version was all that was asked for, and has been printed.
bool parse_arguments(const char *tool_name, int argc, char **argv, Arguments &arguments);

} // namespace slab
