// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Random walks inside the meshes of a committed scene: what the public calls and the renderer share.
#pragma once

#include "kernels/shared.h"
#include "scene/scene.hpp"

namespace tyn {

// The kernel's parameters for entries of `scene`, from options that have been checked. The number of entries and what
// the caller's winding means are set by whoever enqueues them.
TynWalkParameters walk_parameters(const TynScene &scene, const TynWalkOptions &options);

// Enqueues walks for parameters.count entries. Does not wait. The buffers hold as many TynWalkEntry, TynWalkExit, TynWalkTally.
void enqueue_walk(TynScene &scene, TynWalkParameters parameters, cl_mem entries, cl_mem exits, cl_mem tallies);

// A copy of the options with the defaults for what the caller left out. Throws INVALID_ARGUMENT.
TynWalkOptions checked_options(const TynWalkOptions *options);

// Throws INVALID_ARGUMENT naming the entry and field that is wrong.
void validate_entries(const TynScene &scene, const TynWalkEntry *entries, size_t count);

// Adds `count` walks to a ledger, in their order and in double precision, so that it depends on nothing but the walks.
void add_to_ledger(TynLedger &ledger, const TynWalkEntry *entries, const TynWalkExit *exits,
                   const TynWalkTally *tallies, size_t count);

} // namespace tyn
