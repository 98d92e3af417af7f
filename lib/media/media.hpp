// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "tyndall/tyndall.h"

namespace tyn {

// Before it had a phase function.
constexpr size_t first_medium_size = offsetof(TynMedium, phase);

// A caller's medium in today's size, checked. Its pointers are the caller's.
TynMedium read_medium(const TynMedium *given);

// Throws INVALID_ARGUMENT with the field, its value and what is allowed.
void validate(const TynMedium &medium);

} // namespace tyn
