// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "slab/results.hpp"

namespace slab {

// Follows photons, with progress on standard error, until a limit is reached or the user has had enough; there is always a
// result, of one batch at least. Does not return if the run fails.
void simulate(const char *tool_name, TynContext *context, const TynSlab &slab, TynSlabOptions options,
              const Arguments &arguments, Results &results);

} // namespace slab
