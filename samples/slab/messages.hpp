// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
//
// What the library says of layers, in the words of the command line.
#pragma once

#include "slab/arguments.hpp"

namespace slab {

// layers[0].thickness is --thickness, or that of --layer 1; INFINITY is inf.
std::string in_options(const std::string &message, const Arguments &arguments);

} // namespace slab
