// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/textures.hpp"

namespace tyn {

// The kernel's record of a material that has been checked; its textures are added to `textures`.
TynMaterialRecord material_record(const TynMaterial &material, TextureTable &textures);

// What the renderer keeps of a medium beyond TynMediumRecord.
TynRenderMedium render_medium(const TynMediumRecord &medium);

} // namespace tyn
