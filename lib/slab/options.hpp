// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "slab/validate.hpp"

namespace tyn {

// The options in today's size, checked by themselves and against the slab. Throws INVALID_ARGUMENT with the field, its value
// and what is allowed.
TynSlabOptions read_slab_options(const TynSlabOptions *options, const Slab &slab);

} // namespace tyn
