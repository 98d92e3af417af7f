// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kernels/shared_render.h"
#include "tyndall/tyndall.h"

namespace tyn {

// The kernel's record of a camera that has been checked, for a film of width x height pixels.
TynCameraRecord camera_record(const TynCamera &camera, uint32_t width, uint32_t height);

} // namespace tyn
