// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/scene.hpp"

namespace tyn {

// Extinction and single-scattering albedo per channel; the albedo of a channel without extinction is 0.
// Its `phase` is left to commit.
TynMediumRecord medium_record(const TynMedium &medium);

} // namespace tyn
