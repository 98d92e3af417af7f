// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
//
// --phase.
#pragma once

#include "slab/arguments.hpp"

namespace slab {

// hg, isotropic, rayleigh, two-lobe:G1,G2,WEIGHT, draine:G,ALPHA or mie:SIZE,N,K. Throws on wrong usage.
PhaseArgument parse_phase(const std::string &text);

} // namespace slab
