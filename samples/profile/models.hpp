// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
//
// The models of a layer.
#pragma once

#include "profile/results.hpp"

namespace profile {

// Evaluates the models that are asked for at the radii and, if there are rings, over them. Models that do not take this layer
// are left out of `all`, and wrong usage where they are named.
std::vector<ModelResults> evaluate_models(const char *tool_name, TynContext *context, const TynSlab &slab,
                                          const Arguments &arguments, const Rings *rings);

} // namespace profile
