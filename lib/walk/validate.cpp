// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "core/argument.hpp"
#include "core/input.hpp"
#include "walk/walk.hpp"

namespace tyn {

namespace {

void validate_medium(const TynScene &scene, const TynWalkEntry &entry) {
  if (entry.medium != TYN_NONE) {
    require_index("medium", entry.medium, scene.medium_records.size(), "media");
  } else if (scene.mesh_records[entry.mesh].medium == TYN_NONE) {
    fail(TYN_ERROR_INVALID_ARGUMENT, "mesh %u has no medium, and the entry names none", entry.mesh);
  }
  if (!(entry.albedo[0] < 0))
    require_each(require_between, "albedo", entry.albedo, 0.0, 1.0);
  if (!(entry.sigma_t[0] < 0))
    require_each(require_not_negative, "sigma_t", entry.sigma_t);
}

void validate_entry(const TynScene &scene, const TynWalkEntry &entry) {
  require_choice("kind", entry.kind, 3);
  require_each(require_finite, "position", entry.position);
  if (entry.kind != TYN_ENTRY_COSINE)
    require_unit("direction", entry.direction);
  require_each(require_not_negative, "weight", entry.weight);
  require_index("mesh", entry.mesh, scene.mesh_records.size(), "meshes");
  bool interior = entry.kind == TYN_ENTRY_INSIDE && entry.triangle == TYN_NONE;
  if (!interior)
    require_index("triangle", entry.triangle, scene.mesh_records[entry.mesh].triangle_count, "triangles in that mesh");
  require_between("roughness", entry.roughness, 0.0, 1.0);
  if (entry.reserved != 0 || entry.reserved2 != 0)
    fail(TYN_ERROR_INVALID_ARGUMENT, "reserved fields are %u and %u; they must be 0", entry.reserved, entry.reserved2);
  validate_medium(scene, entry);
}

} // namespace

TynWalkOptions checked_options(const TynWalkOptions *options) {
  if (!options)
    return tyn_walk_options();
  TynWalkOptions checked = read_struct("TynWalkOptions", options, tyn_walk_options());
  if (!(checked.roulette_threshold > 0 && checked.roulette_threshold <= 1))
    fail(TYN_ERROR_INVALID_ARGUMENT, "roulette_threshold is %g; it must be in (0, 1]", checked.roulette_threshold);
  return checked;
}

void validate_entries(const TynScene &scene, const TynWalkEntry *entries, size_t count) {
  for (size_t i = 0; i < count; ++i) {
    try {
      validate_entry(scene, entries[i]);
    } catch (const Failure &failure) {
      fail(failure.status, "entry %zu: %s", i, failure.what());
    }
  }
}

} // namespace tyn
