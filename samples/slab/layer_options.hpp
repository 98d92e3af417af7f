// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
//
// The options that describe layers, for every tool that takes them.
#pragma once

#include "slab/layers.hpp"

namespace CLI {
class App;
}

namespace slab {

// All but --phase, which only some tools take.
void add_layer_options(CLI::App &app, LayerText &text);
void add_phase_option(CLI::App &app, LayerText &text);

} // namespace slab
