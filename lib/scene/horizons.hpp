// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// How high the surface around a triangle rises into the mesh: a flight that starts on the triangle and is steeper is clear.
#pragma once

#include <vector>

#include "scene/bvh.hpp"

namespace tyn {

// Fills in TynTriangleRecord::horizon of the triangles of meshes that have a distance grid, and TynMeshRecord::horizon_reach.
void find_horizons(const std::vector<Mesh> &meshes, const Bvh &bvh, std::vector<TynMeshRecord> &records,
                   std::vector<TynTriangleRecord> &triangles);

} // namespace tyn
