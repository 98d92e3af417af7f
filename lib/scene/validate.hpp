// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Checks of the public structs. Each throws INVALID_ARGUMENT with the field, its value and what is allowed.
#pragma once

#include <vector>

#include "media/media.hpp" // validate(const TynMedium &)
#include "scene/scene.hpp"

namespace tyn {

void validate(const TynImage &image);
void validate(const TynMaterial &material, size_t image_count);
void validate(const TynLight &light);
void validate(const TynCamera &camera);
void validate(const TynEnvironment &environment, const std::vector<Image> &images);

// Bytes of one pixel of a valid format.
size_t bytes_per_pixel(uint32_t format);

} // namespace tyn
