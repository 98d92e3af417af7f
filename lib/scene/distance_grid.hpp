// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Grids that say how far flights are clear of a mesh's surface, for kernels/distance_bound.clh: a flight that is shorter needs
// no ray.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/scene.hpp"

namespace tyn {

// Fills in the grids' fields of the records, whose bounds and slack are there, and returns the cells of all grids one after
// the other. Meshes that hold a medium have cells of about its mean free path, within limits; closed ones without, which an
// entry may give a medium of its own, coarser ones; open ones without a medium none (walks through them trace every flight).
// Scenes of many meshes get coarser grids, so that all of them stay below 32 MB and `most_bytes`.
std::vector<uint32_t> build_distance_grids(const std::vector<Mesh> &meshes, const std::vector<TynMediumRecord> &media,
                                           std::vector<TynMeshRecord> &records, uint64_t most_bytes = UINT64_MAX);

} // namespace tyn
