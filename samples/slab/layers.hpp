// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
//
// The layers that a command line asks for.
#pragma once

#include "slab/arguments.hpp"

namespace slab {

// What was given for layers, as text; empty: not given.
struct LayerText {
  std::string sigma_a, sigma_s, g, ior, thickness, medium, phase;
  std::vector<std::string> layers; // --layer
};

// Sets the layers, their phase function and is_rgb. Throws on wrong usage.
void read_layers(const LayerText &text, Arguments &arguments);

} // namespace slab
