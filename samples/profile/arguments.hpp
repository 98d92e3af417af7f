// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
//
// The command line of tyndall-profile, checked as far as it can be without a device.
#pragma once

#include "slab/arguments.hpp"

#include <tyndall/tyndall_bssrdf.h>

namespace profile {

// Layers, given as tyndall-slab's, and what is asked of them. Of the options of a run, photons and seed are used.
struct Arguments : slab::Arguments {
  std::vector<uint32_t> models; // TYN_BSSRDF_*
  bool all_models = false;      // those of them that take these layers
  uint32_t fit = TYN_NORMALIZED_SEARCHLIGHT;
  bool fit_given = false;
  bool transmitted = false;
  std::vector<double> gaussian_weights, gaussian_variances; // of one channel; empty: not given
  std::vector<double> radii;
  bool compare = false; // --error

  const slab::LayerArgument &top() const { return layers.front(); }
  bool is_half_space() const { return std::isinf(layers.back().thickness); }
  size_t channels() const { return top().sigma_a.size(); }
};

// Fills `arguments`; false if --help or --version was all that was asked for, and has been printed.
bool parse_arguments(const char *tool_name, int argc, char **argv, Arguments &arguments);

// The names of all models, separated by commas.
std::string model_names();

} // namespace profile
