// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// How far the centres of a grid's cells are from a mesh's surface.
#pragma once

#include <vector>

#include "scene/scene.hpp"

namespace tyn {

constexpr float SURFACE_DISTANCES_EXACT = 1.5f; // cells

// Squared distances, in cells, from the centres of the cells of the record's grid to the surface or to the bounds, whichever
// is nearer: exact up to SURFACE_DISTANCES_EXACT, else at most what they are.
std::vector<float> squared_surface_distances(const Mesh &mesh, const TynMeshRecord &record);

} // namespace tyn
