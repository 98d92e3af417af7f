// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Half-spaces without surface, for kernels/distance_bound.clh: a ball around a cell near the surface is cut by a plane that has
// all of the surface in the ball on its far side, so that flights along the surface and away from it are known to be clear.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/scene.hpp"

namespace tyn {

// The upper 24 bits of a cell (kernels/shared.h) for each cell of the record's grid, 0 in the lower 8; 0 for a cell without a
// plane. `squared`: see surface_distances.hpp; only cells near the surface get a plane. `margin`: what is taken off a plane's
// distance, in cells.
std::vector<uint32_t> surface_planes(const Mesh &mesh, const TynMeshRecord &record, const std::vector<float> &squared,
                                     double margin);

} // namespace tyn
