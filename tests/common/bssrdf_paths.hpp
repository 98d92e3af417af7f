// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Paths for tyn_bssrdf_evaluate, and what of their light a flat surface lets through.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tyndall/tyndall_types.h"

namespace tyn_test {

// The part of unpolarized light that gets through a surface at the angle with this cosine, into a medium of the relative index
// `ior`: Fresnel's equations with Snell's angles (Born & Wolf 1999, section 1.5.2).
double transmittance(double cosine, double ior);

// On the plane z = 0 at the distance r along x: light that arrives at the angle `entry` from the normal and leaves at the angle
// `exit`, both towards +x, in radians.
TynBssrdfPath plane_path(double r, double entry = 0, double exit = 0);

// Offsets of any direction and of lengths between `nearest` and `farthest`, equally often in each decade; normals of any
// direction; directions on the right sides, equally often in each solid angle. Fixed by the seed.
std::vector<TynBssrdfPath> random_paths(size_t count, uint64_t seed, double nearest, double farthest);

// With the light going the other way.
TynBssrdfPath reversed(const TynBssrdfPath &path);

} // namespace tyn_test
