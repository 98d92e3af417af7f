// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
//
// The models of a layer.
#pragma once

#include "profile/results.hpp"

namespace profile {

// Evaluates the models that are asked for at the radii and, if there are rings, over them. Models that do not take this layer
// are wrong usage where they are named; of `all` they are left out, which is said on standard error, unless none is left. Sets
// `interrupted` and `missing` if the user has had enough.
void evaluate_models(const char *tool_name, TynContext *context, const TynSlab &slab, const Arguments &arguments,
                     const Rings *rings, Results &results);

} // namespace profile
