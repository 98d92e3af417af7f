// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
//
// Exact transport in the layers, by following photons, and what the models are off it.
#pragma once

#include "profile/results.hpp"

namespace profile {

// Fills `results.exact` and the deviations of its models; sets `interrupted` if the user has had enough.
void compare_with_exact(const char *tool_name, TynContext *context, const TynSlab &slab, const Arguments &arguments,
                        const Rings &rings, Results &results);

} // namespace profile
