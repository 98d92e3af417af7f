// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// From the caller's arrays to a mesh of our own.
#pragma once

#include "scene/scene.hpp"

namespace tyn {

// A checked and oriented copy of `given`, for `scene`. Throws INVALID_ARGUMENT with the element that is wrong.
Mesh read_mesh(const TynMesh &given, const TynScene &scene);

} // namespace tyn
