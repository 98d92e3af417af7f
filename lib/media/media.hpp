// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tyndall/tyndall.h"

namespace tyn {

// Throws INVALID_ARGUMENT with the field, its value and what is allowed.
void validate(const TynMedium &medium);

} // namespace tyn
