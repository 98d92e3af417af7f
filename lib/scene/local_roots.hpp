// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Short cuts into a mesh's tree for short rays: a grid whose cells have a root of their own, over what the tree holds near
// them.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/bvh.hpp"

namespace tyn {

// Fills in the local roots' fields of the records, adds the roots to the tree's nodes, and appends the grids to `cells`.
// Cells hold some 12 triangles, and a root what is within half a cell of its own. Meshes without a distance grid, and all
// that find no place in `most_bytes`, get one large cell, whose root is the mesh's own.
void add_local_roots(Bvh &bvh, std::vector<TynMeshRecord> &records, std::vector<uint32_t> &cells,
                     uint64_t most_bytes = UINT64_MAX);

} // namespace tyn
